// Cairo's image surface as a peer.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "raster/image/image.h"
#include "raster/path/path_painter.h"

namespace kinescope::bench {

enum class CairoQuality { kDefault, kBest };

/// Fills paths on one thread (it has no more).
class CairoFills {
 public:
  /// Paths must outlive the peer, which keeps copies in Cairo's own form.
  CairoFills(std::span<const FilledPath> paths, float tolerance_px, CairoQuality quality, int width,
             int height);
  ~CairoFills();

  void draw();
  void clear();
  Image<Linear8> picture() const;
  static std::string version();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Lays out and draws lines of UTF-8 text with the DejaVu Sans that fontconfig finds, hints off,
/// grey edges.
class CairoText {
 public:
  CairoText(float size_px, int width, int height);
  ~CairoText();

  /// How far the pen moves, pixels.
  double width_px(const std::string& line) const;
  void draw(glm::vec2 pen, const std::string& line);
  void clear();
  Image<Linear8> picture() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace kinescope::bench
