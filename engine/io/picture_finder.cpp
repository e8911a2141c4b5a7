#include "engine/io/picture_finder.h"

#include <algorithm>
#include <filesystem>

#include "engine/io/text.h"
#include "raster/image/codecs.h"

namespace kinescope {
namespace {

namespace fs = std::filesystem;

bool is_absolute(const std::string& name) {
  const bool has_drive = name.size() > 1 && name[1] == ':';
  return has_drive || name.starts_with('/');
}

}  // namespace

std::optional<std::string> find_beside(const std::string& model_path, const std::string& name) {
  // No file system takes longer names, and a zero would cut the name short.
  if (name.empty() || name.size() > 4096 || name.find('\0') != std::string::npos) return {};
  std::string relative = name;
  std::replace(relative.begin(), relative.end(), '\\', '/');
  const bool outside = is_absolute(relative);
  const fs::path folder = fs::path(model_path).parent_path();
  std::error_code ignored;
  if (!outside) {
    const fs::path path = folder / relative;
    if (fs::is_regular_file(path, ignored)) return path.string();
  }
  const fs::path beside = folder / fs::path(relative).filename();
  if (fs::is_regular_file(beside, ignored)) return beside.string();
  return {};
}

std::optional<Image<Srgb8>> PictureFinder::find(const std::string& name) const {
  const std::optional<std::string> path = find_beside(file_.path, name);
  if (!path) {
    file_.warn("the texture is missing; drawn without it", name.substr(0, 80));
    return {};
  }
  try {
    return read_image_file(*path);
  } catch (const Error& error) {
    file_.warnings.push_back(printable(error.what()) + "; drawn without this texture");
    return {};
  }
}

std::optional<Image<Srgb8>> PictureFinder::decode(std::span<const std::uint8_t> bytes,
                                                  const std::string& name) const {
  try {
    return read_image(bytes, name);
  } catch (const Error& error) {
    file_.warn(std::string(error.what()) + "; drawn without this texture");
    return {};
  }
}

}  // namespace kinescope
