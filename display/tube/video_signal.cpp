#include "display/tube/video_signal.h"

#include <algorithm>
#include <cmath>

namespace kinescope {
namespace {

/// The frame's line that the video sends in its passing-th line, or -1 while it is blanked.
int picture_line(const VideoMode& mode, int passing) {
  const int active = mode.vertical.active;
  if (!mode.interlaced) return passing < active ? passing : -1;
  if (passing < (active + 1) / 2) return 2 * passing;
  const int in_second = passing - (mode.vertical.total() + 1) / 2;
  return in_second >= 0 && in_second < active / 2 ? 2 * in_second + 1 : -1;
}

void read_picture_line(const FrameBuffer& buffer, int line, std::vector<GunDrive>& out) {
  if (line < 0 || line >= buffer.height()) {
    std::fill(out.begin(), out.end(), GunDrive{});
  } else {
    buffer.read_line(line, out);
  }
}

}  // namespace

bool in_sync_tip(const VideoMode& mode, double frame_clock) {
  const SyncTiming &h = mode.horizontal, &v = mode.vertical;
  const int fields = mode.interlaced ? 2 : 1;
  const double line = h.total(), pulse = h.active + h.front_porch;
  const double since_pulse = std::fmod(frame_clock - pulse + line, line);
  const double field_line = std::fmod(frame_clock / line, static_cast<double>(v.total()) / fields);
  const double begin = static_cast<double>(v.active + v.front_porch) / fields;
  const double end = begin + static_cast<double>(v.sync) / fields;
  if (field_line < begin || field_line >= end) return since_pulse < h.sync;
  return std::fmod(since_pulse, line / 2) < line / 2 - h.sync;
}

void find_sync_tips(const VideoMode& mode, double first_clock, double step, int cells,
                    std::vector<CellSpan>& tips) {
  const double frame = static_cast<double>(mode.horizontal.total()) * mode.vertical.total();
  tips.clear();
  double clock = first_clock - std::floor(first_clock / frame) * frame;
  for (int cell = 0; cell < cells; ++cell, clock += step) {
    if (clock >= frame) clock -= frame;
    if (!in_sync_tip(mode, clock)) continue;
    if (tips.empty() || tips.back().end != cell) tips.push_back({cell, cell});
    tips.back().end = cell + 1;
  }
}

void read_video(const RasterScan& scan, const FrameBuffer& buffer, double first_clock, double step,
                std::vector<GunDrive>& line, std::span<GunDrive> drives) {
  const VideoMode& mode = scan.mode();
  const double total = mode.horizontal.total(), lines = mode.vertical.total();
  double passed = std::floor(first_clock / total);
  double pixel = first_clock - passed * total;
  const auto read = [&] {
    const int in_frame = static_cast<int>(passed - std::floor(passed / lines) * lines);
    read_picture_line(buffer, picture_line(mode, in_frame), line);
  };
  read();
  for (GunDrive& drive : drives) {
    if (pixel >= total) {
      pixel -= total;
      passed += 1;
      read();
    }
    const auto at = static_cast<std::size_t>(pixel);
    drive = at < line.size() ? line[at] : GunDrive{};
    pixel += step;
  }
}

}  // namespace kinescope
