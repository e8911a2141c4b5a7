// A real window on a virtual X server: what it shows, and what it hears.
#include "display/presenter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "raster/base/error.h"

namespace kinescope {
namespace {

using ::testing::IsSupersetOf;

/// An X server of our own on a free display number; DISPLAY names it while it lives.
class VirtualServer {
 public:
  VirtualServer() {
    int tell[2];
    if (pipe(tell) != 0) return;
    pid_ = fork();
    if (pid_ == 0) {
      close(tell[0]);
      if (freopen("/dev/null", "w", stderr) == nullptr) _exit(126);
      const std::string number = std::to_string(tell[1]);
      execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "800x600x24",
             "-nolisten", "tcp", "-noreset", static_cast<char*>(nullptr));
      _exit(127);
    }
    close(tell[1]);
    // The server dies of a pipe closed before its line has ended.
    std::string line;
    for (char c = 0; read(tell[0], &c, 1) == 1 && c != '\n';) line += c;
    close(tell[0]);
    if (line.empty()) return;
    display_ = ":" + line;
    setenv("DISPLAY", display_.c_str(), 1);
    unsetenv("WAYLAND_DISPLAY");
    unsetenv("SDL_VIDEODRIVER");
  }
  ~VirtualServer() {
    unsetenv("DISPLAY");
    if (pid_ <= 0) return;
    kill(pid_, SIGTERM);
    waitpid(pid_, nullptr, 0);
  }
  VirtualServer(const VirtualServer&) = delete;
  VirtualServer& operator=(const VirtualServer&) = delete;
  bool running() const { return !display_.empty(); }

 private:
  pid_t pid_ = -1;
  std::string display_;
};

bool run(const std::string& command) {
  return std::system((command + " 2>/dev/null").c_str()) == 0;
}

/// The screen's pixels, as xwd dumps them: a header of big-endian words, colours, rows.
struct Screen {
  std::vector<unsigned char> bytes;
  std::size_t word(std::size_t i) const {
    std::size_t v = 0;
    for (std::size_t k = 0; k < 4; ++k) v = v << 8 | bytes[4 * i + k];
    return v;
  }
  Srgb8 at(std::size_t x, std::size_t y) const {
    const std::size_t pixel = word(0) + word(19) * 12 + y * word(12) + x * word(11) / 8;
    return {bytes[pixel + 2], bytes[pixel + 1], bytes[pixel]};
  }
};

std::optional<Screen> dump_screen() {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen("xwd -silent -root", "r"), pclose);
  Screen screen;
  unsigned char part[4096];
  for (std::size_t n; (n = fread(part, 1, sizeof part, pipe.get())) > 0;) {
    screen.bytes.insert(screen.bytes.end(), part, part + n);
  }
  if (screen.bytes.size() < 100) return std::nullopt;
  return screen;
}

/// Events until `enough` says so, or five seconds have passed.
std::vector<InputEvent> events_until(
    Presenter& presenter, const std::function<bool(const std::vector<InputEvent>&)>& enough) {
  std::vector<InputEvent> all;
  const auto stop = std::chrono::steady_clock::now() + std::chrono::seconds(5);
  while (!enough(all) && std::chrono::steady_clock::now() < stop) {
    const auto some = presenter.poll(milliseconds(20));
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

bool holds(const std::vector<InputEvent>& events, InputKind kind, const std::string& key) {
  return std::any_of(events.begin(), events.end(),
                     [&](const InputEvent& e) { return e.kind == kind && e.key == key; });
}

class PresenterWindow : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const char* program : {"Xvfb", "xdotool", "xwd"}) {
      if (run(std::string("command -v ") + program + " >/dev/null")) continue;
      if (std::getenv("KINESCOPE_REQUIRE_DATA") != nullptr) FAIL() << program << " is required";
      GTEST_SKIP() << program << " is not installed";
    }
    server_.emplace();
    ASSERT_TRUE(server_->running());
    ASSERT_TRUE(Presenter::available());
    presenter_.emplace("kinescope test", 320, 240);
    // No window manager gives the focus: keys go to the window under the pointer.
    ASSERT_TRUE(run("xdotool mousemove 400 300"));
    presenter_->present(Image<Srgb8>(320, 240), workers_);
    presenter_->poll(milliseconds(50));
  }
  void TearDown() override {
    presenter_.reset();
    server_.reset();
  }
  std::optional<VirtualServer> server_;
  std::optional<Presenter> presenter_;
  Workers workers_{2};
};

TEST_F(PresenterWindow, ShowsPicturesPixelByPixel) {
  EXPECT_EQ(presenter_->width(), 320);
  EXPECT_EQ(presenter_->height(), 240);
  EXPECT_GT(presenter_->refresh().hertz(), 0);
  Image<Srgb8> picture(320, 240, Srgb8{10, 20, 30});
  picture.at(0, 0) = {255, 0, 0};
  picture.at(319, 0) = {0, 255, 0};
  picture.at(0, 239) = {0, 0, 255};
  presenter_->present(picture, workers_);
  const auto screen = dump_screen();
  ASSERT_TRUE(screen);
  // Centred on 800x600.
  EXPECT_EQ(screen->at(240, 180), (Srgb8{255, 0, 0}));
  EXPECT_EQ(screen->at(559, 180), (Srgb8{0, 255, 0}));
  EXPECT_EQ(screen->at(240, 419), (Srgb8{0, 0, 255}));
  EXPECT_EQ(screen->at(400, 300), (Srgb8{10, 20, 30}));
}

