// How a field of a free raster leaves its light behind once others are drawn.
#include <algorithm>
#include <cmath>
#include <utility>

#include "display/decay.h"
#include "display/tube/free_raster.h"
#include "display/tube/line_ranges.h"

namespace kinescope {
namespace {

constexpr double kLeastLeft = 1e-7;  // share of a term that passes to the afterglow
constexpr float kLeastLit = 1e-7f;   // of white; a field that leaves shows no less

void clear(LayerLight& light, int line, int cells) {
  std::fill_n(light.narrow.line(line), cells, 0.0f);
  std::fill_n(light.wide.line(line), cells, 0.0f);
}

}  // namespace

void FreeRaster::darken(LayerLight& light, Workers& workers) const {
  workers.run(line_tasks(lines_), [&](int task, int) {
    const int stop = std::min(lines_, (task + 1) * kLinesATask);
    for (int line = task * kLinesATask; line < stop; ++line) clear(light, line, cells_);
  });
}

/// What a term still has to give now, of each cell.
void FreeRaster::left_of(Field& field, std::size_t layer, std::size_t term, LayerLight& light,
                         Workers& workers) const {
  workers.run(line_tasks(lines_), [&](int task, int) {
    const int stop = std::min(lines_, (task + 1) * kLinesATask);
    for (int line = task * kLinesATask; line < stop; ++line) {
      clear(light, line, cells_);
      if (line >= field.swept.lines) continue;
      const BeamTime at = line_begin(field.swept, line);
      const CellRange begun{0, cells_begun(now_ - at, cells_), to_clocks(now_ - at), false, 0};
      field.phosphor[layer].leave(term, line, begun,
                                  {light.narrow.line(line), light.wide.line(line)});
    }
  });
}

std::pair<int, int> FreeRaster::lit_lines(const LayerLight& light) const {
  const auto is_lit = [&](int line) {
    const auto bright = [](float l) { return std::abs(l) > kLeastLit; };
    const float *narrow = light.narrow.line(line), *wide = light.wide.line(line);
    return std::any_of(narrow, narrow + cells_, bright) || std::any_of(wide, wide + cells_, bright);
  };
  int begin = 0, end = lines_;
  while (begin < end && !is_lit(begin)) ++begin;
  while (end > begin && !is_lit(end - 1)) --end;
  return {begin, end};
}

/// Takes `share` of one field's light off another's.
void FreeRaster::take_off(LayerLight& from, const LayerLight& light, double share,
                          Workers& workers) const {
  workers.run(line_tasks(lines_), [&](int task, int) {
    const int stop = std::min(lines_, (task + 1) * kLinesATask);
    for (int line = task * kLinesATask; line < stop; ++line) {
      const auto less = static_cast<float>(-share);
      add_scaled(cells_, less, light.narrow.line(line), from.narrow.line(line));
      add_scaled(cells_, less, light.wide.line(line), from.wide.line(line));
    }
  });
}

/// Lays the field's light of this pass on the faceplate, if there is a sum for it, and hands over
/// what is left: all at once, for the lines lie alike. Of a field that was drawn before this pass,
/// what a term gave in it is a multiple of what it has left, and needs no spreading of its own.
void FreeRaster::leave(Field& field, const GunRasters& rasters, const Faceplate& faceplate,
                       LightOverlay* sum, Afterglow& afterglow, Workers& workers) {
  const BeamTime drawn = line_begin(field.swept, field.swept.lines);
  const double since_last_s =
      std::max(0.0, to_clocks(now_ - drawn + clocks(1))) / sweep_.clock_hz();
  const bool only_fades = sum && pass_begin_ >= drawn;
  const double passed_s = to_clocks(now_ - pass_begin_) / sweep_.clock_hz();
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    const std::vector<DecayTerm>& terms = laws_[i].terms;
    while (leaving_.size() < terms.size()) {
      leaving_.push_back({{cells_, lines_}, {cells_, lines_}});
    }
    std::vector<Faceplate::Spread> spreads;
    for (std::size_t term = 0; term < terms.size(); ++term) {
      const double tau_s = terms[term].tau.count();
      const double left = decayed(since_last_s, tau_s).left;
      if (left * terms[term].share < kLeastLeft) continue;
      left_of(field, i, term, leaving_[term], workers);
      const Afterglow::Opened opened = afterglow.open(i, term);
      double seen = static_cast<double>(opened.seen);
      if (only_fades) {
        const double given = std::expm1(passed_s / tau_s);
        take_off(field.light[i], leaving_[term], given, workers);
        seen += given;
      }
      spreads.push_back({&leaving_[term],
                         {{{&opened.to_come, opened.scale},
                           {sum ? &(*sum)[i] : nullptr, static_cast<float>(seen)}}}});
    }
    if (sum) {
      const auto [begin, end] = lit_lines(field.light[i]);
      if (begin < end) spreads.push_back({&field.light[i], {{{&(*sum)[i], 1}}}, begin, end});
    }
    faceplate.spread(rasters, i, spreads, workers);
    darken(field.light[i], workers);
  }
}

void FreeRaster::leave(const Faceplate& faceplate, Afterglow& afterglow, Workers& workers) {
  for (Field& field : fields_) {
    leave(field, *faceplate.bent(field.warp), faceplate, nullptr, afterglow, workers);
  }
  fields_.clear();
}

}  // namespace kinescope
