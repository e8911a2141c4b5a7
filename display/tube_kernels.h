// The tube's inner loops, each over a row of floats, compiled for every instruction set.
#pragma once

#include <array>
#include <span>

#include "display/frame_buffer.h"

namespace kinescope {

/// One row for the narrow and one for the wide Gaussian of the spot.
using DoseRows = std::array<const float*, 2>;
using LightRows = std::array<float*, 2>;

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
void excite_slow_term(int n, const SlowTermStep& step, LightRows old_dose, LightRows state,
                      LightRows light);

/// light += old weight * dose + (even + new weight) * new dose; then dose = new dose.
void excite_dose(int n, const float* old_weight, float even, const float* new_weight,
                 DoseRows new_dose, LightRows dose, LightRows light);

/// The gun's and the spot's laws: current = (contrast * drive + brightness)^gamma, its spot's
/// deviation = least + growth * current^(1/3), bounded; of the current, the wide Gaussian draws
/// at_wide - by_square / deviation^2.
struct GunLaw {
  float contrast, brightness;  ///< of a drive from 0 to 255
  float third_of_gamma;
  float least, growth, narrow, wide;  ///< deviations
  float at_wide, by_square;
};
/// The amplifier: voltage[i .. i + response.size()) times response, and the doses of the result.
void amplify(int n, std::span<const float> response, const GunLaw& law, const float* voltage,
             float* narrow, float* wide);

/// sum[i] += a[i] + b[i]
void add_rows(int n, const float* a, const float* b, float* sum);

/// out[i] = start + slope * (i + 1/2)
void fill_ramp(int n, float start, float slope, float* out);

}  // namespace kinescope
