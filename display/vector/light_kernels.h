// What a tube does with whole tiles of light, in SIMD.
#pragma once

namespace kinescope {

/// sum += held * lost; held *= left, where what is not above `unseen` becomes 0; held += more.
/// @param more none: nothing @param floats a multiple of 16 @return whether any is left of either
bool fade_light(float* sum, float* held, const float* more, float lost, float left, float unseen,
                int floats);

}  // namespace kinescope
