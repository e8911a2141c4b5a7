#include "demos/picture_name.h"

#include <fmt/format.h>

#include <filesystem>

namespace kinescope {

std::string free_picture_name(std::string_view name) {
  for (int i = 1;; ++i) {
    std::string file = fmt::format("kinescope-{}-{:04}.png", name, i);
    if (!std::filesystem::exists(file)) return file;
  }
}

}  // namespace kinescope
