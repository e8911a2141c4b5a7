#include "display/presenter.h"

#include <SDL2/SDL.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <map>
#include <thread>

#include "raster/base/error.h"
#include "raster/colour/pack_words.h"

namespace kinescope {
namespace {

constexpr Seconds kShortestNap(0.002), kLongestNap(0.025);

[[noreturn]] void fail(const std::string& what) {
  throw Error(ErrorKind::kCannotWrite, what + ": " + SDL_GetError());
}

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

/// SDL's drivers that draw into memory alone.
bool draws_nowhere(const char* driver) {
  return driver != nullptr &&
         (std::strcmp(driver, "dummy") == 0 || std::strcmp(driver, "offscreen") == 0);
}

bool wants_no_screen() { return draws_nowhere(std::getenv("SDL_VIDEODRIVER")); }

MouseButton button_of(Uint8 button) {
  switch (button) {
    case SDL_BUTTON_LEFT:
      return MouseButton::kLeft;
    case SDL_BUTTON_MIDDLE:
      return MouseButton::kMiddle;
    case SDL_BUTTON_RIGHT:
      return MouseButton::kRight;
    default:
      return MouseButton::kNone;
  }
}

/// The key without shift, as the layout prints it: "a", "[", "F11", "Escape", "Space".
std::string key_name(SDL_Keycode key) {
  if (key > 32 && key < 127) return std::string(1, static_cast<char>(key));
  return SDL_GetKeyName(key);
}

/// Whether the text names the key that made it better than the key's own name does: "?" of a
/// shifted
/// "/", "[" of a layout that needs a modifier for it. Letters stay small, their shift a flag.
bool renames_key(const std::string& text) {
  return text.size() == 1 && text[0] > 32 && text[0] < 127 &&
         std::isalpha(static_cast<unsigned char>(text[0])) == 0;
}

void set_modifiers(InputEvent& event) {
  const SDL_Keymod held = SDL_GetModState();
  event.shift = (held & KMOD_SHIFT) != 0;
  event.control = (held & KMOD_CTRL) != 0;
}

/// Copies the part of the picture that lies in the surface, centred, as the surface packs pixels.
void copy_centred(const Image<Srgb8>& picture, SDL_Surface& surface, Workers& workers) {
  const int width = std::min(picture.width(), surface.w);
  const int height = std::min(picture.height(), surface.h);
  const int from_x = (picture.width() - width) / 2, to_x = (surface.w - width) / 2;
  const int from_y = (picture.height() - height) / 2, to_y = (surface.h - height) / 2;
  const SDL_PixelFormat& format = *surface.format;
  const WordLayout layout{format.Rshift, format.Gshift, format.Bshift};
  run_rows(workers, height, [&](int y) {
    const Srgb8* in = picture.row(from_y + y) + from_x;
    auto* out = reinterpret_cast<Uint32*>(static_cast<Uint8*>(surface.pixels) +
                                          static_cast<std::ptrdiff_t>(to_y + y) * surface.pitch) +
                to_x;
    pack_words({in, static_cast<std::size_t>(width)}, layout,
               {out, static_cast<std::size_t>(width)});
  });
}

}  // namespace

struct Presenter::State {
  SDL_Window* window = nullptr;
  SDL_Scancode last_down = SDL_SCANCODE_UNKNOWN;  // of the key whose text may follow
  std::map<SDL_Scancode, std::string> held;       // names that keys went down with

