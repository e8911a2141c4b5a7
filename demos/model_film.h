// A film, or one picture, of a model: bare, or through a tube.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "demos/film.h"
#include "demos/machine.h"
#include "demos/model_view.h"
#include "demos/options.h"
#include "demos/tube_film.h"

namespace kinescope {

/// Everything about a film that follows from the options.
struct ModelFilmPlan {
  Size size;   ///< of the pictures
  Size drawn;  ///< of what is rasterized: the mode's, or `size` when bare
  bool bare = true;
  TubeSettings tube;  ///< when bare: the default one, for a window that switches it on
  Rate rate;
  FrameRange frames;
  Seconds shutter{0};  ///< unless bare
  double turn_rad_per_s = 0;
  bool several() const { return frames.count() > 1; }
};

/// @throws Error (usage) on options that do not go together
ModelFilmPlan plan_model_film(const Options& options);

/// @throws Error (usage) if the pictures need more memory than there is
void check_memory(const ModelFilmPlan& plan, const Options& options);

class ModelFilm {
 public:
  struct FrameFigures {
    int frame = 0;
    RenderStats stats;
    std::uint64_t colour_hash = 0;   ///< of the rasterized picture
    std::uint64_t picture_hash = 0;  ///< of the picture written; 0 for 16 bits a channel
  };

  ModelFilm(ModelView& view, const ModelFilmPlan& plan, const Options& options, Workers& workers);

  /// Makes the next frame and writes it, if `film` is given.
  void shoot(Film* film);
  const std::vector<FrameFigures>& figures() const { return figures_; }
  /// "frame_ms" and "stages_ms".
  void write_times(JsonWriter& json) const;

 private:
  void draw(double turn_rad);
  void shoot_bare(Film* film, int frame);
  void shoot_tube(Film* film, int frame);
  template <typename Pixel>
  void finish(Film* film, int frame, const Image<Pixel>& picture);

  ModelView& view_;
  ModelFilmPlan plan_;
  bool deep_;
  bool want_hashes_;
  Workers& workers_;
  RenderTarget target_;
  std::unique_ptr<TubeFilm> tube_film_;
  RenderStats last_stats_;
  std::uint64_t last_colour_hash_ = 0;
  std::vector<FrameFigures> figures_;
  Stopwatch frame_, draw_, write_;
};

}  // namespace kinescope
