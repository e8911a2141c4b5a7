#include "display/tube/signal_doses.h"

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <utility>

namespace kinescope {
namespace {

bool is_met(const CellRange& range) { return range.excited && range.begin != range.end; }

/// Byte for byte: the compiler compares a struct's members one after another.
bool is_same(const std::vector<GunDrive>& a, const std::vector<GunDrive>& b) {
  static_assert(std::has_unique_object_representations_v<GunDrive>);
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(GunDrive)) == 0;
}

bool is_met_whole(const LineRanges& ranges, std::size_t cells) {
  return std::any_of(ranges.begin(), ranges.end(), [&](const CellRange& r) {
    return is_met(r) && r.begin == 0 && r.end == static_cast<int>(cells);
  });
}

}  // namespace

void SignalDoses::prepare(const RasterScan& scan, const Gun& gun, std::span<const Signal> signals,
                          const Workers& workers) {
  const int cells = scan.mode().horizontal.active, lines = scan.mode().vertical.active;
  while (doses_.size() < signals.size()) doses_.push_back({{cells, lines}, {cells, lines}});
  drives_.resize(static_cast<std::size_t>(lines));
  readings_.resize(static_cast<std::size_t>(lines), Reading::kInPart);
  const std::size_t n = static_cast<std::size_t>(cells);
  scratch_.resize(static_cast<std::size_t>(workers.count()));
  for (Scratch& s : scratch_) {
    s.drives.resize(n);
    s.narrow.resize(n);
    s.wide.resize(n);
    s.voltage.resize(n + 2 * static_cast<std::size_t>(gun.reach()) + kGroup);
  }
}

bool SignalDoses::take_changed() {
  bool changed = false;
  for (Scratch& s : scratch_) changed |= std::exchange(s.changed, false);
  return changed;
}

void SignalDoses::read(const RasterScan& scan, const Gun& gun, std::span<const Signal> signals,
                       FrameBuffer& buffer, BeamTime begin, BeamTime end, Workers& workers) {
  const int lines = scan.mode().vertical.active;
  const auto read_part = [&](BeamTime from, BeamTime to) {
    if (from >= to) return;
    workers.run(line_tasks(lines), [&](int task, int worker) {
      const int last = std::min(lines, (task + 1) * kLinesATask);
      for (int line = task * kLinesATask; line < last; ++line) {
        read_line(gun, signals, buffer, line_ranges(scan, from, to, line), line,
                  scratch_[static_cast<std::size_t>(worker)]);
      }
    });
  };
  for (BeamTime flip = scan.retrace_from(begin); flip < end;
       flip = scan.retrace_from(flip + BeamTime::from_raw(1))) {
    read_part(begin, flip);
    buffer.vertical_retrace();
    begin = flip;
  }
  read_part(begin, end);
}

void SignalDoses::read_line(const Gun& gun, std::span<const Signal> signals,
                            const FrameBuffer& buffer, const LineRanges& ranges, int line,
                            Scratch& s) {
  if (std::none_of(ranges.begin(), ranges.end(), is_met)) return;
  if (line >= buffer.height()) {
    std::fill(s.drives.begin(), s.drives.end(), GunDrive{});
  } else {
    buffer.read_line(line, s.drives);
  }
  // A line that the beam meets whole and that is what it was has its doses already.
  std::vector<GunDrive>& last = drives_[static_cast<std::size_t>(line)];
  const bool whole = is_met_whole(ranges, s.drives.size());
  Reading& reading = readings_[static_cast<std::size_t>(line)];
  reading = whole && is_same(last, s.drives) ? Reading::kSame
            : whole                          ? Reading::kWhole
                                             : Reading::kInPart;
  if (reading == Reading::kSame) return;
  s.changed = true;
  last.assign(s.drives.begin(), whole ? s.drives.end() : s.drives.begin());
  if (whole) return;
  // The other part may come from another page.
  for (std::size_t signal = 0; signal < signals.size(); ++signal) {
    gun.doses(s.drives, signals[signal], s.voltage, s.narrow.data(), s.wide.data());
    copy_ranges(ranges, line, signal, s);
  }
}

DoseRows SignalDoses::of(const Gun& gun, Signal signal, std::size_t index, int line, int worker,
                         DoseRows last) {
  const std::size_t at = static_cast<std::size_t>(line);
  if (readings_[at] == Reading::kSame) return last;
  if (readings_[at] == Reading::kInPart) {
    return {doses_[index].narrow.line(line), doses_[index].wide.line(line)};
  }
  Scratch& s = scratch_[static_cast<std::size_t>(worker)];
  gun.doses(drives_[at], signal, s.voltage, s.narrow.data(), s.wide.data());
  return {s.narrow.data(), s.wide.data()};
}

void SignalDoses::copy_ranges(const LineRanges& ranges, int line, std::size_t signal,
                              const Scratch& s) {
  for (const CellRange& range : ranges) {
    if (!is_met(range)) continue;
    std::copy(s.narrow.begin() + range.begin, s.narrow.begin() + range.end,
              doses_[signal].narrow.line(line) + range.begin);
    std::copy(s.wide.begin() + range.begin, s.wide.begin() + range.end,
              doses_[signal].wide.line(line) + range.begin);
  }
}

}  // namespace kinescope