  ~State() {
    if (window != nullptr) SDL_DestroyWindow(window);
    SDL_QuitSubSystem(SDL_INIT_VIDEO);
  }
  SDL_Surface& surface() const {
    SDL_Surface* s = SDL_GetWindowSurface(window);
    if (s == nullptr) fail("the window gives no surface");
    return *s;
  }
  void place(InputEvent& event, int x, int y) const {
    int width = 0, height = 0;
    SDL_GetWindowSize(window, &width, &height);
    SDL_Surface& s = surface();
    event.x = width > 0 ? x * s.w / width : x;
    event.y = height > 0 ? y * s.h / height : y;
  }
  void translate(const SDL_Event& in, std::vector<InputEvent>& out);
  void translate_key(const SDL_KeyboardEvent& in, InputEvent event, std::vector<InputEvent>& out);
  void translate_text(const std::string& text, InputEvent event, std::vector<InputEvent>& out);
  void translate_window(const SDL_WindowEvent& in, InputEvent event, std::vector<InputEvent>& out);
};

bool Presenter::available() {
  return wants_no_screen() || is_set("DISPLAY") || is_set("WAYLAND_DISPLAY");
}

Presenter::Presenter(const std::string& title, int width, int height) {
  // Without this SDL draws the window's surface through OpenGL, which in software is ten times
  // slower.
  SDL_SetHint(SDL_HINT_FRAMEBUFFER_ACCELERATION, "0");
  SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
  SDL_SetHint(SDL_HINT_VIDEO_ALLOW_SCREENSAVER, "1");
  SDL_SetMainReady();
  if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) fail("no window can be opened");
  state_ = std::make_unique<State>();
  // Where no display answers, SDL falls back to a window that nobody sees.
  if (draws_nowhere(SDL_GetCurrentVideoDriver()) && !wants_no_screen()) {
    SDL_SetError("no display answers");
    fail("no window can be opened");
  }
  // What lies beyond the screen nobody sees, and cannot be clicked.
  SDL_Rect room{};
  if (SDL_GetDisplayUsableBounds(0, &room) == 0 && room.w > 0 && room.h > 0) {
    width = std::min(width, room.w);
    height = std::min(height, room.h);
  }
  state_->window = SDL_CreateWindow(title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                                    width, height, SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI);
  if (state_->window == nullptr) fail("no window can be opened");
  SDL_StartTextInput();
}

Presenter::~Presenter() = default;

int Presenter::width() const { return state_->surface().w; }
int Presenter::height() const { return state_->surface().h; }

Rate Presenter::refresh() const {
  SDL_DisplayMode mode{};
  const int display = SDL_GetWindowDisplayIndex(state_->window);
  if (display < 0 || SDL_GetCurrentDisplayMode(display, &mode) != 0 || mode.refresh_rate <= 0) {
    return {60, 1};
  }
  return {mode.refresh_rate, 1};
}

void Presenter::set_full_screen(bool on) {
  SDL_SetWindowFullscreen(state_->window, on ? SDL_WINDOW_FULLSCREEN_DESKTOP : 0);
}

bool Presenter::full_screen() const {
  return (SDL_GetWindowFlags(state_->window) & SDL_WINDOW_FULLSCREEN_DESKTOP) ==
         SDL_WINDOW_FULLSCREEN_DESKTOP;
}

void Presenter::set_title(const std::string& title) {
  SDL_SetWindowTitle(state_->window, title.c_str());
}

void Presenter::present(const Image<Srgb8>& picture, Workers& workers) {
  SDL_Surface& surface = state_->surface();
  if (surface.format->BytesPerPixel != 4) fail("the window's pixels are not of 32 bits");
  if (SDL_MUSTLOCK(&surface)) SDL_LockSurface(&surface);
  const bool covers = picture.width() >= surface.w && picture.height() >= surface.h;
  if (!covers) SDL_FillRect(&surface, nullptr, 0);
  copy_centred(picture, surface, workers);
  if (SDL_MUSTLOCK(&surface)) SDL_UnlockSurface(&surface);
  // A failure here means that the window is being resized: the next picture fits again.
  SDL_UpdateWindowSurface(state_->window);
}

void Presenter::State::translate_window(const SDL_WindowEvent& in, InputEvent event,
                                        std::vector<InputEvent>& out) {
  if (in.event == SDL_WINDOWEVENT_SIZE_CHANGED) {
    event.kind = InputKind::kResize;
    event.x = surface().w;
    event.y = surface().h;
    out.push_back(event);
  }
}

