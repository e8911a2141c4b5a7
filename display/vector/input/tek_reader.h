// The Tektronix 4010 and 4014 terminals, as far as what they receive tells the beam.
// Modelled: alpha mode with four sizes of characters and two margins, graph, point plot, special
// point plot, incremental plot, line types, write-through and defocused beams, enhanced graphics'
// 12 bits, page, copy, bell, status and crosshair (GIN) replies.
// Not modelled: the alternate character set, bypass, the tape and the hard copy unit themselves.
// Source: Tektronix, 4014 and 4014-1 User's Manual (070-1647).
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "display/vector/input/drawing.h"
#include "display/vector/input/tek_address.h"

namespace kinescope {

/// Units of a drawing from a Tektronix stream: 4096 x 3120 addressable points are visible; 10-bit
/// addresses are multiples of 4.
class TekReader {
 public:
  /// Steps the terminal byte by byte; what it draws is appended. Any bytes are harmless.
  void read(std::span<const std::uint8_t> bytes, VectorDrawing& drawing);
  /// Hands out characters that may still be joined by others.
  void flush(VectorDrawing& drawing);

  /// What the terminal has sent to its computer since the last call.
  std::string take_replies();
  bool crosshair_shown() const { return crosshair_; }
  /// The user has pressed a key with the crosshair at (x, y), device units.
  void press(char key, int x, int y);

 private:
  enum class Mode { kAlpha, kGraph, kPoint, kSpecialPoint, kIncremental };

  void step(std::uint8_t byte);
  void control(std::uint8_t byte);
  void escape(std::uint8_t byte);
  void control_sequence(std::uint8_t byte);
  void printable(std::uint8_t byte);
  void arrive();
  void increment(std::uint8_t byte);
  void character(std::uint8_t byte);
  void line_feed();
  void enter(Mode mode);
  void page();
  void point(float intensity);
  void set_line_type(int type);
  void set_size(int size);
  void move(glm::ivec2 to);
  void end_text();
  void reply_place(glm::ivec2 at);
  int margin_x() const { return margin_ * 2048; }

  VectorDrawing* out_ = nullptr;  // during read()
  Mode mode_ = Mode::kAlpha;
  TekAddress address_;
  glm::ivec2 beam_{0, 2992};
  VectorPen pen_;
  DrawnText text_;  // characters on one line, not yet handed out
  int size_ = 0, margin_ = 0;
  float point_intensity_ = 1;
  bool dark_ = false;  // the next vector is a move
  bool pen_down_ = false;
  bool in_escape_ = false, in_sequence_ = false;
  bool intensity_next_ = false;
  bool crosshair_ = false;
  bool away_ = false;  // an xterm's other window has the stream
  bool from_xterm_ = false;
  std::string sequence_, replies_;
};

/// A whole stream at once.
VectorDrawing read_tek(std::span<const std::uint8_t> bytes);

}  // namespace kinescope
