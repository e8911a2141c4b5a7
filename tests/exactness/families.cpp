#include "tests/exactness/families.h"

#include <numbers>

#include "tests/raster/triangle_soup.h"

namespace kinescope::exactness {
namespace {

/// Square cells, `across` each way, a triangle or fan in each that reaches `reach` from its middle.
struct Sheet {
  int cell;
  float reach;
  int across;
};

void add(TriangleSoup& soup, TestVertex a, TestVertex b, TestVertex c) {
  a.z = b.z = c.z = Comparer::kDepth;
  soup.add(a, b, c);
}

/// @param shift_px  moves the sheet left and up
TriangleSoup scattered(const Sheet& sheet, unsigned seed, float shift_px) {
  RandomTriangles random(seed);
  TriangleSoup soup;
  const auto middle = [&](int i) {
    return (static_cast<float>(i) + 0.5f) * static_cast<float>(sheet.cell);
  };
  for (int row = 0; row < sheet.across; ++row) {
    for (int column = 0; column < sheet.across; ++column) {
      auto t = random.triangle(middle(column), middle(row), sheet.reach);
      for (TestVertex& v : t) v.x -= shift_px, v.y -= shift_px;
      add(soup, t[0], t[1], t[2]);
    }
  }
  return soup;
}

/// Blades around a hub that may lie upon a pixel's centre: every sample of a fan has one owner.
void add_fan(RandomTriangles& random, float x, float y, float reach, TriangleSoup& soup) {
  TestVertex hub = random.vertex(x, y, 0.0f);
  const int blades = 4 + random.below(5);
  std::vector<TestVertex> rim;
  for (int i = 0; i < blades; ++i) {
    // Jitter that turns no blade over.
    const float angle = (static_cast<float>(i) + random.between(-0.25f, 0.25f)) * 2 *
                        std::numbers::pi_v<float> / static_cast<float>(blades);
    const float radius = random.between(3.0f, reach);
    rim.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle)});
  }
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const TestVertex &a = rim[i], &b = rim[(i + 1) % rim.size()];
    random.below(2) ? add(soup, hub, a, b) : add(soup, b, a, hub);
  }
}

Tally compare_scattered(Comparer& comparer, const Sheet& sheet, unsigned seed, int samples) {
  const TriangleSoup soup = scattered(sheet, seed, 0.0f);
  const int size = sheet.cell * sheet.across;
  return comparer.compare(soup.call(nullptr), size, size, samples);
}

Tally compare_fans(Comparer& comparer, const Sheet& sheet, unsigned seed, int samples) {
  RandomTriangles random(seed);
  TriangleSoup soup;
  const auto middle = [&](int i) {
    return (static_cast<float>(i) + 0.5f) * static_cast<float>(sheet.cell);
  };
  for (int row = 0; row < sheet.across; ++row) {
    for (int column = 0; column < sheet.across; ++column) {
      add_fan(random, middle(column), middle(row), sheet.reach, soup);
    }
  }
  const int size = sheet.cell * sheet.across;
  return comparer.compare(soup.call(nullptr), size, size, samples);
}

/// The sheet hangs over all four edges of its target, and a row of cells lies outside.
Tally compare_hanging(Comparer& comparer, const Sheet& sheet, unsigned seed, int samples) {
  RandomTriangles random(seed + 1);
  const auto cell = static_cast<float>(sheet.cell);
  const float shift = cell * random.between(1.2f, 1.8f);
  const TriangleSoup soup = scattered(sheet, seed, shift);
  const int size = sheet.cell * (sheet.across - 3);
  return comparer.compare(soup.call(nullptr), size, size, samples);
}

/// Triangles drawn one by one, with corners anywhere up to the guard band, some upon its edge.
Tally compare_huge(Comparer& comparer, unsigned seed, int samples) {
  RandomTriangles random(seed);
  Tally tally;
  for (int i = 0; i < 64; ++i) {
    const float reach = std::array{200.0f, 3000.0f, 32600.0f}[static_cast<std::size_t>(i % 3)];
    auto t = random.triangle(20, 15, reach);
    constexpr float kEdge = DeviceVertex::kGuardBand;
    for (TestVertex& v : t) {
      if (random.below(8) == 0) v.x = random.below(2) ? kEdge : -kEdge;
      if (random.below(8) == 0) v.y = random.below(2) ? kEdge : -kEdge;
    }
    TriangleSoup soup;
    add(soup, t[0], t[1], t[2]);
    tally += comparer.compare(soup.call(nullptr), 40, 30, samples);
  }
  return tally;
}

}  // namespace

Tally compare(Comparer& comparer, Family family, unsigned seed, int samples) {
  const unsigned kind = seed % 3;
  constexpr Sheet kMiddling[] = {{24, 11.9f, 30}, {48, 23.9f, 12}, {150, 74.0f, 4}};
  constexpr Sheet kFans[] = {{12, 5.4f, 60}, {40, 19.0f, 12}, {160, 79.0f, 4}};
  constexpr Sheet kHanging[] = {{8, 3.9f, 24}, {24, 11.9f, 8}, {80, 39.0f, 5}};
  switch (family) {
    case Family::kTiny:
      return compare_scattered(comparer, {3, 1.4f, 200}, seed, samples);
    case Family::kSmall:
      return compare_scattered(comparer, {8, 3.9f, 130}, seed, samples);
    case Family::kMiddling:
      return compare_scattered(comparer, kMiddling[kind], seed, samples);
    case Family::kSharedEdges:
      return compare_fans(comparer, kFans[kind], seed, samples);
    case Family::kOffScreen:
      return compare_hanging(comparer, kHanging[kind], seed, samples);
    case Family::kGuardBand:
      return compare_huge(comparer, seed, samples);
  }
  return {};
}

}  // namespace kinescope::exactness
