// The tube's inner loops, each over a row of floats, compiled for every instruction set.
#pragma once

#include <span>

#include "display/frame_buffer.h"

namespace kinescope {

/// out[i] += scale * a[i]
void add_scaled(int n, float scale, const float* a, float* out);

/// out[i] += scale * a[i] * (constant + slope * b[i])
void add_scaled_product(int n, float scale, const float* a, float constant, float slope,
                        const float* b, float* out);

/// light[i] += state[i] * scale * table[i]
void add_light(int n, float scale, const float* table, const float* state, float* light);

/// One slow term of cells that the beam excites: the weights of its light before and after.
struct SlowTermStep {
  float keep, gain;                                ///< state' = keep * state + gain * old dose
  float old_scale, old_constant, old_slope;        ///< of old_decay[i] * (constant + slope * grown)
  float new_constant, new_slope;                   ///< of the new state's light
  const float *old_decay, *old_grown, *new_grown;  ///< tables
};
void excite_slow_term(int n, const SlowTermStep& step, const float* old_dose, float* state,
                      float* light);

/// light += old weight * dose + (even + new weight) * new dose; then dose = new dose.
void excite_dose(int n, const float* old_weight, float even, const float* new_weight,
                 const float* new_dose, float* dose, float* light);

/// out[3 i + c] = sum over layers of light[layer][i] * colour[layer][c]; one to three layers.
void mix_layers(int n, std::span<const float* const> light, const float (*colour)[3], float* out);

/// out[3 X + c] = sum over taps of weight[X * taps + t] * in[3 * (start[X] + t) + c]. Both rows
/// need a spare float at their end.
void spread_across(int width, int taps, const int* start, const float* weight, const float* in,
                   float* out);

/// out[i] = sum over rows of weight[r] * rows[r][i]
void spread_down(int n, std::span<const float* const> rows, const float* weight, float* out);

}  // namespace kinescope
