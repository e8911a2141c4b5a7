#include "raster/fragment_batches.h"

#include <algorithm>

namespace kinescope {

int FrameCalls::call_of(std::uint32_t id) const {
  const auto after = std::upper_bound(first_id.begin(), first_id.end(), id);
  return static_cast<int>(after - first_id.begin()) - 1;
}

std::span<const LinearRgba> FragmentShader::shade(const FrameCalls& frame,
                                                  const FragmentView& fragments,
                                                  const LinearRgba& clear) {
  const auto size = static_cast<std::size_t>(fragments.size);
  // A shader may write whole vectors past the last fragment.
  if (colours_.size() < size + Batch::kMaxSize) colours_.resize(size + Batch::kMaxSize);
  group_by_call(frame, fragments);
  for (const Group& group : groups_) {
    shade_group(frame, fragments, group, clear, colours_.data());
  }
  return {colours_.data(), size};
}

void FragmentShader::shade_call(const FrameCalls& frame, int call, const FragmentView& fragments,
                                const LinearRgba& clear, LinearRgba* out) {
  order_.clear();
  shade_group(frame, fragments, {call, 0, fragments.size, 0}, clear, out);
}

// A stable counting sort by call, over the calls that occur.
void FragmentShader::group_by_call(const FrameCalls& frame, const FragmentView& fragments) {
  groups_.clear();
  order_.clear();
  if (fragments.size == 0) return;
  if (frame.calls.size() == 1) {
    groups_.push_back({0, 0, fragments.size, 0});
    return;
  }
  const std::uint32_t* const id = fragments.id;
  const auto [least, most] = std::minmax_element(id, id + fragments.size);
  const int least_call = frame.call_of(*least);
  if (least_call == frame.call_of(*most)) {
    groups_.push_back({least_call, 0, fragments.size, 0});
    return;
  }
  group_of_call_.resize(frame.calls.size());
  group_of_fragment_.resize(static_cast<std::size_t>(fragments.size));
  std::uint32_t call_first = 1, call_end = 0, group = 0;
  for (int i = 0; i < fragments.size; ++i) {
    if (id[i] < call_first || id[i] >= call_end) {
      const auto call = static_cast<std::size_t>(frame.call_of(id[i]));
      call_first = frame.first_id[call];
      call_end = frame.first_id[call + 1];
      if (group_of_call_[call] == 0) {
        groups_.push_back({static_cast<int>(call), 0, 0, 0});
        group_of_call_[call] = static_cast<std::uint32_t>(groups_.size());
      }
      group = group_of_call_[call] - 1;
    }
    ++groups_[group].end;
    group_of_fragment_[static_cast<std::size_t>(i)] = group;
  }
  int first = 0;
  for (Group& g : groups_) {
    group_of_call_[static_cast<std::size_t>(g.call)] = 0;
    g.first = g.next = first;
    g.end = first += g.end;
  }
  order_.resize(static_cast<std::size_t>(fragments.size));
  for (int i = 0; i < fragments.size; ++i) {
    Group& g = groups_[group_of_fragment_[static_cast<std::size_t>(i)]];
    order_[static_cast<std::size_t>(g.next++)] = i;
  }
}

void FragmentShader::load(const FrameCalls& frame, const FragmentView& fragments, int call,
                          int first, int count) {
  const std::uint32_t first_id = frame.first_id[static_cast<std::size_t>(call)];
  const auto size = static_cast<std::size_t>(count);
  if (order_.empty()) {
    unpack_fragments(fragments.id + first, fragments.xy + first, first_id, count, storage_);
  } else {
    for (std::size_t i = 0; i < size; ++i) {
      const auto from = static_cast<std::size_t>(order_[static_cast<std::size_t>(first) + i]);
      storage_.x[i] = static_cast<std::uint16_t>(fragments.xy[from]);
      storage_.y[i] = static_cast<std::uint16_t>(fragments.xy[from] >> 16);
      storage_.triangle[i] = fragments.id[from] - first_id;
    }
  }
}

void FragmentShader::shade_group(const FrameCalls& frame, const FragmentView& fragments,
                                 const Group& group, const LinearRgba& clear, LinearRgba* colours) {
  const DrawCall& draw = frame.calls[static_cast<std::size_t>(group.call)];
  for (int first = group.first; first < group.end; first += Batch::kMaxSize) {
    const int size = std::min(Batch::kMaxSize, group.end - first);
    LinearRgba* const out = order_.empty() ? colours + first : shaded_.data();
    if (draw.shade == nullptr) {
      std::fill_n(out, size, clear);
    } else {
      load(frame, fragments, group.call, first, size);
      interpolate(draw, size, storage_);
      draw.shade(batch_of(draw, storage_, size), out);
    }
    if (order_.empty()) continue;
    for (int i = 0; i < size; ++i) {
      colours[order_[static_cast<std::size_t>(first + i)]] = out[i];
    }
  }
}

}  // namespace kinescope
