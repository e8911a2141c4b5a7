#include "display/vector/input/tek_reader.h"

#include <algorithm>
#include <array>
#include <utility>

namespace kinescope {
namespace {

constexpr std::uint8_t kEtx = 3, kEnq = 5, kBel = 7, kBs = 8, kHt = 9, kLf = 10, kVt = 11, kFf = 12,
                       kCr = 13, kEtb = 23, kSub = 26, kEsc = 27, kFs = 28, kGs = 29, kRs = 30,
                       kUs = 31, kDel = 127;

/// Cells of the 4014's characters, device units, and how many lines fit. Source: the manual's
/// 74x35, 81x38, 121x58 and 133x64 characters a page.
struct CharacterSize {
  int width, height, lines;
};
constexpr std::array<CharacterSize, 4> kSizes{
    {{56, 88, 35}, {51, 82, 38}, {34, 53, 58}, {31, 48, 64}}};
/// A capital's share of the line's height. No figure at hand: taken so that lines do not touch.
constexpr float kCapitalShare = 0.6f;

int home_y(int size) {
  const CharacterSize& s = kSizes[static_cast<std::size_t>(size)];
  return (s.lines - 1) * s.height;
}

}  // namespace

void TekReader::read(std::span<const std::uint8_t> bytes, VectorDrawing& drawing) {
  out_ = &drawing;
  out_->use(pen_);
  for (const std::uint8_t byte : bytes) step(byte & 0x7f);
  out_ = nullptr;
}

void TekReader::flush(VectorDrawing& drawing) {
  out_ = &drawing;
  end_text();
  out_ = nullptr;
}

void TekReader::step(std::uint8_t byte) {
  if (in_sequence_) return control_sequence(byte);
  if (byte == kEsc) {
    in_escape_ = true;
    return;
  }
  if (in_escape_) return escape(byte);
  if (away_) return;
  if (byte < 0x20) return control(byte);
  printable(byte);
}

void TekReader::control(std::uint8_t byte) {
  switch (byte) {
    case kBel:
      // Right after GS it lights the vector that would be dark.
      if (mode_ == Mode::kGraph && dark_) {
        dark_ = false;
      } else {
        out_->event(DrawingEvent::Kind::kBell);
      }
      break;
    case kCr:
      enter(Mode::kAlpha);
      move({margin_x(), beam_.y});
      break;
    case kGs:
      enter(Mode::kGraph);
      dark_ = true;
      break;
    case kFs:
      enter(Mode::kPoint);
      break;
    case kRs:
      enter(Mode::kIncremental);
      break;
    case kUs:
      enter(Mode::kAlpha);
      break;
    case kBs:
    case kHt:
    case kLf:
    case kVt: {
      if (mode_ != Mode::kAlpha) break;
      const CharacterSize& size = kSizes[static_cast<std::size_t>(size_)];
      if (byte == kBs) move({std::max(beam_.x - size.width, margin_x()), beam_.y});
      if (byte == kHt) move({beam_.x + size.width, beam_.y});
      if (byte == kVt) move({beam_.x, beam_.y + size.height});
      if (byte == kLf) line_feed();
      break;
    }
    default:
      break;
  }
}

void TekReader::escape(std::uint8_t byte) {
  // These leave the terminal waiting for what the escape is about.
  if (byte == 0 || byte == kLf || byte == kCr || byte == kDel) return;
  in_escape_ = false;
  if (byte == '[') {
    in_sequence_ = true;
    sequence_.clear();
    return;
  }
  if (byte == kEtx && from_xterm_) away_ = true;
  if (away_) return;
  if (byte >= '`') return set_line_type(byte - '`');
  if (byte >= '8' && byte <= ';') return set_size(byte - '8');
  switch (byte) {
    case kFf:
      return page();
    case kFs:
      enter(Mode::kSpecialPoint);
      intensity_next_ = true;
      return;
    case kEtb:
      return out_->event(DrawingEvent::Kind::kHardCopy);
    case kEnq:
      // Bits of a terminal with a copier that is not in graph mode, and the margin.
      replies_ += static_cast<char>(0x34 | margin_ << 1);
      return reply_place(beam_);
    case kSub:
      crosshair_ = true;
      return;
    case '?':  // what hosts send that cannot send DEL
      return printable(kDel);
    default:
      if (byte == kGs || byte == kRs || byte == kUs) control(byte);
  }
}

/// An xterm's sequences: ESC [ ? 38 h turns the stream to its Tektronix window, l away from it.
void TekReader::control_sequence(std::uint8_t byte) {
  if (byte == kEsc) {
    in_sequence_ = false;
    in_escape_ = true;
    return;
  }
  if (byte < 0x40) {
    if (sequence_.size() < 16) sequence_ += static_cast<char>(byte);
    return;
  }
  in_sequence_ = false;
  if (sequence_ != "?38") return;
  if (byte == 'h') from_xterm_ = true;
  away_ = byte == 'l' && from_xterm_;
}

void TekReader::printable(std::uint8_t byte) {
  switch (mode_) {
    case Mode::kAlpha:
      return character(byte);
    case Mode::kIncremental:
      return increment(byte);
    case Mode::kSpecialPoint:
      if (intensity_next_) {
        // The manual's table of 64 currents is not at hand: in even steps, half of them defocused.
        point_intensity_ = static_cast<float>((byte & 31) + 1) / 32;
        pen_.defocused = (byte & 0x40) != 0;
        out_->use(pen_);
        intensity_next_ = false;
        return;
      }
      [[fallthrough]];
    case Mode::kGraph:
    case Mode::kPoint:
      if (address_.take(byte)) arrive();
  }
}

void TekReader::arrive() {
  const glm::ivec2 to = address_.place();
  if (mode_ == Mode::kGraph) {
    if (!dark_) out_->line(beam_, to);
    beam_ = to;
    dark_ = false;
    return;
  }
  beam_ = to;
  point(mode_ == Mode::kSpecialPoint ? point_intensity_ : 1);
  intensity_next_ = mode_ == Mode::kSpecialPoint;
}

void TekReader::point(float intensity) { out_->line(beam_, beam_, intensity); }

void TekReader::increment(std::uint8_t byte) {
  if (byte == ' ') pen_down_ = false;
  if (byte == 'P' || byte == 'p') pen_down_ = true;
  if (byte < 0x40 || (byte & 0x1f) > 10) return;
  const int east = byte & 1, west = byte >> 1 & 1, north = byte >> 2 & 1, south = byte >> 3 & 1;
  const glm::ivec2 to = beam_ + glm::ivec2(east - west, north - south);
  if (to == beam_) return;
  if (pen_down_) out_->line(beam_, to);
  beam_ = to;
}

void TekReader::character(std::uint8_t byte) {
  if (byte == kDel) return;
  const CharacterSize& size = kSizes[static_cast<std::size_t>(size_)];
  if (beam_.x > 4095) {
    move({margin_x(), beam_.y});
    line_feed();
  }
  if (text_.text.empty() && byte != ' ') {
    text_.place = beam_;
    text_.advance = glm::vec2(size.width, 0);
    text_.up = glm::vec2(0, kCapitalShare * static_cast<float>(size.height));
    text_.segments = out_->segments.size();
    text_.pen = pen_;
  }
  if (byte != ' ' || !text_.text.empty()) text_.text += static_cast<char>(byte);
  beam_.x += size.width;
}

void TekReader::line_feed() {
  int y = beam_.y - kSizes[static_cast<std::size_t>(size_)].height;
  if (y < 0) {
    y = home_y(size_);
    margin_ = 1 - margin_;
  }
  move({beam_.x, y});
}

void TekReader::enter(Mode mode) {
  end_text();
  mode_ = mode;
  address_.restart();
  dark_ = false;
  if (mode == Mode::kIncremental) pen_down_ = false;
}

void TekReader::page() {
  enter(Mode::kAlpha);
  out_->event(DrawingEvent::Kind::kErase);
  margin_ = 0;
  pen_ = {};
  out_->use(pen_);
  crosshair_ = false;
  beam_ = {0, home_y(size_)};
}

/// Types 0 to 4 and again from 8 defocused and from 16 write-through; others are solid.
void TekReader::set_line_type(int type) {
  constexpr std::array kStyles{LineStyle::kSolid, LineStyle::kDotted, LineStyle::kDotDash,
                               LineStyle::kShortDash, LineStyle::kLongDash};
  const auto style = static_cast<std::size_t>(type & 7);
  pen_.style = style < kStyles.size() ? kStyles[style] : LineStyle::kSolid;
  pen_.defocused = type >> 3 == 1;
  pen_.write_through = type >> 3 == 2;
  end_text();
  out_->use(pen_);
}

void TekReader::set_size(int size) {
  end_text();
  size_ = size;
}

void TekReader::move(glm::ivec2 to) {
  end_text();
  beam_ = to;
}

void TekReader::end_text() {
  if (text_.text.empty()) return;
  out_->texts.push_back(text_);
  text_.text.clear();
}

std::string TekReader::take_replies() { return std::exchange(replies_, {}); }

/// Ten bits each way, five a byte, and the carriage return that the terminal is strapped for.
void TekReader::reply_place(glm::ivec2 at) {
  for (const int value : {at.x >> 2, at.y >> 2}) {
    replies_ += static_cast<char>(0x20 | (value >> 5 & 31));
    replies_ += static_cast<char>(0x20 | (value & 31));
  }
  replies_ += '\r';
}

void TekReader::press(char key, int x, int y) {
  if (!crosshair_) return;
  crosshair_ = false;
  replies_ += key;
  reply_place({x, y});
}

VectorDrawing read_tek(std::span<const std::uint8_t> bytes) {
  VectorDrawing drawing;
  TekReader terminal;
  terminal.read(bytes, drawing);
  terminal.flush(drawing);
  return drawing;
}

}  // namespace kinescope
