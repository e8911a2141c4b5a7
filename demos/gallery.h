// The gallery: every demo as a small picture made by itself, to choose from.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "demos/demo.h"
#include "demos/screen.h"
#include "demos/ui/canvas.h"

namespace kinescope {

class Gallery : public Screen {
 public:
  Gallery(std::shared_ptr<Studio> studio, int width, int height, std::uint64_t seed);

  void handle(const InputEvent& event) override;
  bool tick(int frames_per_second) override;
  const Image<Srgb8>& frame() const override { return frame_; }
  Seconds tick_length() const override { return Seconds(1.0 / 60); }
  bool done() const override { return chosen_.has_value(); }

  std::size_t selected() const { return selected_; }
  /// The demo that was started; the gallery may then be shown again.
  std::optional<std::size_t> take_choice();

 private:
  /// A demo at a small size. The chosen one moves.
  struct Thumbnail {
    std::unique_ptr<Demo> demo;
    Seconds now{0};
    std::int64_t steps = 0;
    Image<Srgb8> picture;
  };
  void lay_out();
  void key(const std::string& key);
  void draw_page();
  void draw_caption(std::size_t index, Canvas& canvas);
  bool step_thumbnail(std::size_t index);
  void show_thumbnail(std::size_t index);
  Rect cell(std::size_t index) const;
  Rect thumbnail_place(std::size_t index) const;
  std::optional<std::size_t> demo_at(int x, int y) const;
  void select(std::size_t index);

  std::shared_ptr<Studio> studio_;
  std::uint64_t seed_;
  std::vector<Thumbnail> thumbnails_;
  std::size_t selected_ = 0;
  std::optional<std::size_t> chosen_;
  int width_, height_;
  std::size_t columns_ = 1, rows_shown_ = 1, first_row_ = 0;
  float scale_ = 1, cell_width_ = 1, cell_height_ = 1;
  bool dirty_ = true;
  Image<Srgb8> frame_;
};

}  // namespace kinescope
