#include "bench/peer_agg.h"

#include <agg_pixfmt_rgba.h>
#include <agg_rasterizer_outline_aa.h>
#include <agg_renderer_base.h>
#include <agg_renderer_outline_aa.h>
#include <agg_rendering_buffer.h>

#include <vector>

namespace kinescope::bench {

struct AggLines::State {
  using Base = agg::renderer_base<agg::pixfmt_rgba32>;
  using Renderer = agg::renderer_outline_aa<Base>;

  State(int width, int height, float width_px)
      : picture(width, height),
        buffer(&picture.pixels().data()->r, static_cast<unsigned>(width),
               static_cast<unsigned>(height), width * 4),
        format(buffer),
        base(format),
        profile(width_px, agg::gamma_none()),
        renderer(base, profile),
        rasterizer(renderer) {
    renderer.clip_box(0, 0, width, height);
  }

  Image<Linear8> picture;
  agg::rendering_buffer buffer;
  agg::pixfmt_rgba32 format;
  Base base;
  agg::line_profile_aa profile;
  Renderer renderer;
  agg::rasterizer_outline_aa<Renderer> rasterizer;
};

AggLines::AggLines(int width, int height, float width_px)
    : state_(std::make_unique<State>(width, height, width_px)) {}
AggLines::~AggLines() = default;

void AggLines::draw(std::span<const InkedLine> lines) {
  State& s = *state_;
  for (const InkedLine& line : lines) {
    const LinearRgba c = line.colour;
    s.renderer.color(agg::rgba(c.r, c.g, c.b, c.a));
    s.rasterizer.move_to_d(line.segment.from.x, line.segment.from.y);
    s.rasterizer.line_to_d(line.segment.to.x, line.segment.to.y);
    s.rasterizer.render(false);
  }
}

void AggLines::clear() { state_->base.clear(agg::rgba(0, 0, 0, 1)); }

Image<Linear8> AggLines::picture() const { return state_->picture; }

}  // namespace kinescope::bench
