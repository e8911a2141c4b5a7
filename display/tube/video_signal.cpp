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
