// Video without headers: frames of a known size, one after the other.
#include "raster/base/error.h"
#include "raster/image/video.h"

namespace kinescope {
namespace {

class RawReader : public VideoReader {
 public:
  RawReader(InputFile& file, const VideoFormat& format, Rate rate) : file_(file) {
    format_ = format;
    rate_ = rate;
  }

  bool read(Image<Srgb8>& frame) override {
    bytes_.clear();
    const std::size_t wanted = frame_bytes(format_), got = file_.append_to(bytes_, wanted);
    if (got == 0 && number_ == 0) throw_bad_input("an empty file, not a film", file_.name());
    if (got == 0) return false;
    if (got < wanted) {
      throw_bad_input("the film ends in the middle of a frame, after " + std::to_string(got) +
                          " of its " + std::to_string(wanted) + " bytes",
                      file_.name(), "frame " + std::to_string(number_));
    }
    decode_frame(format_, bytes_, frame);
    ++number_;
    return true;
  }

 private:
  InputFile& file_;
  std::vector<std::uint8_t> bytes_;
  std::int64_t number_ = 0;
};

}  // namespace

std::unique_ptr<VideoReader> read_raw_video(InputFile& file, const VideoFormat& format, Rate rate) {
  return std::make_unique<RawReader>(file, format, rate);
}

std::optional<VideoFormat> raw_format(const std::string& name, int width, int height) {
  VideoFormat f;
  f.width = width;
  f.height = height;
  f.matrix = usual_matrix(width, height);
  if (name == "rgb24") {
    f.layout = FrameLayout::kRgb;
  } else if (name == "rgba") {
    f.layout = FrameLayout::kRgba;
  } else if (name == "bgra") {
    f.layout = FrameLayout::kBgra;
  } else if (name == "gray8" || name == "gray") {
    f.layout = FrameLayout::kGrey;
    f.full_range = true;  // as ffmpeg makes it
  } else if (name == "yuv420p") {
    f.chroma_across = f.chroma_down = 2;
    f.blue_site = f.red_site = {0, 0.5};  // MPEG-2's, which video has unless it says otherwise
  } else if (name != "yuv444p") {
    return std::nullopt;
  }
  return f;
}

std::string raw_format_names() { return "rgb24, rgba, bgra, gray8, yuv420p, yuv444p"; }

}  // namespace kinescope
