#include "raster/kernels/ordered_triangles.h"

#include <algorithm>
#include <array>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/kernels/ordered_triangles.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/kernels/lanes-inl.h"
#include "raster/kernels/pack-inl.h"
#include "raster/kernels/sample_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace kinescope::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The edges over a rectangle: at column k of row r an edge's sign is that of step_x k + step_y r +
/// start, each sample with a start of its own, all divided by 256 (rounding down keeps the sign,
/// and steps of whole pixels stay whole). An edge that crosses a rectangle of at most 64x64 pixels
/// fits 32 bits there; beyond it, values may wrap, where nobody looks. One that does not cross is
/// left at zero, which is inside.
template <int kSamples>
struct EdgesOver {
  std::array<std::int32_t, 3> step_x{}, step_y{};
  std::array<std::array<std::int32_t, std::max(kSamples, 8)>, 3> start{};
};

/// False if nothing in the rectangle is covered.
template <int kSamples>
HWY_INLINE bool find_edges(const TriangleRecord& t, const PixelRect& rect,
                           std::span<const SampleOffset> pattern, EdgesOver<kSamples>& out) {
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = a == 2 ? 0 : a + 1;
    const std::int32_t dx = t.x[b] - t.x[a], dy = t.y[b] - t.y[a];
    const bool top_left = dy < 0 || (dy == 0 && dx > 0);
    const std::int64_t along_x = -std::int64_t{dy} * (rect.x1 - rect.x0 - 1);
    const std::int64_t along_y = std::int64_t{dx} * (rect.y1 - rect.y0 - 1);
    const std::int64_t corner = dx * (std::int64_t{rect.y0} * 256 - t.y[a]) -
                                dy * (std::int64_t{rect.x0} * 256 - t.x[a]) - (top_left ? 0 : 1);
    std::array<std::int64_t, kSamples> start;
    for (std::size_t s = 0; s < kSamples; ++s) {
      start[s] = (corner + std::int64_t{dx} * pattern[s].y.raw() -
                  std::int64_t{dy} * pattern[s].x.raw()) >>
                 8;
    }
    const auto [lowest, highest] = std::minmax_element(start.begin(), start.end());
    const std::int64_t least =
        *lowest + std::min<std::int64_t>(along_x, 0) + std::min<std::int64_t>(along_y, 0);
    const std::int64_t most =
        *highest + std::max<std::int64_t>(along_x, 0) + std::max<std::int64_t>(along_y, 0);
    if (most < 0) return false;
    const bool crosses = least < 0;
    out.step_x[a] = crosses ? -dy : 0;
    out.step_y[a] = crosses ? dx : 0;
    for (std::size_t s = 0; s < kSamples; ++s) {
      out.start[a][s] = crosses ? static_cast<std::int32_t>(start[s]) : 0;
    }
  }
  return true;
}

/// A triangle in a rectangle of the tile.
template <int kSamples>
struct Drawn {
  HWY_INLINE Drawn(const TriangleRecord& t, const PixelRect& r)
      : rect(r),
        id(t.id),
        z0(t.z),
        dz_dx(t.dz_dx),
        dz_dy(t.dz_dy),
        nearest(t.nearest),
        farthest(t.farthest),
        anchor_x(Fixed24_8::from_raw(t.x[0]).to_float()),
        anchor_y(Fixed24_8::from_raw(t.y[0]).to_float()) {}

  PixelRect rect;
  EdgesOver<kSamples> edges;
  std::uint32_t id;
  float z0, dz_dx, dz_dy, nearest, farthest, anchor_x, anchor_y;
};

/// The lanes of all parts of a pixel.
template <class Lanes, int... kPart>
HWY_INLINE std::array<Lanes, sizeof...(kPart)> lanes_of(std::span<const SampleOffset> pattern,
                                                        std::integer_sequence<int, kPart...>) {
  return {Lanes(pattern, kPart)...};
}

