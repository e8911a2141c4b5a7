#include "demos/film.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <utility>
#include <vector>

#include "demos/machine.h"
#include "demos/numbered_files.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& what) { throw Error(ErrorKind::kUsage, what, "-o"); }

std::string ending_of(const std::string& output) {
  return output == "-" ? std::string() : fs::path(output).extension().string();
}

}  // namespace

FilmFormat film_format(const std::string& output, const std::string& format, bool several_frames) {
  std::string kind = format;
  const std::string ending = ending_of(output);
  if (kind.empty()) {
    if (ending.empty()) kind = several_frames ? "y4m" : "png";
    if (ending == ".png" || ending == ".y4m") kind = ending.substr(1);
  }
  if (kind == "y4m") return FilmFormat::kY4m;
  if (kind == "raw") return FilmFormat::kRaw;
  if (kind != "png") {
    refuse(output + ": cannot tell the format by \"" + ending +
           "\"; use .png or .y4m, or give --format");
  }
  if (several_frames && (output == "-" || output.find('#') == std::string::npos)) {
    refuse(output + ": several frames need a numbered name such as frame_####.png, or a .y4m");
  }
  return FilmFormat::kPng;
}

void check_output(const Options& options, FilmFormat format) {
  if (options.common.json && options.picture.output == "-") {
    throw Error(ErrorKind::kUsage, "standard output cannot hold both a picture and --json", "-o");
  }
  if (options.picture.depth_bits == 16 && format != FilmFormat::kPng) {
    throw Error(ErrorKind::kUsage, "only PNG takes 16 bits a channel", "--depth");
  }
}

void check_writable(const std::string& output) {
  if (output == "-") return;
  const auto fail = [&](const std::string& what) {
    throw Error(ErrorKind::kCannotWrite, what, output);
  };
  std::error_code ignored;
  if (fs::is_directory(output, ignored)) fail("is a folder; name a file in it");
  if (fs::exists(output, ignored) && !fs::is_regular_file(output, ignored)) return;  // a device
  fs::path folder = fs::path(output).parent_path();
  if (folder.empty()) folder = ".";
  if (!fs::is_directory(folder, ignored)) fail("there is no folder " + folder.string());
  if (access(folder.c_str(), W_OK) != 0) fail("cannot write to the folder " + folder.string());
}

std::string output_in_out(const std::string& stem, bool several_frames) {
  const std::string folder = "out";
  std::error_code fault;
  fs::create_directories(folder, fault);
  if (fault) {
    throw Error(ErrorKind::kCannotWrite, "cannot make the folder: " + fault.message(), folder);
  }
  return folder + "/" + stem + (several_frames ? ".y4m" : ".png");
}

void check_memory(Size size, double bytes) {
  // Tiles, bins and rows at work; a tenth was measured from 1024x1024 to 4096x4096.
  constexpr double kWithWork = 1.1;
  constexpr double kGib = 1 << 30;
  const double need = kWithWork * bytes, have = available_memory_bytes();
  if (need < have) return;
  throw Error(ErrorKind::kUsage,
              fmt::format("{}x{} takes about {:.1f} GiB of memory, and {:.1f} GiB are free",
                          size.width, size.height, need / kGib, have / kGib),
              "--size");
}

Film::Film(std::string output, FilmFormat format, Size size, Rate rate)
    : output_(std::move(output)), format_(format) {
  check_writable(output_);
  if (format_ == FilmFormat::kY4m) {
    y4m_ = std::make_unique<Y4mWriter>(output_, size.width, size.height, rate);
  } else if (format_ == FilmFormat::kRaw) {
    raw_ = std::make_unique<OutputFile>(output_);
  }
}

void Film::write(const Image<Srgb8>& picture, int number) {
  switch (format_) {
    case FilmFormat::kPng:
      return write_png(numbered_name(output_, number), picture);
    case FilmFormat::kY4m:
      return y4m_->write(picture);
    case FilmFormat::kRaw:
      return write_raw(picture);
  }
}

void Film::write(const Image<Srgb16>& picture, int number) {
  write_png(numbered_name(output_, number), picture);
}

void Film::write_raw(const Image<Srgb8>& picture) {
  std::vector<std::uint8_t> line(static_cast<std::size_t>(picture.width()) * 3);
  for (int y = 0; y < picture.height(); ++y) {
    auto out = line.begin();
    for (int x = 0; x < picture.width(); ++x) {
      const Srgb8 c = picture.at(x, y);
      for (const std::uint8_t channel : {c.r, c.g, c.b}) *out++ = channel;
    }
    raw_->write(line);
  }
}

void Film::close() {
  if (y4m_) y4m_->close();
  if (raw_) raw_->commit();
}

}  // namespace kinescope
