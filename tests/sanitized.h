// Whether a sanitizer watches: such runs look for what breaks, on fewer and smaller inputs, and
// leave out (#ifndef KINESCOPE_SANITIZED) what counts memory, of which a sanitizer takes its own.
#pragma once

namespace kinescope {

#ifdef KINESCOPE_SANITIZED
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

}  // namespace kinescope
