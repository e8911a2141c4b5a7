#include "display/mode_request.h"

#include <fmt/format.h>

#include "raster/base/error.h"

namespace kinescope {

std::string request_name(const ModeRequest& r) {
  return fmt::format("{}x{}@{:g}{}", r.width, r.height, r.refresh_hz * (r.interlaced ? 2 : 1),
                     r.interlaced ? "i" : "");
}

void check_request(const ModeRequest& r) {
  if (r.width < 1 || r.height < 1 || r.width > 16384 || r.height > 16384) {
    throw Error(ErrorKind::kUsage, fmt::format("no monitor has the mode \"{}\": sides are 1 to "
                                               "16384 pixels",
                                               request_name(r)));
  }
  if (!(r.refresh_hz >= 10 && r.refresh_hz <= 1000)) {
    throw Error(
        ErrorKind::kUsage,
        fmt::format("no monitor has the mode \"{}\": the rate is 10 to 1000 frames a second",
                    request_name(r)));
  }
}

}  // namespace kinescope
