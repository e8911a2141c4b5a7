// A form: text, fields, buttons, sliders and tables from top to bottom in a column of a picture,
// with the places where a click does something.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "demos/studio.h"
#include "demos/ui/canvas.h"
#include "demos/ui/text_field.h"

namespace kinescope {

/// Drawn anew where something changed; what is clicked is told by numbers that its user gave.
class Form {
 public:
  static constexpr int kNothing = -1;
  static constexpr float kWidth = 330;  ///< at the theme's reference height, pixels

  /// A place to click, pixels of the picture; along its width, a share from 0 to 1.
  struct Target {
    Rect rect;
    int id;
  };
  struct Button {
    int id;
    std::string label;
    bool lit = false;
  };
  struct Table {
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;
    std::vector<bool> marked;  ///< rows that are lit, such as those that differ
  };

  Form(Canvas& canvas, const Studio& studio, float scale, const Rect& area);

  void title(std::string_view words);
  /// Wrapped to the column.
  void text(std::string_view words, Srgb8 colour);
  /// One line as it is, in letters of one width.
  void code(std::string_view words, Srgb8 colour);
  /// @param field what is being typed, or null: then `shown` stands there
  void field(int id, std::string_view label, std::string_view shown, const TextField* field);
  /// @param share of the track, 0 to 1
  void slider(int id, float share);
  void buttons(const std::vector<Button>& row);
  /// As many of the last rows as find room above `bottom`.
  void table(const Table& table, float bottom);
  void gap(float size = 8) { y_ += size * scale_; }

  float y() const { return y_; }
  float row_height() const;  ///< of text, pixels
  const std::vector<Target>& targets() const { return targets_; }

 private:
  float px(float size) const { return size * scale_; }
  std::vector<float> column_ends(const Table& table, std::size_t shown, float& size) const;
  void words(float x, std::string_view text, float size, Srgb8 colour, Align align);

  Canvas& canvas_;
  const Studio& studio_;
  float scale_;
  Rect area_;
  float y_;
  std::vector<Target> targets_;
};

}  // namespace kinescope
