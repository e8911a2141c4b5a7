// A camera before a tube that strokes are drawn on.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "demos/film.h"
#include "display/vector/assembler.h"
#include "display/vector/input/drawing.h"
#include "display/vector/machine.h"

namespace kinescope {

/// What stands before the camera: its light from time to time.
struct VectorShow {
  /// The light of [end of the exposure before, end); valid until the next call.
  std::function<const Image<LinearRgb>&(Seconds end, Workers& workers)> expose;
  /// When everything is to be seen that is ever drawn, and how long to gather it then; of a
  /// refreshed list: as long as a refresh.
  Seconds settled{0}, whole{1.0 / 60};
  /// Whether the last exposure was the same as the one before, and the next will be.
  std::function<bool()> still = [] { return false; };
  /// What a copier puts on paper of a storage screen; of other tubes: none.
  std::function<Image<Srgb8>()> hard_copy;
};

/// A drawing as a list that is refreshed 60 times a second, or as often as its length allows.
VectorShow refreshed_show(const VectorDrawing& drawing, Size size);
/// A drawing written once, from time 0 on, onto a storage tube.
VectorShow storage_show(const VectorDrawing& drawing, Size size);
/// A program on its machine, from time 0 on. Shows throw Error (bad input) if it stops by a fault.
/// @param name of its file
VectorShow processor_show(const VectorMachine& machine, std::shared_ptr<const DisplayFile> program,
                          Size size, const std::string& name);

/// Times a program's refresh on its machine, for the show's whole picture.
void time_refresh(VectorShow& show, const VectorMachine& machine, const DisplayFile& program);

struct VectorShot {
  FrameRange frames;
  Rate rate{60, 1};
  std::optional<Seconds>
      shutter;         ///< none: one picture of everything; a film's: as long as a frame
  bool whole = false;  ///< one picture of everything
  Seconds start{0};
  std::optional<double> gain;
  bool deep = false;
};

/// @throws Error (usage) if the shutter is longer than a frame
VectorShot vector_shot(const Options& options);

class VectorFilm {
 public:
  VectorFilm(const VectorShot& shot, VectorShow show, Workers& workers);
  Rate rate() const { return shot_.rate; }
  /// The next picture. @return false if there is none left
  bool shoot(Film& film);

 private:
  VectorShot shot_;
  VectorShow show_;
  Workers& workers_;
  int next_;
  Seconds seen_{0};  ///< until when the tube was watched
};

}  // namespace kinescope
