#include "demos/lesson/lesson.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "raster/base/error.h"

namespace kinescope {
namespace {

enum { kDisplay, kResolution, kSpeed, kRunning };  // of the lesson's own knobs

std::vector<Knob> with_lesson_knobs(std::vector<Knob> own, const LessonPlan& plan) {
  std::vector<std::string> sizes;
  for (const int cell : Lesson::kCells) {
    sizes.push_back(fmt::format("{}x{}", World::kScreenWidth / cell, World::kScreenHeight / cell));
  }
  own.push_back(choice_knob("display", {"t"}, LessonScreen::names(), 0, "what the picture is on"));
  own.push_back(scale_knob("resolution", "PageDown", "PageUp", std::move(sizes), plan.resolution,
                           "pixels of the whole screen: from coins to fine ones"));
  own.push_back(scale_knob("speed", "-", "=", Playback::speeds(), plan.speed,
                           "steps a second; n and b step by hand, Home and End jump"));
  own.push_back(toggle_knob("run", "Return", true, "steps follow each other by themselves"));
  return own;
}

int whole(double value, const std::string& label) {
  if (!(std::abs(value) <= 1e9)) {
    throw_bad_input(fmt::format("{}: {:.6g} lies beyond a billion", label, value));
  }
  return static_cast<int>(std::lround(value));
}

}  // namespace

Lesson::Lesson(const Lesson&) = default;
Lesson::~Lesson() = default;

Lesson::Lesson(const DemoSetup& setup, LessonPlan plan, std::vector<Knob> own)
    : Demo(setup, with_lesson_knobs(own, plan)),
      plan_(std::move(plan)),
      own_knobs_(static_cast<int>(own.size())),
      screen_(stage()) {
  last_world_.panes = {0, 0};  // handles stand in shares
}

World Lesson::world() const {
  const auto cell = static_cast<std::size_t>(knob(own_knobs_ + kResolution).index());
  return {kCells[cell], panes(), plan_.centred};
}

glm::ivec2 Lesson::pixel(int handle) const {
  const Handle& h = plan_.handles[static_cast<std::size_t>(handle)];
  return {whole(h.at.x, h.label), whole(h.at.y, h.label)};
}

int Lesson::whole_figure(int index) const {
  const Figure& figure = plan_.figures[static_cast<std::size_t>(index)];
  return whole(figure.value, figure.label);
}

int Lesson::running_knob() const { return own_knobs_ + kRunning; }

std::size_t Lesson::steps() const {
  std::size_t most = 0;
  for (const Track& track : course_->tracks) most = std::max(most, track.steps());
  return most;
}

void Lesson::resized() {
  screen_.resize(stage());
  stale_ = true;
}

/// Points keep their place when the world is finer or has other panes.
void Lesson::follow_world() {
  const World now = world();
  const glm::dvec2 size(now.columns(), now.rows());
  const glm::dvec2 before = last_world_.panes.x == 0
                                ? glm::dvec2(1)
                                : glm::dvec2(last_world_.columns(), last_world_.rows());
  if (before != size) {
    for (Handle& handle : plan_.handles) handle.at = glm::round(handle.at * size / before);
    if (last_world_.panes.x != 0) {
      for (Figure& f : plan_.figures) {
        if (f.step == 1 && f.in_pixels) f.value = std::round(f.value * size.y / before.y);
      }
    }
  }
  last_world_ = now;
}

void Lesson::run_anew(Begin begin) {
  fault_.clear();
  const bool at_end = begin == Begin::kLast;
  const std::size_t stay = begin == Begin::kStay ? playback_.shown() : 0;
  auto scene = std::make_shared<Course>();
  auto different = std::make_shared<std::vector<std::vector<Mark>>>();
  try {
    *scene = record();
    if (scene->compare) {
      const Track &a = scene->tracks.at(0), &b = scene->tracks.at(1);
      *different = {only_in(a, b), only_in(b, a)};
      const std::size_t count = (*different)[0].size() + (*different)[1].size();
      scene->remarks.push_back(count == 0 ? "No difference: both drew the same pixels."
                                          : fmt::format("{} pixels differ: lit red.", count));
    }
  } catch (const Error& error) {
    fault_ = error.what();
    *scene = {};
    different->clear();
  }
  course_ = std::move(scene);
  different_ = std::move(different);
  parts_ = 1;
  playback_.go_to(at_end ? steps() : std::min(stay, steps()));
  stale_ = true;
}

void Lesson::run_finer() {
  auto finer = std::make_shared<Course>(*course_);
  parts_ = refine(*finer, parts_) ? parts_ + 1 : 0;
  if (parts_ > 0) course_ = std::move(finer);
  stale_ = true;
}

void Lesson::update(const Step& step) {
  const bool turned = followed_.follow(knobs());
  bool anew = false, viewed = false;
  for (int i = 0; turned && i < own_knobs_; ++i) {
    (i < own_knobs_ - plan_.views ? anew : viewed) |= followed_.turned(i);
  }
  anew |= turned && followed_.turned(own_knobs_ + kResolution);
  stale_ |= turned;
  screen_.choose(knob(own_knobs_ + kDisplay).index(), step.exposure.begin);
  if (anew) follow_world();
  bool edited = false;
  for (const InputEvent& event : step.events) {
    if (take(event)) {
      edited = true;
      follow_world();  // a menu may have changed the panes
    }
  }
  const bool held = held_ != kNoHandle || dragging();
  if (anew || edited) {
    run_anew(edited && held ? Begin::kLast : Begin::kFirst);
  } else if (viewed) {
    run_anew(Begin::kStay);
  }
  if (knob(own_knobs_ + kRunning).on() && !held) {
    if (plan_.loops && playback_.shown() == steps()) playback_.go_to(0);
    stale_ |=
        playback_.pass(step.exposure.length().count(), knob(own_knobs_ + kSpeed).index(), steps());
  }
  if (parts_ > 0 && playback_.shown() == steps()) run_finer();
}

void Lesson::show_panes() {
  const World world = this->world();
  std::vector<Image<Srgb8>> papers = course_->papers;
  papers.resize(static_cast<std::size_t>(world.panes.x * world.panes.y));
  for (Image<Srgb8>& paper : papers) {
    if (paper.empty()) paper = Image<Srgb8>(world.columns(), world.rows(), kUnlit);
  }
  for (int pane = 0; course_->painter && pane < static_cast<int>(papers.size()); ++pane) {
    course_->painter(playback_.shown(), pane, papers[static_cast<std::size_t>(pane)]);
  }
  for (const Track& track : course_->tracks) {
    track.draw(playback_.shown(), papers[static_cast<std::size_t>(track.pane())]);
  }
  // The difference is told once both are done.
  for (std::size_t i = 0; i < different_->size() && playback_.shown() == steps(); ++i) {
    Image<Srgb8>& paper = papers[static_cast<std::size_t>(course_->tracks[i].pane())];
    for (const Mark& mark : (*different_)[i]) {
      if (paper.contains(mark.x, mark.y)) paper.at(mark.x, mark.y) = theme::kRed;
    }
  }
  screen_.show(world, papers);
}

void Lesson::draw(const Step& step, Image<Srgb8>& picture) {
  if (std::exchange(stale_, false)) {
    show_panes();
    draw_side();
  }
  std::fill(picture.pixels().begin(), picture.pixels().end(), theme::kBackground);
  screen_.draw(step, studio().workers, picture);
  Canvas canvas(picture);
  draw_over(canvas);
  const Rect room = side();
  const int left = static_cast<int>(room.x), top = static_cast<int>(room.y);
  const Image<Srgb8>& sheet = sheet_->image;
  for (int y = 0; y < std::min(sheet.height(), picture.height() - top); ++y) {
    std::copy_n(sheet.row(y), std::min(sheet.width(), picture.width() - left),
                picture.row(top + y) + left);
  }
}

std::optional<glm::vec2> Lesson::place_of_control(int id) const {
  for (const Form::Target& target : sheet_->targets) {
    if (target.id == id) {
      const Rect room = side();
      return glm::vec2(room.x + target.rect.x + target.rect.width / 2,
                       room.y + target.rect.y + target.rect.height / 2);
    }
  }
  return std::nullopt;
}

}  // namespace kinescope