/// One vector of samples, row by row down a column of the tile.
template <class Lanes>
struct Column {
  Column() = default;
  HWY_INLINE Column(const Drawn<Lanes::kSamples>& t, const Lanes& lanes, int x, int y,
                    const TileBuffer& tile) {
    const F f;
    const I i;
    const VI column = hn::Add(lanes.column, hn::Set(i, x));
    inside =
        hn::And(hn::Gt(column, hn::Set(i, t.rect.x0 - 1)), hn::Lt(column, hn::Set(i, t.rect.x1)));
    const VI k = hn::Sub(column, hn::Set(i, t.rect.x0));
    VI edge[3];
    for (std::size_t e = 0; e < 3; ++e) {
      VI start;
      if constexpr (Lanes::kSamples == 1) {
        start = hn::Set(i, t.edges.start[e][0]);
      } else if constexpr (Lanes::kSamples < Lanes::kLanes) {
        start = hn::LoadDup128(i, t.edges.start[e].data());
      } else {
        start = hn::LoadU(i, t.edges.start[e].data() + lanes.part * Lanes::kLanes);
      }
      edge[e] = hn::Add(start, hn::Mul(k, hn::Set(i, t.edges.step_x[e])));
      step[e] = hn::Set(i, t.edges.step_y[e]);
    }
    a = edge[0];
    b = edge[1];
    c = edge[2];
    const VF px = hn::Add(hn::ConvertTo(f, column), lanes.x_px);
    column_z = hn::Mul(hn::Set(f, t.dz_dx), hn::Sub(px, hn::Set(f, t.anchor_x)));
    // Exact: rows are below 2^15 and samples lie in sixteenths.
    py = hn::Add(hn::Set(f, static_cast<float>(y)), lanes.y_px);
    at = lanes.place(tile, x, y);
  }

  HWY_INLINE hn::Mask<I> covered() const {
    const I i;
    return hn::And(inside, hn::Gt(hn::Or(hn::Or(a, b), c), hn::Set(i, -1)));
  }
  HWY_INLINE VF depth(const Drawn<Lanes::kSamples>& t) const {
    const F f;
    const VF row = hn::Add(hn::Set(f, t.z0),
                           hn::Mul(hn::Set(f, t.dz_dy), hn::Sub(py, hn::Set(f, t.anchor_y))));
    return hn::Min(hn::Max(hn::Add(row, column_z), hn::Set(f, t.nearest)), hn::Set(f, t.farthest));
  }
  HWY_INLINE void next_row(std::size_t stride) {
    a = hn::Add(a, step[0]);
    b = hn::Add(b, step[1]);
    c = hn::Add(c, step[2]);
    py = hn::Add(py, hn::Set(F(), 1.0f));
    at += stride;
  }

  hn::Mask<I> inside;
  VI a, b, c;  ///< the edges
  VI step[3];
  VF column_z, py;
  std::size_t at;  ///< in the tile's samples
};

/// A depth test as masks over whole vectors.
struct Test {
  explicit HWY_INLINE Test(DepthTest test)
      : less(bit(test, 1)), equal(bit(test, 2)), greater(bit(test, 4)) {}
  HWY_INLINE hn::Mask<F> operator()(VF z, VF stored) const {
    return hn::Or(hn::And(hn::Lt(z, stored), less),
                  hn::Or(hn::And(hn::Eq(z, stored), equal), hn::And(hn::Gt(z, stored), greater)));
  }

 private:
  static HWY_INLINE hn::Mask<F> bit(DepthTest test, int b) {
    const F f;
    return first_lanes(f, (static_cast<int>(test) & b) != 0 ? hn::Lanes(f) : 0);
  }
  hn::Mask<F> less, equal, greater;
};

