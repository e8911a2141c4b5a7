#include "demos/lesson/track.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <set>
#include <utility>

#include "raster/base/error.h"

namespace kinescope {
namespace {

void lay(Srgb8& below, Srgb8 colour) {
  if (colour.a == 255) {
    below = colour;
    return;
  }
  const float share = static_cast<float>(colour.a) / 255;
  const LinearRgba under = decode(below), over = decode({colour.r, colour.g, colour.b, 255});
  below =
      encode_srgb8(LinearRgb{std::lerp(under.r, over.r, share), std::lerp(under.g, over.g, share),
                             std::lerp(under.b, over.b, share)});
}

}  // namespace

Track::Track(std::string name, std::vector<std::string> columns, int pane, Srgb8 ink)
    : name_(std::move(name)), columns_(std::move(columns)), pane_(pane), ink_(ink) {}

Track::Track(const Track&) = default;
Track::Track(Track&&) noexcept = default;
Track& Track::operator=(const Track&) = default;
Track& Track::operator=(Track&&) noexcept = default;
Track::~Track() = default;

void Track::plot(int x, int y, Srgb8 colour, float weight) {
  if (marks_.size() == kMostMarks) throw_bad_input("more than 2000000 pixels: draw less");
  const float alpha = std::clamp(weight, 0.0f, 1.0f) * static_cast<float>(colour.a);
  colour.a = static_cast<std::uint8_t>(std::lround(alpha));
  marks_.push_back({x, y, colour});
}

void Track::span(const RowSpan& span, Srgb8 colour) {
  for (int x = span.x_begin; x < span.x_end; ++x) plot(x, span.y, colour);
}

void Track::step(std::vector<double> values, std::string note) {
  assert(values.size() == columns_.size());
  if (steps_.size() == kMostSteps) throw_bad_input("more than 200000 steps: draw less");
  steps_.push_back({marks_.size(), std::move(values), std::move(note)});
}

std::span<const Mark> Track::marks(std::size_t step) const {
  const std::size_t begin = step == 0 ? 0 : steps_[step - 1].marks_end;
  return std::span(marks_).subspan(begin, steps_[step].marks_end - begin);
}

void Track::draw(std::size_t steps, Image<Srgb8>& paper) const {
  steps = std::min(steps, steps_.size());
  const std::size_t end = steps == 0 ? 0 : steps_[steps - 1].marks_end;
  for (const Mark& mark : std::span(marks_).first(end)) {
    if (paper.contains(mark.x, mark.y)) lay(paper.at(mark.x, mark.y), mark.colour);
  }
}

std::vector<Mark> only_in(const Track& a, const Track& b) {
  std::set<std::pair<int, int>> seen;
  for (const Mark& mark : b.all_marks()) seen.insert({mark.x, mark.y});
  std::vector<Mark> only;
  for (const Mark& mark : a.all_marks()) {
    if (seen.insert({mark.x, mark.y}).second) only.push_back(mark);
  }
  return only;
}

}  // namespace kinescope
