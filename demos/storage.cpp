// A storage tube: what is written stays, without being drawn again, until the screen is erased.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "demos/demo.h"
#include "demos/followed_knobs.h"
#include "demos/gnuplot_stream.h"
#include "demos/ui/caption.h"
#include "display/light_encode.h"
#include "display/vector/input/tek_reader.h"
#include "display/vector/storage_tube.h"
#include "raster/image/resample.h"

namespace kinescope {
namespace {

enum { kLine, kPointer, kTube };

constexpr std::array kBytesASecond = {1200.0, 120.0, 1e6};
constexpr std::size_t kErasure = 2;  // bytes that the stream begins with
constexpr std::array kTubes = {"4014", "613"};

class Storage : public ClonableDemo<Storage> {
 public:
  explicit Storage(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {choice_knob("line", {"l"}, {"12000 baud", "1200 baud", "as fast as it goes"}, 0,
                         "between gnuplot and the terminal"),
             toggle_knob("pointer", "w", true, "written through: seen, but not stored"),
             choice_knob("tube", {"t"}, {"Tektronix 4014", "Tektronix 613"}, 0, "that shows it")}),
        tube_(find_storage_tube(kTubes[0]), setup.width, setup.height) {}
  std::size_t state_bytes() const override {
    return static_cast<std::size_t>(width()) * static_cast<std::size_t>(height()) * 48;
  }
  bool still() const override { return still_; }

 private:
  /// A new tube is given what had been sent.
  void resized() override {
    tube_ =
        StorageTube(find_storage_tube(kTubes[static_cast<std::size_t>(shown_)]), width(), height());
    followed_.forget();
    reader_ = TekReader();
    received_ = kErasure;
    copy_ = {};
  }

  void update(const Step& step) override {
    if (shown_ != knob(kTube).index()) {
      shown_ = knob(kTube).index();
      resized();
    }
    still_ = step.events.empty() && !followed_.follow(knobs());
    for (const InputEvent& event : step.events) {
      if (event.kind != InputKind::kKeyDown) continue;
      if (event.key == "p") page();
      if (event.key == "h") copy_ = copy_.width() > 0 ? Image<Srgb8>() : tube_.hard_copy();
    }
    const double rate = kBytesASecond[static_cast<std::size_t>(knob(kLine).index())];
    sent_ = std::min(sent_ + rate * step.exposure.length().count(),
                     static_cast<double>(kGnuplotStream.size()));
    VectorDrawing news;
    receive(news);
    if (knob(kPointer).on()) point(step.exposure.begin, news);
    if (!news.segments.empty() || !news.texts.empty() || !news.events.empty()) tube_.draw(news);
  }
  /// The key PAGE; the plot is then sent again.
  void page() {
    tube_.erase();
    reader_ = TekReader();
    received_ = kErasure;
    sent_ = kErasure;
  }
  void receive(VectorDrawing& news) {
    const auto to = static_cast<std::size_t>(sent_);
    if (to <= received_) return;
    const auto* const bytes = reinterpret_cast<const std::uint8_t*>(kGnuplotStream.data());
    reader_.read({bytes + received_, to - received_}, news);
    reader_.flush(news);
    received_ = to;
  }
  /// A small diamond that goes round.
  static void point(Seconds now, VectorDrawing& news) {
    VectorPen pen;
    pen.write_through = true;
    news.use(pen);
    const double turn = 2 * std::numbers::pi * 0.25 * now.count();
    const glm::vec2 at{2048 + 900 * std::cos(turn), 1560 + 700 * std::sin(turn)};
    constexpr float kSize = 60;
    const std::array<glm::vec2, 5> corners{
        {{kSize, 0}, {0, kSize}, {-kSize, 0}, {0, -kSize}, {kSize, 0}}};
    for (std::size_t i = 0; i < 4; ++i) news.line(at + corners[i], at + corners[i + 1]);
  }

  void draw(const Step& step, Image<Srgb8>& picture) override {
    if (tube_.now() < step.exposure.begin) tube_.expose(step.exposure.begin, studio().workers);
    const Image<LinearRgb>& light = tube_.expose(step.exposure.end, studio().workers);
    still_ = drawn_.mark() && still_ && tube_.still() && !tube_.changed();
    if (still_) return;
    const double part = std::clamp(step.exposure.length().count() * 60, 1.0 / 64, 1.0);
    encode_light(light, ExposureGain::fixed(static_cast<float>(1 / part)), studio().workers,
                 picture);
    if (copy_.width() > 0) lay_copy(picture);
    lay_caption(picture, studio().sans, "p: page (erase, and plot again)   h: hard copy");
  }
  /// The paper, in a corner.
  void lay_copy(Image<Srgb8>& picture) const {
    const Image<Srgb8> small = darkest_of_blocks(copy_, 3);
    for (int y = 0; y < std::min(small.height(), picture.height()); ++y) {
      std::copy_n(small.row(y), std::min(small.width(), picture.width()), picture.row(y));
    }
  }

  StorageTube tube_;
  FollowedKnobs followed_;
  HasDrawn drawn_;
  bool still_ = false;
  TekReader reader_;
  int shown_ = 0;
  double sent_ = kErasure;  // bytes
  std::size_t received_ = kErasure;
  Image<Srgb8> copy_;
};

}  // namespace

DemoInfo storage_demo() {
  return {"storage",
          "1 Displays and coordinates",
          "gnuplot on a Tektronix terminal: written once, kept by the tube, erased with a flash",
          [](const DemoSetup& setup) { return std::make_unique<Storage>(setup); },
          1,
          {},
          {"random scan: storage tube"}};
}

}  // namespace kinescope