/// Tests covered samples, and writes those that pass if asked to.
HWY_INLINE hn::Mask<F> test_samples(hn::Mask<I> covered, VF z, std::uint32_t id, std::size_t at,
                                    const Test& test, bool write, TileBuffer& tile) {
  const F f;
  const U u;
  const VF stored = hn::Load(f, tile.depth.data() + at);
  const auto passed = hn::And(hn::RebindMask(f, covered), test(z, stored));
  if (write && !hn::AllFalse(f, passed)) {
    hn::Store(hn::IfThenElse(passed, z, stored), f, tile.depth.data() + at);
    const VU old_id = hn::Load(u, tile.id.data() + at);
    hn::Store(hn::IfThenElse(hn::RebindMask(u, passed), hn::Set(u, id), old_id), u,
              tile.id.data() + at);
  }
  return passed;
}

/// Pixels of one sample: whole vectors are appended, packed.
HWY_INLINE void draw_pixels(const Drawn<1>& t, const SampleLanes<1>& lanes, const Test& test,
                            DepthUse use, TileBuffer& tile, OrderedFragments& out) {
  using Lanes = SampleLanes<1>;
  const I i;
  const U u;
  const auto stride = static_cast<std::size_t>(tile.stride);
  std::size_t n = static_cast<std::size_t>(out.size);
  std::uint32_t* const xy = out.xy.data();
  std::uint32_t* const ids = out.id.data();
  float* const depth = out.depth.data();
  const VU id = hn::Set(u, t.id), next_row = hn::Set(u, 1u << 16);
  for (int x = t.rect.x0 & -Lanes::kPixels; x < t.rect.x1; x += Lanes::kPixels) {
    Column<Lanes> column(t, lanes, x, t.rect.y0, tile);
    VU place =
        lanes_from(u, static_cast<std::uint32_t>(t.rect.y0) << 16 | static_cast<std::uint32_t>(x));
    for (int y = t.rect.y0; y < t.rect.y1; ++y) {
      const auto covered = column.covered();
      if (!hn::AllFalse(i, covered)) {
        const VF z = column.depth(t);
        const Packer<F> pack(test_samples(covered, z, t.id, column.at, test, use.write, tile));
        pack.store(place, xy + n);
        hn::StoreU(id, u, ids + n);
        if (use.keep) pack.store(z, depth + n);
        n += pack.count();
      }
      place = hn::Add(place, next_row);
      column.next_row(stride);
    }
  }
  out.size = static_cast<int>(n);
}

