#include "demos/picture_feed.h"

#include <filesystem>
#include <utility>

#include "demos/numbered_files.h"
#include "display/patterns/patterns.h"
#include "raster/base/error.h"
#include "raster/image/codecs.h"

namespace kinescope {
namespace {

constexpr std::string_view kPatternPrefix = "pattern:";

class StillFeed : public PictureFeed {
 public:
  StillFeed(Image<Srgb8> picture, TubeSignal signal) : picture_(std::move(picture)) {
    facts_.size = {picture_.width(), picture_.height()};
    facts_.signal = signal;
    facts_.still = true;
  }
  bool next(Image<Srgb8>& picture) override {
    if (shown_) return false;
    picture = std::move(picture_);
    return shown_ = true;
  }

 private:
  Image<Srgb8> picture_;
  bool shown_ = false;
};

class SequenceFeed : public PictureFeed {
 public:
  explicit SequenceFeed(std::vector<std::string> files) : files_(std::move(files)) {
    first_ = read_image_file(files_.front());
    facts_.size = {first_.width(), first_.height()};
  }
  bool next(Image<Srgb8>& picture) override {
    if (at_ == files_.size()) return false;
    const std::string& file = files_[at_];
    picture = at_ == 0 ? std::move(first_) : read_image_file(file);
    ++at_;
    if (facts_.size == Size{picture.width(), picture.height()}) return true;
    throw_bad_input("the sequence changes its size from " + size_name(facts_.size) + " to " +
                        size_name({picture.width(), picture.height()}),
                    file);
  }

 private:
  static std::string size_name(Size size) {
    return std::to_string(size.width) + "x" + std::to_string(size.height);
  }
  std::vector<std::string> files_;
  std::size_t at_ = 0;
  Image<Srgb8> first_;
};

class VideoFeed : public PictureFeed {
 public:
  VideoFeed(std::unique_ptr<InputFile> file, std::unique_ptr<VideoReader> reader)
      : file_(std::move(file)), reader_(std::move(reader)) {
    facts_.size = {reader_->format().width, reader_->format().height};
    facts_.rate = reader_->rate();
    facts_.pixel_aspect = reader_->pixel_aspect();
    facts_.fields = reader_->format().fields;
  }
  bool next(Image<Srgb8>& picture) override {
    if (reader_->read(picture)) return any_ = true;
    if (!any_) throw_bad_input("a film without frames", file_->name());
    return false;
  }
  void interrupt() override { file_->interrupt(); }

 private:
  std::unique_ptr<InputFile> file_;
  std::unique_ptr<VideoReader> reader_;
  bool any_ = false;
};

std::unique_ptr<PictureFeed> open_file(const DisplayRequest& request, Workers& workers) {
  auto file = std::make_unique<InputFile>(request.input);
  std::unique_ptr<VideoReader> reader;
  if (request.raw) {
    VideoFormat format = request.raw->format;
    if (request.matrix) format.matrix = *request.matrix;
    reader = read_raw_video(*file, workers, format, request.raw->rate);
  } else if (is_y4m(*file)) {
    reader = read_y4m(*file, workers, request.matrix);
  }
  if (reader) return std::make_unique<VideoFeed>(std::move(file), std::move(reader));
  constexpr std::size_t kMostBytes = std::size_t{1} << 31;
  if (file->peek(1).empty()) throw_bad_input("empty: neither a picture nor a film", file->name());
  return std::make_unique<StillFeed>(read_image(file->rest(kMostBytes), file->name()),
                                     TubeSignal::kPicture);
}

}  // namespace

std::unique_ptr<PictureFeed> open_feed(const DisplayRequest& request, Size pattern_size,
                                       Workers& workers) {
  const std::string& input = request.input;
  if (input.starts_with(kPatternPrefix)) {
    const TestPattern& pattern = find_test_pattern(input.substr(kPatternPrefix.size()));
    return std::make_unique<StillFeed>(pattern.draw(pattern_size.width, pattern_size.height),
                                       TubeSignal::kGunDrive);
  }
  std::error_code ignored;
  const bool numbered = input.find('#') != std::string::npos;
  if (numbered && !request.raw && !std::filesystem::exists(input, ignored)) {
    return std::make_unique<SequenceFeed>(numbered_files(input));
  }
  return open_file(request, workers);
}

}  // namespace kinescope
