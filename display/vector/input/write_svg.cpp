#include "display/vector/input/write_svg.h"

#include <algorithm>
#include <charconv>
#include <cstdio>

#include "display/vector/input/beam_strokes.h"
#include "raster/base/output_file.h"

namespace kinescope {
namespace {

void append(std::string& text, float value) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  text.append(digits, end);
}

/// Text that goes out in blocks.
class SvgWriter {
 public:
  SvgWriter(const std::string& path, const VectorDrawing& drawing) : file_(path), in_(drawing) {
    text_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 ";
    append(text_, in_.size.x);
    text_ += ' ';
    append(text_, in_.size.y);
    text_ += "\">\n<rect width=\"100%\" height=\"100%\"/>\n";
    text_ += "<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
  }

  void run(const VectorPen& pen, std::size_t first, std::size_t last) {
    while (first < last) {
      // One path a current of the beam, and not too long for a reader's line.
      const float intensity = in_.segments[first].intensity;
      std::size_t end = first;
      while (end < last && end < first + 4096 && in_.segments[end].intensity == intensity) ++end;
      begin_path(pen, intensity);
      for (std::size_t i = first; i < end; ++i) add(in_.segments[i], i == first);
      text_ += "\"/>\n";
      put();
      first = end;
    }
  }

  void close() {
    text_ += "</g>\n</svg>\n";
    put();
    file_.commit();
  }

 private:
  void begin_path(const VectorPen& pen, float intensity) {
    char colour[16];
    std::snprintf(colour, sizeof colour, "#%02x%02x%02x", pen.colour.r, pen.colour.g, pen.colour.b);
    text_ += std::string("<path stroke=\"") + colour + "\" stroke-width=\"";
    append(text_, pen.width > 0 ? pen.width : std::max(in_.size.x, in_.size.y) / 1024);
    if (intensity < 1) {
      text_ += "\" stroke-opacity=\"";
      append(text_, std::max(intensity, 0.0f));
    }
    text_ += "\" d=\"";
  }
  void add(const VectorSegment& s, bool first) {
    if (first || s.x1 != x_ || s.y1 != y_) point('M', s.x1, s.y1);
    point('L', s.x2, s.y2);
    x_ = s.x2;
    y_ = s.y2;
  }
  void point(char command, float x, float y) {
    text_ += command;
    append(text_, x - in_.origin.x);
    text_ += ' ';
    append(text_, in_.origin.y + in_.size.y - y);
  }
  void put() {
    file_.write(text_);
    text_.clear();
  }

  OutputFile file_;
  const VectorDrawing& in_;
  std::string text_;
  float x_ = 0, y_ = 0;  // where the last stroke ended
};

}  // namespace

void write_svg(const std::string& path, const VectorDrawing& drawing) {
  const VectorDrawing strokes = beam_strokes(drawing);
  SvgWriter writer(path, strokes);
  for_each_run(strokes, [&](const VectorPen& pen, std::size_t first, std::size_t last) {
    writer.run(pen, first, last);
  });
  writer.close();
}

}  // namespace kinescope