/// Pixels of several samples: one fragment a pixel, with a bit for each sample.
template <int kSamples>
HWY_INLINE void draw_samples(const Drawn<kSamples>& t, const SampleLanes<kSamples>* lanes,
                             const Test& test, DepthUse use, TileBuffer& tile,
                             OrderedFragments& out) {
  using Lanes = SampleLanes<kSamples>;
  constexpr std::uint32_t kAll = (1u << kSamples) - 1, kPixels = Lanes::kPixels;
  constexpr std::uint32_t kAllPixels = (1u << (kPixels * kSamples)) - 1;
  const F f;
  const auto stride = static_cast<std::size_t>(tile.stride * kSamples);
  auto n = static_cast<std::size_t>(out.size);
  alignas(64) std::array<float, Lanes::kParts * Lanes::kLanes> depths{};
  Column<Lanes> column[Lanes::kParts];
  for (int x = t.rect.x0 & -Lanes::kPixels; x < t.rect.x1; x += Lanes::kPixels) {
    for (int part = 0; part < Lanes::kParts; ++part) {
      column[part] = Column<Lanes>(t, lanes[part], x, t.rect.y0, tile);
    }
    for (int y = t.rect.y0; y < t.rect.y1; ++y) {
      std::uint32_t bits = 0;
      for (int part = 0; part < Lanes::kParts; ++part) {
        Column<Lanes>& c = column[part];
        const auto covered = c.covered();
        if (!hn::AllFalse(I(), covered)) {
          const VF z = c.depth(t);
          const auto passed = test_samples(covered, z, t.id, c.at, test, use.write, tile);
          std::uint8_t of_part = 0;
          hn::StoreMaskBits(f, passed, &of_part);
          bits |= static_cast<std::uint32_t>(of_part) << (part * Lanes::kLanes);
          if (use.keep) hn::Store(z, f, depths.data() + part * Lanes::kLanes);
        }
        c.next_row(stride);
      }
      if (bits == 0) continue;
      const std::uint32_t xy = static_cast<std::uint32_t>(y) << 16 | static_cast<std::uint32_t>(x);
      if (bits == kAllPixels) {
        for (std::uint32_t p = 0; p < kPixels; ++p) {
          out.id[n + p] = t.id;
          out.xy[n + p] = xy + p;
          out.samples[n + p] = static_cast<std::uint8_t>(kAll);
        }
        if (use.keep) std::copy_n(depths.data(), depths.size(), out.depth.data() + n * kSamples);
        n += kPixels;
        continue;
      }
      for (std::uint32_t p = 0; p < kPixels; ++p) {
        const std::uint32_t of_pixel = (bits >> (p * kSamples)) & kAll;
        // Written either way: a store costs less than a branch that nobody can predict.
        out.id[n] = t.id;
        out.xy[n] = xy + p;
        out.samples[n] = static_cast<std::uint8_t>(of_pixel);
        if (use.keep) {
          std::copy_n(depths.data() + p * kSamples, kSamples, out.depth.data() + n * kSamples);
        }
        n += of_pixel != 0 ? 1 : 0;
      }
    }
  }
  out.size = static_cast<int>(n);
}

template <int kSamples>
HWY_INLINE std::size_t draw_all(std::span<const TriangleRecord* const> records, DepthUse use,
                                const PixelRect& clip, std::span<const SampleOffset> pattern,
                                int limit, TileBuffer& tile, OrderedFragments& out) {
  using Lanes = SampleLanes<kSamples>;
  const Test test(use.test);
  std::array<Lanes, Lanes::kParts> lanes =
      lanes_of<Lanes>(pattern, std::make_integer_sequence<int, Lanes::kParts>());
  std::size_t done = 0;
  for (; done < records.size() && out.size < limit; ++done) {
    const TriangleRecord& t = *records[done];
    const PixelRect rect = intersection({t.x0, t.y0, t.x1, t.y1}, clip);
    if (rect.empty()) continue;
    Drawn<kSamples> drawn(t, rect);
    if (!find_edges(t, rect, pattern, drawn.edges)) continue;
    if constexpr (kSamples == 1) {
      draw_pixels(drawn, lanes[0], test, use, tile, out);
    } else {
      draw_samples(drawn, lanes.data(), test, use, tile, out);
    }
  }
  return done;
}

std::size_t DrawOrderedRecords(std::span<const TriangleRecord* const> records, DepthUse use,
                               const PixelRect& clip, std::span<const SampleOffset> pattern,
                               int limit, TileBuffer& tile, OrderedFragments& out) {
  switch (pattern.size()) {
    case 1:
      return draw_all<1>(records, use, clip, pattern, limit, tile, out);
    case 4:
      return draw_all<4>(records, use, clip, pattern, limit, tile, out);
    default:
      return draw_all<8>(records, use, clip, pattern, limit, tile, out);
  }
}

}  // namespace kinescope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace kinescope {

HWY_EXPORT(DrawOrderedRecords);

std::size_t draw_ordered_records(std::span<const TriangleRecord* const> records, DepthUse use,
                                 const PixelRect& clip, std::span<const SampleOffset> pattern,
                                 int limit, TileBuffer& tile, OrderedFragments& out) {
  return HWY_DYNAMIC_DISPATCH(DrawOrderedRecords)(records, use, clip, pattern, limit, tile, out);
}

}  // namespace kinescope
#endif
