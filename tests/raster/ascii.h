// Pictures as text, so that a failing test shows what was drawn.
#pragma once

#include <string>
#include <vector>

namespace kinescope::testing {

/// A canvas of characters. A pixel drawn twice shows as '2' and so on; one outside is counted.
class AsciiCanvas {
 public:
  AsciiCanvas(int width, int height)
      : width_(width),
        rows_(static_cast<std::size_t>(height), std::string(static_cast<std::size_t>(width), '.')) {
  }

  void operator()(int x, int y) {
    if (x < 0 || y < 0 || x >= width_ || y >= static_cast<int>(rows_.size())) {
      ++outside_;
      return;
    }
    char& c = rows_[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
    c = c == '.' ? '#' : c == '#' ? '2' : static_cast<char>(c + 1);
  }

  std::string text() const {
    std::string all;
    for (const std::string& row : rows_) all += row + '\n';
    return all;
  }
  int outside() const { return outside_; }

 private:
  int width_;
  int outside_ = 0;
  std::vector<std::string> rows_;
};

}  // namespace kinescope::testing
