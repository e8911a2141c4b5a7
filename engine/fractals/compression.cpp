#include "engine/fractals/compression.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "raster/base/error.h"
#include "raster/base/workers.h"

namespace kinescope {
namespace {

constexpr float kMostContrast = 0.9f;

std::size_t place(int side, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(side) + static_cast<std::size_t>(x);
}

/// Half the size, by means of four: domains become as small as blocks.
GreySquare halved_at(const GreySquare& p, int x0, int y0, int size) {
  GreySquare half{size, {}};
  half.level.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  for (int y = y0; y < y0 + 2 * size; y += 2) {
    for (int x = x0; x < x0 + 2 * size; x += 2) {
      half.level.push_back(
          0.25f * (p.level[place(p.side, x, y)] + p.level[place(p.side, x + 1, y)] +
                   p.level[place(p.side, x, y + 1)] + p.level[place(p.side, x + 1, y + 1)]));
    }
  }
  return half;
}

/// The place in an unturned block that a turned one shows at (x, y).
std::size_t turned(int size, int turn, int x, int y) {
  if ((turn & 1) != 0) x = size - 1 - x;
  if ((turn & 2) != 0) y = size - 1 - y;
  if ((turn & 4) != 0) std::swap(x, y);
  return place(size, x, y);
}

struct Fit {
  float error, contrast, brightness;
};

/// Least squares of block = contrast * domain + brightness.
Fit fit(const std::vector<float>& domain, const std::vector<float>& block) {
  const auto n = static_cast<double>(block.size());
  double d = 0, b = 0, dd = 0, db = 0, bb = 0;
  for (std::size_t i = 0; i < block.size(); ++i) {
    d += domain[i];
    b += block[i];
    dd += domain[i] * domain[i];
    db += domain[i] * block[i];
    bb += block[i] * block[i];
  }
  const double spread = n * dd - d * d;
  double contrast = spread > 1e-9 ? (n * db - d * b) / spread : 0.0;
  contrast = std::clamp(contrast, -double{kMostContrast}, double{kMostContrast});
  const double brightness = (b - contrast * d) / n;
  const double error = bb + contrast * (contrast * dd - 2 * db + 2 * brightness * d) +
                       brightness * (n * brightness - 2 * b);
  return {static_cast<float>(error), static_cast<float>(contrast), static_cast<float>(brightness)};
}

std::vector<float> cut(const GreySquare& p, int x0, int y0, int size) {
  std::vector<float> block;
  for (int y = y0; y < y0 + size; ++y) {
    for (int x = x0; x < x0 + size; ++x) block.push_back(p.level[place(p.side, x, y)]);
  }
  return block;
}

struct Domain {
  BlockMap map;
  std::vector<float> level;
};

/// Every domain in each of its eight turns.
std::vector<Domain> all_domains(const GreySquare& picture, int block_px, int step_px) {
  std::vector<Domain> domains;
  for (int y = 0; y + 2 * block_px <= picture.side; y += step_px) {
    for (int x = 0; x + 2 * block_px <= picture.side; x += step_px) {
      const GreySquare half = halved_at(picture, x, y, block_px);
      for (int turn = 0; turn < 8; ++turn) {
        Domain domain;
        domain.map.domain_x = static_cast<std::uint16_t>(x / step_px);
        domain.map.domain_y = static_cast<std::uint16_t>(y / step_px);
        domain.map.turn = static_cast<std::uint8_t>(turn);
        for (int j = 0; j < block_px; ++j) {
          for (int i = 0; i < block_px; ++i) {
            domain.level.push_back(half.level[turned(block_px, turn, i, j)]);
          }
        }
        domains.push_back(std::move(domain));
      }
    }
  }
  return domains;
}

}  // namespace

FractalCode compress_fractally(const GreySquare& picture, int block_px, int domain_step_px,
                               Workers& workers) {
  const int side = picture.side;
  if (side < 2 || side > 4096 || block_px < 1 || side % block_px != 0 || side < 2 * block_px ||
      domain_step_px < 1 || picture.level.size() != place(side, 0, side)) {
    throw_bad_input("fractal compression takes a square of whole blocks, two or more a side");
  }
  for (const float level : picture.level) {
    if (!std::isfinite(level)) throw_bad_input("a picture to be compressed needs finite levels");
  }
  const std::vector<Domain> domains = all_domains(picture, block_px, domain_step_px);
  FractalCode code{side / block_px, block_px, domain_step_px, {}};
  code.maps.resize(place(code.blocks, 0, code.blocks));
  workers.run(static_cast<int>(code.maps.size()), [&](int index, int) {
    const int x = index % code.blocks, y = index / code.blocks;
    const std::vector<float> block = cut(picture, x * block_px, y * block_px, block_px);
    float least = INFINITY;
    for (const Domain& domain : domains) {
      const Fit f = fit(domain.level, block);
      if (!(f.error < least)) continue;
      least = f.error;
      BlockMap& map = code.maps[static_cast<std::size_t>(index)];
      map = domain.map;
      map.contrast = f.contrast;
      map.brightness = f.brightness;
    }
  });
  return code;
}

FractalDecoder::FractalDecoder(const FractalCode& code, int zoom) : code_(code), zoom_(zoom) {
  const bool fits = zoom >= 1 && zoom <= 16 && code.blocks >= 2 && code.blocks <= 4096 &&
                    code.block_px >= 1 && code.block_px <= 4096 && code.domain_step_px >= 1 &&
                    code.blocks * code.block_px <= 4096 &&
                    code.maps.size() == place(code.blocks, 0, code.blocks);
  if (!fits) throw_bad_input("this is no fractal code");
  picture.side = code.blocks * code.block_px * zoom;
  for (const BlockMap& map : code.maps) {
    const std::int64_t far = std::max(map.domain_x, map.domain_y);
    if ((far * code.domain_step_px + 2 * code.block_px) * zoom > picture.side || map.turn > 7) {
      throw_bad_input("a block of the fractal code is made of what lies outside the picture");
    }
  }
  picture.level.assign(place(picture.side, 0, picture.side), 0.5f);
}

float FractalDecoder::next() {
  const int size = code_.block_px * zoom_;
  GreySquare made{picture.side, std::vector<float>(picture.level.size())};
  float change = 0.0f;
  for (std::size_t k = 0; k < code_.maps.size(); ++k) {
    const BlockMap& map = code_.maps[k];
    const int step = code_.domain_step_px * zoom_;
    const GreySquare half = halved_at(picture, map.domain_x * step, map.domain_y * step, size);
    const int x0 = static_cast<int>(k) % code_.blocks * size;
    const int y0 = static_cast<int>(k) / code_.blocks * size;
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        const float level =
            map.contrast * half.level[turned(size, map.turn, x, y)] + map.brightness;
        const std::size_t at = place(picture.side, x0 + x, y0 + y);
        change = std::max(change, std::abs(level - picture.level[at]));
        made.level[at] = level;
      }
    }
  }
  picture = std::move(made);
  return change;
}

}  // namespace kinescope
