#include "demos/paintings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace kinescope {
namespace {

constexpr float kTwoPi = 2 * std::numbers::pi_v<float>;

float fraction(float v) { return v - std::floor(v); }

/// Uniform in [0, 1), the same everywhere (the library's distributions are not).
float uniform(std::mt19937_64& random) { return static_cast<float>(random() >> 40) * 0x1p-24f; }

}  // namespace

void paint_plasma(int width, int height, std::uint64_t seed, const StoreValue& store) {
  struct Wave {
    float along_x, along_y, phase;
  };
  std::mt19937_64 random(seed);
  std::array<Wave, 6> waves{};
  for (Wave& wave : waves) {
    const float turn = uniform(random) * kTwoPi, cycles = 0.7f + 2.2f * uniform(random);
    wave = {std::cos(turn) * cycles, std::sin(turn) * cycles, uniform(random)};
  }
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float u = static_cast<float>(x) / static_cast<float>(height);
      const float v = static_cast<float>(y) / static_cast<float>(height);
      float sum = 0, bend = 0;
      for (const Wave& w : waves) {
        const float s = std::sin(kTwoPi * (w.along_x * u + w.along_y * v + w.phase) + bend);
        sum += s;
        bend += 0.6f * s;  // each wave is bent by those before it
      }
      store(x, y, fraction(sum * 0.22f + 0.5f));
    }
  }
}

void paint_rings(int width, int height, std::uint64_t seed, const StoreValue& store) {
  struct Centre {
    float x, y, pitch;
  };
  std::mt19937_64 random(seed);
  std::array<Centre, 3> centres{};
  const auto w = static_cast<float>(width), h = static_cast<float>(height);
  for (Centre& c : centres) {
    c = {w * (0.15f + 0.7f * uniform(random)), h * (0.15f + 0.7f * uniform(random)),
         h * (0.16f + 0.12f * uniform(random))};
  }
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      float sum = 0;
      for (const Centre& c : centres) {
        sum += std::hypot(static_cast<float>(x) - c.x, static_cast<float>(y) - c.y) / c.pitch;
      }
      store(x, y, fraction(sum * 0.5f));
    }
  }
}

void paint_ball(int width, int height, Seconds now, const StoreValue& store) {
  const auto w = static_cast<float>(width), h = static_cast<float>(height);
  const float radius = h * 0.17f;
  // To and fro at a constant speed, and in arcs of a quarter second each way.
  const float there = fraction(static_cast<float>(std::fmod(now.count() * 0.55, 1.0)));
  const float bounce = fraction(static_cast<float>(std::fmod(now.count() * 1.1, 1.0)));
  const float cx = radius + (w - 2 * radius) * (1 - std::abs(2 * there - 1));
  const float cy = h * 0.92f - radius - h * 0.5f * 4 * bounce * (1 - bounce);
  const float spin = there * 6;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float dx = (static_cast<float>(x) - cx) / radius,
                  dy = (static_cast<float>(y) - cy) / radius;
      const float r2 = dx * dx + dy * dy;
      if (r2 < 1) {
        const float depth = std::sqrt(1 - r2);
        const bool patch = fraction(std::asin(dx) * 1.3f + spin) < 0.5f;
        store(x, y, 0.55f + 0.3f * depth * depth + (patch ? 0.1f : 0.0f));
      } else {
        const bool pillar = (x + 40) % 160 < 26;
        const float sky = 0.05f + 0.3f * static_cast<float>(y) / h;
        store(x, y, pillar ? sky + 0.1f : sky);
      }
    }
  }
}

GunDrive table_colour(double place, int palette) {
  // Three cosines out of step.
  constexpr std::array<std::array<double, 3>, 2> kPhases = {{{0.0, 0.1, 0.22}, {0.75, 0.42, 0.55}}};
  const auto drive = [&](double phase) {
    const double wave = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * (place + phase));
    return static_cast<std::uint8_t>(std::lround(12 + 240 * wave));
  };
  const auto& phase = kPhases[static_cast<std::size_t>(palette)];
  return {drive(phase[0]), drive(phase[1]), drive(phase[2])};
}

}  // namespace kinescope