void Presenter::State::translate_key(const SDL_KeyboardEvent& in, InputEvent event,
                                     std::vector<InputEvent>& out) {
  const SDL_Scancode code = in.keysym.scancode;
  event.key = key_name(in.keysym.sym);
  event.repeated = in.repeat != 0;
  event.shift = (in.keysym.mod & KMOD_SHIFT) != 0;
  event.control = (in.keysym.mod & KMOD_CTRL) != 0;
  if (in.type == SDL_KEYDOWN) {
    event.kind = InputKind::kKeyDown;
    held[code] = event.key;
    last_down = code;
  } else {
    event.kind = InputKind::kKeyUp;
    if (const auto name = held.extract(code)) event.key = name.mapped();
  }
  out.push_back(event);
}

/// SDL tells the text right after the key that made it.
void Presenter::State::translate_text(const std::string& text, InputEvent event,
                                      std::vector<InputEvent>& out) {
  if (!out.empty() && out.back().kind == InputKind::kKeyDown && renames_key(text)) {
    out.back().key = text;
    held[last_down] = text;
  }
  event.kind = InputKind::kText;
  event.key = text;
  out.push_back(event);
}

void Presenter::State::translate(const SDL_Event& in, std::vector<InputEvent>& out) {
  InputEvent event;
  set_modifiers(event);
  switch (in.type) {
    case SDL_QUIT:
      event.kind = InputKind::kQuit;
      break;
    case SDL_KEYDOWN:
    case SDL_KEYUP:
      return translate_key(in.key, event, out);
    case SDL_TEXTINPUT:
      return translate_text(in.text.text, event, out);
    case SDL_MOUSEMOTION:
      event.kind = InputKind::kMouseMove;
      event.button = (in.motion.state & SDL_BUTTON_LMASK)   ? MouseButton::kLeft
                     : (in.motion.state & SDL_BUTTON_MMASK) ? MouseButton::kMiddle
                     : (in.motion.state & SDL_BUTTON_RMASK) ? MouseButton::kRight
                                                            : MouseButton::kNone;
      place(event, in.motion.x, in.motion.y);
      break;
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
      event.kind = in.type == SDL_MOUSEBUTTONDOWN ? InputKind::kMouseDown : InputKind::kMouseUp;
      event.button = button_of(in.button.button);
      place(event, in.button.x, in.button.y);
      break;
    case SDL_MOUSEWHEEL:
      event.kind = InputKind::kWheel;
      event.wheel =
          in.wheel.direction == SDL_MOUSEWHEEL_FLIPPED ? -in.wheel.preciseY : in.wheel.preciseY;
      place(event, in.wheel.mouseX, in.wheel.mouseY);
      break;
    case SDL_WINDOWEVENT:
      return translate_window(in.window, event, out);
    default:
      return;
  }
  out.push_back(event);
}

std::vector<InputEvent> Presenter::poll(Seconds wait) {
  using Clock = std::chrono::steady_clock;
  // Not SDL_WaitEventTimeout(): for each event that ends it SDL's X11 driver sends the window a
  // message over a second connection. If the window is destroyed before the server comes to that,
  // Xlib ends the program with BadWindow.
  const Seconds nap = std::clamp(0.1 * wait, kShortestNap, kLongestNap);
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                      std::clamp(wait, Seconds(0), Seconds(3600)));
  std::vector<InputEvent> events;
  while (true) {
    SDL_Event event;
    bool any = false;
    while (SDL_PollEvent(&event) != 0) {
      state_->translate(event, events);
      any = true;
    }
    const Seconds left = end - Clock::now();
    if (any || left <= Seconds(0)) return events;
    std::this_thread::sleep_for(std::min(left, nap));
  }
}

}  // namespace kinescope
