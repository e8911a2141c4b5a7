// Uncompressed video, read a frame at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "raster/base/input_file.h"
#include "raster/base/units.h"
#include "raster/base/workers.h"
#include "raster/image/image.h"

namespace kinescope {

/// How a frame's bytes lie: planes of luma and of both chromas one after the other, or pixels.
enum class FrameLayout { kYuv, kGrey, kRgb, kRgba, kBgra };

/// The matrix from R'G'B' to luma and chroma: ITU-R BT.601 or BT.709.
enum class YuvMatrix { kBt601, kBt709 };

/// Where the first chroma sample of a plane lies, in luma pixels from the first luma sample. Of
/// interlaced video, y is counted in lines of a field, but for 0.5: between two lines of the frame.
struct ChromaSite {
  double x = 0, y = 0;
  bool operator==(const ChromaSite&) const = default;
};

/// Which field of a frame was taken first.
enum class FieldOrder { kProgressive, kTopFirst, kBottomFirst };

/// Everything needed to understand a frame's bytes.
struct VideoFormat {
  int width = 0, height = 0;
  FrameLayout layout = FrameLayout::kYuv;
  int bits = 8;  ///< a sample; above 8 each takes two bytes, the low one first
  int chroma_across = 1, chroma_down = 1;  ///< luma pixels a chroma sample
  ChromaSite blue_site, red_site;          ///< of Cb and Cr
  YuvMatrix matrix = YuvMatrix::kBt601;
  bool full_range = false;  ///< luma 0..255 instead of 16..235 (8 bits)
  FieldOrder fields = FieldOrder::kProgressive;
  bool operator==(const VideoFormat&) const = default;
};

/// Bytes that a frame takes.
std::size_t frame_bytes(const VideoFormat& format);

/// A frame's bytes as R'G'B' in 8 bits, chroma interpolated linearly. Alpha is kept.
/// @param out is given the format's size
void decode_frame(const VideoFormat& format, std::span<const std::uint8_t> bytes, Workers& workers,
                  Image<Srgb8>& out);

/// The matrix of video that does not name it: BT.709 from 1280 pixels across or above 576 lines.
YuvMatrix usual_matrix(int width, int height);

/// A film being read. Frames come in order; a damaged one ends it with an Error.
class VideoReader {
 public:
  /// @param file, workers must outlive it
  VideoReader(InputFile& file, Workers& workers) : file_(file), workers_(workers) {}
  virtual ~VideoReader() = default;
  VideoReader(const VideoReader&) = delete;
  VideoReader& operator=(const VideoReader&) = delete;
  /// @return false if there are no more. @throws Error (bad input) naming the frame
  virtual bool read(Image<Srgb8>& frame) = 0;

  const VideoFormat& format() const { return format_; }
  /// Frames a second.
  Rate rate() const { return rate_; }
  /// A pixel's width over its height; none if the file does not say.
  std::optional<double> pixel_aspect() const { return pixel_aspect_; }

 protected:
  /// The next frame's bytes as a picture. @throws Error if there are fewer
  void read_frame(Image<Srgb8>& frame);
  /// "frame 7": the one that comes next.
  std::string place() const { return "frame " + std::to_string(number_); }

  InputFile& file_;
  Workers& workers_;
  VideoFormat format_;
  Rate rate_;
  std::optional<double> pixel_aspect_;
  std::int64_t number_ = 0;  ///< frames read

 private:
  std::vector<std::uint8_t> bytes_;
};

/// YUV4MPEG2: 4:2:0 of every siting, 4:2:2, 4:1:1, 4:4:4 and grey, 8 to 16 bits a sample. Streams
/// laid end to end are one film if all are alike. Its `XMATRIX=601|709` tag is our own.
/// @param matrix that the user knows; none: the stream's tag, or the usual one
/// @throws Error (bad input) on a header that is damaged or of a kind that is not read
std::unique_ptr<VideoReader> read_y4m(InputFile& file, Workers& workers,
                                      std::optional<YuvMatrix> matrix = {});
/// Whether the file begins as YUV4MPEG2 does.
bool is_y4m(InputFile& file);

/// Frames without any header.
std::unique_ptr<VideoReader> read_raw_video(InputFile& file, Workers& workers,
                                            const VideoFormat& format, Rate rate);

/// The layout that ffmpeg calls by this name: rgb24, rgba, bgra, gray8 or gray, yuv420p, yuv444p.
/// @return nothing if there is none
std::optional<VideoFormat> raw_format(const std::string& name, int width, int height);
/// The names above, for a message.
std::string raw_format_names();

}  // namespace kinescope
