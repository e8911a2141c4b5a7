#include "demos/vector_monitor.h"

#include <algorithm>
#include <string>

#include "display/light_encode.h"

namespace kinescope {
namespace {

constexpr double kIris = 64;    // as of Monitor
constexpr int kMostPlanes = 8;  // of light, that a phosphor's layers and terms take

double scale_of(const VectorMachine& machine, int width, int height) {
  return std::min(static_cast<double>(width) / machine.width,
                  static_cast<double>(height) / machine.height);
}

float luminance(const LinearRgb& c) { return 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b; }

/// White is added to what a screen's colours cannot show, until its luminance is right.
LinearRgb towards_white(const LinearRgb& c) {
  const auto shown = [](float v) { return std::clamp(v, 0.0f, 1.0f); };
  const LinearRgb clipped{shown(c.r), shown(c.g), shown(c.b)};
  const float lacks = luminance(c) - luminance(clipped), room = 1 - luminance(clipped);
  const float white = room > 0 ? shown(lacks / room) : 0;
  return {clipped.r + white * (1 - clipped.r), clipped.g + white * (1 - clipped.g),
          clipped.b + white * (1 - clipped.b)};
}

void overexpose(const Image<LinearRgb>& light, float gain, Workers& workers,
                Image<LinearRgb>& exposed) {
  if (exposed.width() != light.width() || exposed.height() != light.height()) {
    exposed = Image<LinearRgb>(light.width(), light.height());
  }
  run_rows(workers, light.height(), [&](int y) {
    std::transform(light.row(y), light.row(y) + light.width(), exposed.row(y),
                   [gain](const LinearRgb& c) {
                     return towards_white({gain * c.r, gain * c.g, gain * c.b});
                   });
  });
}

}  // namespace

VectorMonitor::VectorMonitor(const VectorMachine& machine, int width, int height)
    : machine_(std::make_shared<VectorMachine>(machine)),
      memory_(static_cast<std::size_t>(machine.memory_words)),
      tube_(machine, width, height),
      width_(width),
      height_(height),
      scale_(scale_of(machine, width, height)) {
  processor_.emplace(*machine_, memory_);
}

VectorMonitor::VectorMonitor(const VectorMonitor& other)
    : machine_(other.machine_),
      memory_(other.memory_),
      tube_(other.tube_),
      width_(other.width_),
      height_(other.height_),
      scale_(other.scale_),
      pen_(other.pen_),
      hits_(other.hits_),
      refreshes_(other.refreshes_),
      start_(other.start_),
      gain_(other.gain_) {
  processor_.emplace(*machine_, memory_);
  processor_->state() = other.processor_->state();
}

std::size_t VectorMonitor::state_bytes() const {
  const auto pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  return memory_.size() * sizeof(Word) + pixels * (kMostPlanes * sizeof(float) + sizeof(LinearRgb));
}

void VectorMonitor::resize(int width, int height) {
  width_ = width;
  height_ = height;
  scale_ = scale_of(*machine_, width, height);
  tube_ = VectorTube(*machine_, width, height);
}

void VectorMonitor::coat(std::string_view phosphor) {
  if (machine_->phosphor == phosphor) return;
  VectorMachine machine = *machine_;
  machine.phosphor = phosphor;
  machine_ = std::make_shared<VectorMachine>(machine);
  const ProcessorState state = processor_->state();
  processor_.emplace(*machine_, memory_);
  processor_->state() = state;
  tube_ = VectorTube(*machine_, width_, height_);
}

DisplayFile VectorMonitor::load(std::string_view text) {
  DisplayFile file = assemble(text, instruction_set(machine_->words), "the demo's program");
  memory_.load(0, file.words);
  start_ = file.start;
  processor_->start(file.start);
  return file;
}

Address VectorMonitor::write(Address at, std::string_view name,
                             std::initializer_list<std::int64_t> operands) {
  const std::vector<std::int64_t> values(operands);
  const std::vector<Word> words = instruction_set(machine_->words).encode(name, values);
  memory_.load(at, words);
  return at + static_cast<Address>(words.size());
}

std::string VectorMonitor::text_at(Address address) const {
  const std::span<const Word> words = memory_.words();
  return instruction_set(machine_->words).decode(words.subspan(address)).text;
}

void VectorMonitor::run(Seconds end) {
  const std::int64_t before = processor_->refreshes();
  if (!pen_) {
    processor_->hold_pen(std::nullopt);
    processor_->run(end, moves_);
  } else {
    processor_->hold_pen(pen_);
    while (processor_->now() < end) {
      processor_->run(std::min(end, processor_->now() + kAnswer), moves_);
      if (processor_->status() != ProcessorStatus::kPenHit) continue;
      hits_.push_back(*processor_->hit());
      processor_->resume();
    }
  }
  refreshes_ = processor_->refreshes() - before;
}

void VectorMonitor::expose(const Step& step, Workers& workers, Image<Srgb8>& picture) {
  moves_.clear();
  hits_.clear();
  run(step.exposure.end);
  const Image<LinearRgb>& light = tube_.expose(moves_, step.exposure.end, workers);
  const double part = std::clamp(step.exposure.length().count() * 60, 1 / kIris, 1.0);
  if (gain_ > 1) {
    overexpose(light, static_cast<float>(gain_ / part), workers, exposed_);
    encode_light(exposed_, ExposureGain::fixed(1), workers, picture);
  } else {
    encode_light(light, ExposureGain::fixed(static_cast<float>(gain_ / part)), workers, picture);
  }
}

Seconds VectorMonitor::period() const {
  constexpr Seconds kSlice = milliseconds(1), kLongest(1);
  DisplayMemory memory = memory_;
  DisplayProcessor scratch(*machine_, memory);  // the beam comes from elsewhere at first
  scratch.start(processor_->state().start);
  std::vector<BeamMove> moves;
  for (Seconds end = kSlice; scratch.refreshes() < 5 && end < kLongest; end += kSlice) {
    scratch.run(end, moves);
    moves.clear();
  }
  return scratch.refresh_period().value_or(kLongest);
}

glm::dvec2 VectorMonitor::place(int x, int y) const {
  return {0.5 * machine_->width + (x + 0.5 - 0.5 * width_) / scale_,
          0.5 * machine_->height - (y + 0.5 - 0.5 * height_) / scale_};
}

glm::vec2 VectorMonitor::pixel(double x, double y) const {
  return {static_cast<float>(0.5 * width_ + (x - 0.5 * machine_->width) * scale_),
          static_cast<float>(0.5 * height_ - (y - 0.5 * machine_->height) * scale_)};
}

VectorMachine demo_machine(std::string_view phosphor) {
  VectorMachine machine = find_vector_machine("generic");
  machine.memory_words = 8192;
  machine.phosphor = phosphor;
  return machine;
}

}  // namespace kinescope
