// Video without headers: frames of a known size, one after the other.
#include "raster/base/error.h"
#include "raster/image/video.h"

namespace kinescope {
namespace {

class RawReader : public VideoReader {
 public:
  RawReader(InputFile& file, Workers& workers, const VideoFormat& format, Rate rate)
      : VideoReader(file, workers) {
    format_ = format;
    rate_ = rate;
  }

  bool read(Image<Srgb8>& frame) override {
    if (file_.peek(1).empty()) {
      if (number_ == 0) throw_bad_input("an empty file, not a film", file_.name());
      return false;
    }
    read_frame(frame);
    return true;
  }
};

}  // namespace

void VideoReader::read_frame(Image<Srgb8>& frame) {
  bytes_.clear();
  const std::size_t wanted = frame_bytes(format_), got = file_.append_to(bytes_, wanted);
  if (got < wanted) {
    throw_bad_input("the film ends in the middle of a frame, after " + std::to_string(got) +
                        " of its " + std::to_string(wanted) + " bytes",
                    file_.name(), place());
  }
  decode_frame(format_, bytes_, workers_, frame);
  ++number_;
}

std::unique_ptr<VideoReader> read_raw_video(InputFile& file, Workers& workers,
                                            const VideoFormat& format, Rate rate) {
  return std::make_unique<RawReader>(file, workers, format, rate);
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
