// The addresses of Tektronix 4010 and 4014 graphics: up to five bytes, told apart by their upper
// bits, those that have not changed left out. Source: Tektronix, 4014 User's Manual, appendix.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

namespace kinescope {

/// The registers of an address in enhanced graphics' units: 0 to 4095 either way.
class TekAddress {
 public:
  /// Takes one byte (7 bits, 0x20 or more). @return whether the address is whole now
  bool take(std::uint8_t byte) {
    const int bits = byte & 31;
    switch (byte >> 5) {
      case 1:  // high bits: of x once a low y came
        (seen_low_y_ ? x_ : y_).high = bits;
        return false;
      case 3:  // low y; if a second one follows, the first was the extra byte
        if (seen_low_y_) {
          y_.extra = y_.low >> 2 & 3;
          x_.extra = y_.low & 3;
        } else {
          x_.extra = y_.extra = 0;
        }
        y_.low = bits;
        seen_low_y_ = true;
        return false;
      default:
        x_.low = bits;
        seen_low_y_ = false;
        return true;
    }
  }
  /// Forgets a half address.
  void restart() { seen_low_y_ = false; }

  glm::ivec2 place() const { return {x_.value(), y_.value()}; }

 private:
  struct Register {
    int high = 0, low = 0, extra = 0;
    int value() const { return high << 7 | low << 2 | extra; }
  };
  Register x_, y_;
  bool seen_low_y_ = false;
};

}  // namespace kinescope
