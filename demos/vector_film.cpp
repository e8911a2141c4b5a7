#include "demos/vector_film.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "demos/display_file_input.h"
#include "demos/tube_film.h"
#include "display/light_encode.h"
#include "display/vector/display_processor.h"
#include "display/vector/drawing_moves.h"
#include "display/vector/input/beam_strokes.h"
#include "display/vector/storage_tube.h"
#include "display/vector/vector_tube.h"

namespace kinescope {
namespace {

constexpr Seconds kSixtieth(1.0 / 60);
constexpr Seconds kFadedOut(1);  // after it a passing beam's light is gone
constexpr Seconds kLongestList(60);
constexpr std::size_t kBatch = 1 << 20;

/// A tube of the drawing's own shape, 4096 points wide, in colour.
VectorMachine machine_for(const VectorDrawing& drawing) {
  VectorMachine machine = vector_machines().front();
  const double shape = static_cast<double>(drawing.size.y) / static_cast<double>(drawing.size.x);
  const double units = machine.width;
  machine.width = static_cast<int>(units / std::max(1.0, shape));
  machine.height = static_cast<int>(units * std::min(1.0, shape));
  machine.width = std::max(machine.width, 2);
  machine.height = std::max(machine.height, 2);
  machine.phosphor = "P22";
  return machine;
}

/// Moves that come again and again.
class Refreshed {
 public:
  Refreshed(const VectorDrawing& drawing, Size size)
      : machine_(machine_for(drawing)), tube_(machine_, size.width, size.height) {
    period_ = draw_strokes_of(beam_strokes(drawing), machine_, Seconds(0), moves_);
    go_home();
    period_ = std::max(period_, kSixtieth);
  }
  Seconds period() const { return period_; }

  const Image<LinearRgb>& expose(Seconds end, Workers& workers) {
    asked_.clear();
    while (next_ < moves_.size() || began_ + period_ < end) {
      if (next_ == moves_.size()) next_ = 0, began_ += period_;
      for (; next_ < moves_.size() && moves_[next_].begin + began_ < end; ++next_) {
        asked_.push_back(moves_[next_]);
        asked_.back().begin += began_;
        asked_.back().end += began_;
        if (asked_.size() == kBatch) break;
      }
      if (next_ < moves_.size() && asked_.size() < kBatch) break;
      if (asked_.size() < kBatch) continue;
      // Light of long lists is gathered in parts: memory for all at once would be too much.
      ++next_;
      add(tube_.expose(asked_, std::min(end, asked_.back().end), workers));
      asked_.clear();
    }
    const Image<LinearRgb>& last = tube_.expose(asked_, end, workers);
    if (sum_.width() == 0) return last;
    add(last);
    out_ = std::exchange(sum_, {});
    return out_;
  }

 private:
  /// To the corner where each refresh begins: a beam that is still on its way would smear the first
  /// stroke.
  void go_home() {
    if (moves_.empty()) return;
    BeamMove home = moves_.back();
    home.x0 = std::exchange(home.x1, 0), home.y0 = std::exchange(home.y1, 0);
    const double clocks =
        static_cast<double>(machine_.clocks("move", std::hypot(home.x0, home.y0)));
    home.begin = period_;
    home.end = period_ += Seconds(clocks / machine_.clock_hz);
    home.intensity = 0;
    moves_.push_back(home);
  }

  void add(const Image<LinearRgb>& light) {
    if (sum_.width() == 0) {
      sum_ = light;
    } else {
      add_light(sum_, light);
    }
  }

  VectorMachine machine_;
  VectorTube tube_;
  std::vector<BeamMove> moves_, asked_;
  Seconds period_{0}, began_{0};
  std::size_t next_ = 0;
  Image<LinearRgb> sum_, out_;
};

class Program {
 public:
  Program(const VectorMachine& machine, const DisplayFile& program, Size size, std::string name)
      : memory_(memory_for(machine, program)),
        processor_(machine, memory_),
        tube_(machine, size.width, size.height),
        name_(std::move(name)) {
    memory_.load(0, program.words);
    processor_.start(program.start);
  }
  const Image<LinearRgb>& expose(Seconds end, Workers& workers) {
    moves_.clear();
    processor_.run(end, moves_);
    processor_.throw_fault(name_);
    return tube_.expose(moves_, end, workers);
  }

