#include "demos/wire_show.h"

#include <algorithm>
#include <utility>

#include "display/vector/display_processor.h"
#include "display/vector/stroke_list.h"
#include "display/vector/vector_tube.h"

namespace kinescope {
namespace {

constexpr Seconds kSlice = milliseconds(1);

class TurningList {
 public:
  TurningList(const WireRequest& request, Size size, std::vector<Word> first)
      : request_(request),
        memory_(std::max(first.size(), static_cast<std::size_t>(request.machine.memory_words))),
        processor_(request_.machine, memory_),
        tube_(request_.machine, size.width, size.height),
        words_(first.size()) {
    memory_.load(0, first);
    processor_.start(0);
  }
  TurningList(const TurningList&) = delete;
  TurningList& operator=(const TurningList&) = delete;

  const Image<LinearRgb>& expose(Seconds end, Workers& workers) {
    moves_.clear();
    while (processor_.now() < end) {
      processor_.run(std::min(end, processor_.now() + kSlice), moves_);
      if (std::exchange(refreshes_, processor_.refreshes()) != processor_.refreshes()) {
        put_next(workers);
      }
    }
    return tube_.expose(moves_, end, workers);
  }

 private:
  /// Beside the list that is being drawn.
  void put_next(Workers& workers) {
    if (request_.turn_rad_per_s == 0) return;
    const double turn_rad = request_.turn_rad_per_s * processor_.now().count();
    const std::vector<Word> next =
        stroke_list(request_.model->strokes(turn_rad, request_.style, request_.machine, workers),
                    request_.machine);
    const std::size_t at = next.size() <= at_ ? 0 : at_ + words_;
    memory_.grow(at + next.size());
    memory_.load(static_cast<Address>(at), next);
    processor_.show(static_cast<Address>(at));
    at_ = at, words_ = next.size();
  }

  WireRequest request_;
  DisplayMemory memory_;
  DisplayProcessor processor_;
  VectorTube tube_;
  std::vector<BeamMove> moves_;
  std::int64_t refreshes_ = 0;
  std::size_t at_ = 0, words_;  // of the newest list
};

}  // namespace

VectorShow wire_show(const WireRequest& request, Size size, Workers& workers) {
  DisplayFile program;
  program.words = stroke_list(request.model->strokes(0, request.style, request.machine, workers),
                              request.machine);
  VectorShow show;
  const auto list = std::make_shared<TurningList>(request, size, program.words);
  show.expose = [list](Seconds end, Workers& team) -> const Image<LinearRgb>& {
    return list->expose(end, team);
  };
  time_refresh(show, request.machine, program);
  return show;
}

}  // namespace kinescope
