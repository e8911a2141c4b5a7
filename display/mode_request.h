// What a timing formula is asked for, and the limits of what it may be asked.
#pragma once

#include <string>

namespace kinescope {

struct ModeRequest {
  int width = 0, height = 0;
  double refresh_hz = 0;  ///< whole frames a second
  bool interlaced = false;
};

/// "640x480@60"; if interlaced, the rate of fields and an "i": "1024x768@87i".
std::string request_name(const ModeRequest& request);

/// @throws Error (usage) unless sides are 1 to 16384 and frames a second 10 to 1000
void check_request(const ModeRequest& request);

}  // namespace kinescope
