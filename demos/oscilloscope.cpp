// An oscilloscope in XY mode: two sines, or the two channels of a sound.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string_view>
#include <vector>

#include "demos/demo.h"
#include "display/light_encode.h"
#include "display/vector/input/wav_reader.h"
#include "display/vector/machine.h"
#include "display/vector/vector_tube.h"

namespace kinescope {
namespace {

enum { kSource, kAcross, kUp, kDrift, kFocus };

constexpr int kRate = 48000;

VectorMachine scope(double focus) {
  VectorMachine machine = find_vector_machine("generic");
  machine.width = machine.height = 70000;
  machine.phosphor = "P31";
  machine.screen_mm = 100;
  machine.spot_sigma_mm = 0.15 * focus;
  machine.speed_units_us = 12;
  return machine;
}

/// A second of stereo sound, 16 bits, as a file holds it: a star that turns and breathes.
std::vector<std::uint8_t> star_wav() {
  std::vector<std::uint8_t> bytes;
  const auto put = [&](std::uint32_t value, int count) {
    for (int i = 0; i < count; ++i) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  };
  const auto name = [&](std::string_view four) {
    for (const char c : four) bytes.push_back(static_cast<std::uint8_t>(c));
  };
  constexpr std::uint32_t kBytes = kRate * 4;
  name("RIFF"), put(36 + kBytes, 4), name("WAVE"), name("fmt "), put(16, 4), put(1, 2), put(2, 2);
  put(kRate, 4), put(kBytes, 4), put(4, 2), put(16, 2), name("data"), put(kBytes, 4);
  for (int i = 0; i < kRate; ++i) {
    const double turn = 2 * std::numbers::pi * i / kRate;
    const double r = 17000 + 9000 * std::sin(300 * turn) + 3000 * std::sin(2 * turn);
    put(static_cast<std::uint16_t>(std::lround(r * std::cos(61 * turn))), 2);
    put(static_cast<std::uint16_t>(std::lround(r * std::sin(61 * turn))), 2);
  }
  return bytes;
}

class Oscilloscope : public ClonableDemo<Oscilloscope> {
 public:
  explicit Oscilloscope(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {choice_knob("source", {"r"}, {"sines", "sound"}, 0, "what moves the beam"),
             number_knob("across", "1", "2", 50, 500, 10, 150, "Hz",
                         "the sine that moves it across"),
             number_knob("up", "3", "4", 50, 500, 10, 100, "Hz", "the sine that moves it up"),
             number_knob("drift", "5", "6", -1, 1, 0.1, 0.2, "Hz",
                         "by how much the second is off its frequency"),
             number_knob("focus", "-", "=", 0.5, 4, 0.5, 1, "", "width of the spot")}),
        sound_(std::make_shared<VectorDrawing>(read_wav(star_wav(), "star.wav"))),
        tube_(scope(1), setup.width, setup.height) {}
  std::size_t state_bytes() const override {
    return static_cast<std::size_t>(width()) * static_cast<std::size_t>(height()) * 40;
  }

 private:
  void resized() override { tube_ = VectorTube(scope(knob(kFocus).value), width(), height()); }

  void update(const Step& step) override {
    if (focus_ != knob(kFocus).value) resized();
    focus_ = knob(kFocus).value;
    // Phases run on when a frequency is turned.
    begin_ = {across_, up_};
    across_ += knob(kAcross).value * step.exposure.length().count();
    up_ += (knob(kUp).value + knob(kDrift).value) * step.exposure.length().count();
  }

  glm::dvec2 sines(double part) const {
    constexpr double kTurn = 2 * std::numbers::pi, kSize = 26000;
    return {35000 + kSize * std::sin(kTurn * std::lerp(begin_[0], across_, part)),
            35000 + kSize * std::sin(kTurn * std::lerp(begin_[1], up_, part))};
  }

  void draw(const Step& step, Image<Srgb8>& picture) override {
    const Exposure& e = step.exposure;
    std::vector<BeamMove> moves;
    const auto first = static_cast<std::int64_t>(std::ceil(e.begin.count() * kRate - 1e-6));
    const auto last = static_cast<std::int64_t>(std::ceil(e.end.count() * kRate - 1e-6));
    for (std::int64_t i = first; i < last; ++i) {
      BeamMove move;
      move.begin = Seconds(static_cast<double>(i) / kRate);
      move.end = Seconds(static_cast<double>(i + 1) / kRate);
      move.intensity = 1;  // a fast beam is dim by itself
      if (knob(kSource).index() == 0) {
        const glm::dvec2 a = sines((move.begin - e.begin) / e.length());
        const glm::dvec2 b = sines((move.end - e.begin) / e.length());
        move.x0 = a.x, move.y0 = a.y, move.x1 = b.x, move.y1 = b.y;
      } else {
        const auto n = static_cast<std::int64_t>(sound_->segments.size());
        const VectorSegment& s = sound_->segments[static_cast<std::size_t>(i % n)];
        move.x0 = s.x1 + 35000.0, move.y0 = s.y1 + 35000.0;
        move.x1 = s.x2 + 35000.0, move.y1 = s.y2 + 35000.0;
      }
      moves.push_back(move);
    }
    const Image<LinearRgb>& light = tube_.expose(moves, e.end, studio().workers);
    const double part = std::clamp(e.length().count() * 60, 1.0 / 64, 1.0);
    encode_light(light, ExposureGain::fixed(static_cast<float>(1 / part)), studio().workers,
                 picture);
  }

  std::shared_ptr<const VectorDrawing> sound_;
  VectorTube tube_;
  double across_ = 0, up_ = 0.1, focus_ = 1;  // turns
  std::array<double, 2> begin_{};
};

std::unique_ptr<Demo> create(const DemoSetup& setup) {
  return std::make_unique<Oscilloscope>(setup);
}

}  // namespace

DemoInfo oscilloscope_demo() {
  return {"oscilloscope",
          "1 Displays and coordinates",
          "Lissajous figures, and stereo sound as its two channels draw it",
          create,
          1,
          {},
          {"random scan: deflection by signals"}};
}

}  // namespace kinescope