 private:
  DisplayMemory memory_;
  DisplayProcessor processor_;
  VectorTube tube_;
  std::string name_;
  std::vector<BeamMove> moves_;
};

template <typename Source>
VectorShow show_of(const std::shared_ptr<Source>& source) {
  VectorShow show;
  show.expose = [source](Seconds end, Workers& workers) -> const Image<LinearRgb>& {
    return source->expose(end, workers);
  };
  return show;
}

}  // namespace

VectorShow refreshed_show(const VectorDrawing& drawing, Size size) {
  const auto list = std::make_shared<Refreshed>(drawing, size);
  VectorShow show = show_of(list);
  // Phosphors of P22 have forgotten by then what was before.
  show.settled = list->period() > Seconds(0.1) ? Seconds(0) : 6 * list->period();
  show.whole = list->period();
  return show;
}

VectorShow storage_show(const VectorDrawing& drawing, Size size) {
  const auto tube =
      std::make_shared<StorageTube>(find_storage_tube("4014"), size.width, size.height);
  tube->draw(drawing);
  VectorShow show = show_of(tube);
  show.settled = tube->busy_until() + kFadedOut;
  show.still = [tube] { return tube->still() && !tube->changed(); };
  show.hard_copy = [tube] { return tube->hard_copy(); };
  return show;
}

void time_refresh(VectorShow& show, const VectorMachine& machine, const DisplayFile& program) {
  DisplayMemory memory(memory_for(machine, program));
  memory.load(0, program.words);
  DisplayProcessor scratch(machine, memory);
  scratch.start(program.start);
  std::vector<BeamMove> moves;
  Seconds end{0};
  const auto goes_on = [&](std::int64_t refreshes, Seconds longest) {
    return scratch.refreshes() < refreshes && end < longest &&
           scratch.status() == ProcessorStatus::kRunning;
  };
  for (; goes_on(5, Seconds(1)) || goes_on(2, kLongestList); moves.clear()) {
    scratch.run(end += milliseconds(1), moves);
  }
  const auto period = scratch.refresh_period();
  show.whole = std::max(period.value_or(Seconds(1)), kSixtieth);
  show.settled = period ? 6 * *period : Seconds(0);  // a list that halts is seen once
}

VectorShow processor_show(const VectorMachine& machine, std::shared_ptr<const DisplayFile> program,
                          Size size, const std::string& name) {
  VectorShow show = show_of(std::make_shared<Program>(machine, *program, size, name));
  time_refresh(show, machine, *program);
  return show;
}

VectorShot vector_shot(const Options& options) {
  const PictureOptions& picture = options.picture;
  VectorShot shot;
  shot.frames = picture.frames.value_or(FrameRange{});
  shot.rate = picture.fps.value_or(shot.rate);
  shot.whole =
      !picture.frames && !picture.fps && !picture.shutter && options.vector.start == Seconds(0);
  shot.shutter = picture.shutter;
  if (picture.shutter) check_shutter(*picture.shutter, shot.rate, true);
  shot.start = options.vector.start;
  shot.gain = options.vector.gain;
  shot.deep = picture.depth_bits == 16;
  return shot;
}

VectorFilm::VectorFilm(const VectorShot& shot, VectorShow show, Workers& workers)
    : shot_(shot), show_(std::move(show)), workers_(workers), next_(shot.frames.first) {}

bool VectorFilm::shoot(Film& film) {
  if (next_ > shot_.frames.last) return false;
  // An exposure ends where the next begins, to the last bit: the tube's time only goes forward.
  const auto at = [&](int frame) {
    return shot_.start + static_cast<double>(frame) * shot_.rate.period();
  };
  const Seconds begin = shot_.whole ? show_.settled : at(next_);
  const Seconds end = shot_.whole     ? begin + show_.whole
                      : shot_.shutter ? begin + *shot_.shutter
                                      : at(next_ + 1);
  const Seconds length = end - begin;
  if (begin > seen_) show_.expose(begin, workers_);
  seen_ = std::max(end, seen_);
  const Image<LinearRgb>& light = show_.expose(seen_, workers_);
  const double by_length = shot_.whole ? 1 : kSixtieth / length;
  const auto gain = ExposureGain::fixed(static_cast<float>(shot_.gain.value_or(by_length)));
  if (shot_.deep) {
    Image<Srgb16> picture;
    encode_light(light, gain, workers_, picture);
    film.write(picture, next_++);
  } else {
    Image<Srgb8> picture;
    encode_light(light, gain, workers_, picture);
    film.write(picture, next_++);
  }
  return next_ <= shot_.frames.last;
}

}  // namespace kinescope
