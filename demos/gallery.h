// The gallery: every demo as a small picture made by itself, under its chapter, to be searched and
// chosen from.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "demos/demo.h"
#include "demos/gallery_page.h"
#include "demos/portrait.h"
#include "demos/screen.h"
#include "demos/ui/text_field.h"

namespace kinescope {

class Gallery : public Screen {
 public:
  Gallery(std::shared_ptr<Studio> studio, int width, int height, std::uint64_t seed);

  void handle(const InputEvent& event) override;
  bool tick(int frames_per_second) override;
  const Image<Srgb8>& frame() const override { return frame_; }
  Seconds tick_length() const override { return Seconds(1.0 / 60); }
  /// While there is something to search for, Escape clears it.
  bool typing() const override { return !search_.text.empty(); }
  bool done() const override { return chosen_.has_value(); }

  /// The demo that is marked, if the search found any.
  std::optional<std::size_t> selected() const;
  const GalleryPage& page() const { return page_; }
  /// The demo that was started; the gallery may then be shown again.
  std::optional<std::size_t> take_choice();

 private:
  bool key(const std::string& key);
  bool move(const std::string& key);
  void press(int x, int y);
  void search();
  void select(std::size_t place, bool scroll);
  void draw_page();
  void draw_header(Canvas& canvas) const;
  void draw_rail(Canvas& canvas) const;
  void draw_caption(std::size_t place, Canvas& canvas) const;
  bool in_view(std::size_t place) const;
  std::size_t chapter_in_view() const;
  void step_portrait(std::size_t place);
  void show_portrait(std::size_t place);

  std::shared_ptr<Studio> studio_;
  std::uint64_t seed_;
  GalleryPage page_;
  TextField search_;
  std::vector<Portrait> portraits_;  // by demo; the marked one moves
  std::size_t place_ = 0;            // of the marked demo on the page
  std::optional<std::size_t> chosen_;
  int width_, height_;
  bool dirty_ = true;
  Image<Srgb8> frame_;
};

}  // namespace kinescope
