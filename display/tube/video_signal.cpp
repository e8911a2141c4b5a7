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
  const auto is_tip = [&](int cell) {
    const double clock = first_clock + cell * step;
    return in_sync_tip(mode, clock - std::floor(clock / frame) * frame);
  };
  tips.clear();
  bool low = is_tip(0);
  if (low) tips.push_back({0, cells});
  // Neither pulses nor the gaps between broad ones are shorter than a line's pulse.
  const int stride = std::max(1, static_cast<int>(mode.horizontal.sync / step / 2));
  for (int cell = 0; cell < cells - 1;) {
    int before = cell, after = std::min(cell + stride, cells - 1);
    cell = after;
    if (is_tip(after) == low) continue;
    while (after - before > 1) {
      const int middle = (before + after) / 2;
      (is_tip(middle) == low ? before : after) = middle;
    }
    if (low) tips.back().end = after;
    if (!low) tips.push_back({after, cells});
    low = !low;
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
