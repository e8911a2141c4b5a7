// What an algorithm did, step by step: the pixels of each step, and its state behind it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "demos/ui/theme.h"
#include "raster/image/image.h"
#include "raster/scan/row_span.h"

namespace kinescope {

struct Mark {
  int x, y;
  Srgb8 colour;  ///< alpha is its weight
};

class Track {
 public:
  /// A longer course is refused: nobody looks at it.
  static constexpr std::size_t kMostSteps = 200'000, kMostMarks = 2'000'000;

  /// @param columns names of the state's numbers
  Track(std::string name, std::vector<std::string> columns, int pane = 0, Srgb8 ink = theme::kText);
  // In track.cpp: every lesson would compile them again.
  Track(const Track&);
  Track(Track&&) noexcept;
  Track& operator=(const Track&);
  Track& operator=(Track&&) noexcept;
  ~Track();

  /// A sink: pixels, weighted ones and runs belong to the step that comes next.
  void operator()(int x, int y, float weight = 1) { plot(x, y, ink_, weight); }
  void operator()(const RowSpan& span) { this->span(span, ink_); }
  void plot(int x, int y, Srgb8 colour, float weight = 1);
  void span(const RowSpan& span, Srgb8 colour);
  /// Ends a step. @param values as many as columns @param note lines of other state
  /// @throws Error (bad input) beyond kMostSteps
  void step(std::vector<double> values, std::string note = {});

  const std::string& name() const { return name_; }
  const std::vector<std::string>& columns() const { return columns_; }
  int pane() const { return pane_; }
  Srgb8 ink() const { return ink_; }
  std::size_t steps() const { return steps_.size(); }
  std::span<const Mark> all_marks() const { return marks_; }
  std::span<const Mark> marks(std::size_t step) const;
  const std::vector<double>& values(std::size_t step) const { return steps_[step].values; }
  const std::string& note(std::size_t step) const { return steps_[step].note; }

  /// Lays what the first `steps` steps drew.
  void draw(std::size_t steps, Image<Srgb8>& paper) const;

 private:
  struct State {
    std::size_t marks_end;
    std::vector<double> values;
    std::string note;
  };
  std::string name_;
  std::vector<std::string> columns_;
  int pane_;
  Srgb8 ink_;
  std::vector<Mark> marks_;
  std::vector<State> steps_;
};

/// Pixels of `a` that `b` never drew, each once.
std::vector<Mark> only_in(const Track& a, const Track& b);

}  // namespace kinescope