TEST_F(PresenterWindow, CentresPicturesOfOtherSizes) {
  presenter_->present(Image<Srgb8>(100, 40, Srgb8{200, 100, 50}), workers_);
  const auto small = dump_screen();
  ASSERT_TRUE(small);
  EXPECT_EQ(small->at(400, 300), (Srgb8{200, 100, 50}));
  EXPECT_EQ(small->at(350, 280), (Srgb8{200, 100, 50}));
  EXPECT_EQ(small->at(349, 300), (Srgb8{0, 0, 0}));
  EXPECT_EQ(small->at(400, 279), (Srgb8{0, 0, 0}));
  Image<Srgb8> large(640, 480, Srgb8{1, 2, 3});
  large.at(320, 240) = {9, 9, 9};
  presenter_->present(large, workers_);
  const auto cut = dump_screen();
  ASSERT_TRUE(cut);
  EXPECT_EQ(cut->at(400, 300), (Srgb8{9, 9, 9}));
  EXPECT_EQ(cut->at(240, 180), (Srgb8{1, 2, 3}));
}

TEST_F(PresenterWindow, NamesKeysByWhatTheyType) {
  ASSERT_TRUE(run("xdotool key a space question bracketleft period comma F11 Escape Left S"));
  const auto events = events_until(*presenter_, [](const std::vector<InputEvent>& seen) {
    return std::any_of(seen.begin(), seen.end(), [](const InputEvent& e) {
      return e.kind == InputKind::kKeyUp && e.key == "s";
    });
  });
  for (const char* key : {"a", "Space", "?", "[", ".", ",", "F11", "Escape", "Left", "s"}) {
    EXPECT_TRUE(holds(events, InputKind::kKeyDown, key)) << key;
    EXPECT_TRUE(holds(events, InputKind::kKeyUp, key)) << key;
  }
  EXPECT_TRUE(holds(events, InputKind::kText, "?"));
  EXPECT_TRUE(holds(events, InputKind::kText, "S"));
  for (const InputEvent& e : events) {
    if (e.kind == InputKind::kKeyDown && e.key == "s") {
      EXPECT_TRUE(e.shift);
    }
  }
}

TEST_F(PresenterWindow, TellsMouseWheelAndSize) {
  ASSERT_TRUE(run("xdotool mousemove 250 200 click 1 mousemove 260 215 click 4"));
  const auto events = events_until(*presenter_, [](const std::vector<InputEvent>& seen) {
    return std::any_of(seen.begin(), seen.end(),
                       [](const InputEvent& e) { return e.kind == InputKind::kWheel; });
  });
  bool clicked = false, moved = false, wheeled = false;
  for (const InputEvent& e : events) {
    clicked |=
        e.kind == InputKind::kMouseDown && e.button == MouseButton::kLeft && e.x == 10 && e.y == 20;
    moved |= e.kind == InputKind::kMouseMove && e.x == 20 && e.y == 35;
    wheeled |= e.kind == InputKind::kWheel && e.wheel == 1;
  }
  EXPECT_TRUE(clicked);
  EXPECT_TRUE(moved);
  EXPECT_TRUE(wheeled);

  ASSERT_TRUE(run("xdotool search --name 'kinescope test' windowsize 400 260"));
  const auto sized = events_until(*presenter_, [](const std::vector<InputEvent>& seen) {
    return std::any_of(seen.begin(), seen.end(),
                       [](const InputEvent& e) { return e.kind == InputKind::kResize; });
  });
  ASSERT_FALSE(sized.empty());
  EXPECT_EQ(presenter_->width(), 400);
  EXPECT_EQ(presenter_->height(), 260);
  presenter_->present(Image<Srgb8>(400, 260, Srgb8{77, 88, 99}), workers_);
  const auto screen = dump_screen();
  ASSERT_TRUE(screen);
  EXPECT_EQ(screen->at(240 + 399, 180 + 259), (Srgb8{77, 88, 99}));
}

TEST_F(PresenterWindow, GoesFullScreenAndBack) {
  EXPECT_FALSE(presenter_->full_screen());
  presenter_->set_full_screen(true);
  EXPECT_TRUE(presenter_->full_screen());
  presenter_->poll(milliseconds(50));
  presenter_->present(Image<Srgb8>(presenter_->width(), presenter_->height()), workers_);
  presenter_->set_full_screen(false);
  EXPECT_FALSE(presenter_->full_screen());
}

TEST(Presenter, WorksWithSdlsDummyDriver) {
  setenv("SDL_VIDEODRIVER", "dummy", 1);
  EXPECT_TRUE(Presenter::available());
  {
    Presenter presenter("dummy", 64, 48);
    Workers workers(2);
    EXPECT_EQ(presenter.width(), 64);
    presenter.set_title("another");
    presenter.present(Image<Srgb8>(64, 48), workers);
    presenter.poll();
  }
  unsetenv("SDL_VIDEODRIVER");
}

TEST(Presenter, IsNotAvailableWithoutADisplay) {
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  unsetenv("SDL_VIDEODRIVER");
  EXPECT_FALSE(Presenter::available());
  setenv("DISPLAY", ":987", 1);
  EXPECT_THROW(Presenter("nowhere", 64, 48), Error);
  unsetenv("DISPLAY");
}

}  // namespace
}  // namespace kinescope
