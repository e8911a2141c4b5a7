// Every phosphor side by side: one flash of the beam, and how long each glows.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "demos/demo.h"
#include "demos/monitor.h"
#include "demos/phosphor_chart.h"
#include "demos/ui/theme.h"

namespace kinescope {
namespace {

enum { kTypes, kChosen, kExcitation, kEvery, kPoints, kIris };

constexpr double kFirstTimeScale = 1.0 / 200;
constexpr Seconds kRefresh(1.0 / 60);  // a flash brings what steady excitation does in that time
constexpr Seconds kSteadyEnds = microseconds(100);
constexpr std::array kLengths = {microseconds(0.04), microseconds(100), kSteadyEnds};
constexpr std::array kPeriods = {milliseconds(50), Seconds(1), Seconds(60)};
constexpr float kPatchesShare = 0.4f, kWordsShare = 0.27f;

const std::vector<std::string> kGroups[] = {
    {"P1", "P2", "P5", "P11", "P15", "P16", "P24", "P31", "P35"},
    {"P7", "P7-long", "P14", "P17", "P28", "P32"},
    {"P4", "P6", "P18", "P22", "P22-EBU", "P22-NTSC", "P23"},
    {"P3", "P20", "P31", "P39", "P134"}};

std::vector<std::string> type_names() {
  std::vector<std::string> names;
  for (const PhosphorType& type : phosphors()) names.push_back(type.name);
  return names;
}

int index_of(std::string_view name) {
  const auto all = phosphors();
  return static_cast<int>(&find_phosphor(name) - all.data());
}

class Phosphors : public ClonableDemo<Phosphors> {
 public:
  explicit Phosphors(const DemoSetup& setup)
      : ClonableDemo(
            setup,
            {choice_knob("types", {"t"},
                         {"all", "oscilloscopes", "radar", "television", "terminals"}, 0,
                         "which phosphors are shown"),
             choice_knob("look at", {"p"}, type_names(), index_of("P7"),
                         "the one drawn in front, and told about"),
             choice_knob("excitation", {"e"}, {"40 ns", "100 µs", "continuous"}, 2,
                         "how long the beam excites them; the table's times are after long"),
             choice_knob("again after", {"r"}, {"50 ms", "1 s", "1 minute"}, 0,
                         "when the next flash comes, on phosphors that have rested"),
             toggle_knob("points", "o", true, "the published times of all types, not of one alone"),
             number_knob("iris", "-", "=", -12, 6, 1, 0, "stops",
                         "the camera's iris: each stop halves the light")}) {}

  std::size_t state_bytes() const override { return sizeof(*this); }

 private:
  void update(const Step&) override {}

  std::vector<FlashedType> flashed_types() const {
    const int group = knob(kTypes).index();
    std::vector<FlashedType> types;
    for (const std::string& name : group == 0 ? type_names() : kGroups[group - 1]) {
      const PhosphorType& type = find_phosphor(name);
      types.push_back({&type, FlashedSpot(type, {length(), continuous(), kRefresh.count()})});
    }
    return types;
  }
  bool continuous() const { return knob(kExcitation).index() == 2; }
  Seconds length() const { return kLengths[static_cast<std::size_t>(knob(kExcitation).index())]; }
  Seconds period() const { return kPeriods[static_cast<std::size_t>(knob(kEvery).index())]; }

  /// Mean light of the exposure; each flash has the phosphor to itself.
  LinearRgb light(const FlashedSpot& spot, const Exposure& exposure) const {
    LinearRgb sum;
    const double gain = std::exp2(-knob(kIris).value) / exposure.length().count();
    for (double k = std::floor(exposure.begin / period()); k * period() < exposure.end; ++k) {
      const Seconds flash = k * period();
      const LinearRgb part = spot.light(
          {std::max(Seconds(0), exposure.begin - flash), std::min(period(), exposure.end - flash)});
      const float scale = static_cast<float>(gain);
      sum = {sum.r + scale * part.r, sum.g + scale * part.g, sum.b + scale * part.b};
    }
    return sum;
  }

  /// Too much light is cut without a change of hue, so that colours can be told apart.
  static Srgb8 encode(LinearRgb light) {
    const float most = std::max({1.0f, light.r, light.g, light.b});
    return encode_srgb8(LinearRgb{light.r / most, light.g / most, light.b / most});
  }

  void draw(const Step& step, Image<Srgb8>& picture) override {
    const std::vector<FlashedType> types = flashed_types();
    const auto& chosen = phosphors()[static_cast<std::size_t>(knob(kChosen).index())];
    std::fill(picture.pixels().begin(), picture.pixels().end(), theme::kBackground);
    Canvas canvas(picture);
    const float scale = theme::scale_for(height());
    const Rect inside = whole_picture(*this).shrunk(theme::kMargin * scale);
    const float patches = inside.height * kPatchesShare, words = inside.width * kWordsShare;
    draw_patches(picture, {inside.x, inside.y, inside.width, patches}, types, &chosen,
                 step.exposure);
    // The line of state lies in the lower left corner: its height stays free.
    const Rect below = {inside.x, inside.y + patches + theme::kMargin * scale, inside.width,
                        inside.height - patches - 2.6f * theme::kMargin * scale};
    const PhosphorChart chart{studio(), types, &chosen, knob(kPoints).on()};
    const double turn = std::floor(step.exposure.begin / period());
    const Seconds since = step.exposure.end - turn * period() - length();
    chart.draw_curves(canvas, {below.x, below.y, below.width - words, below.height}, since,
                      period() - length());
    chart.draw_words(canvas, {below.right() - words, below.y, words, below.height});
  }

  void draw_patches(Image<Srgb8>& picture, const Rect& room, const std::vector<FlashedType>& types,
                    const PhosphorType* chosen, const Exposure& exposure) const {
    const auto count = static_cast<float>(types.size());
    // About as wide as high, and rows as full as they can be.
    const float shape = room.width / std::max(1.0f, room.height);
    const float most = std::max(1.0f, std::ceil(std::sqrt(count * shape)));
    const float rows = std::ceil(count / most), columns = std::ceil(count / rows);
    const float wide = room.width / columns, high = room.height / rows;
    for (std::size_t i = 0; i < types.size(); ++i) {
      const auto column = static_cast<float>(i % static_cast<std::size_t>(columns));
      const auto row = static_cast<float>(i / static_cast<std::size_t>(columns));
      const Rect cell{room.x + column * wide, room.y + row * high, wide, high};
      draw_patch(picture, studio(), cell, types[i].type->name,
                 encode(light(types[i].spot, exposure)), types[i].type == chosen);
    }
  }
};

}  // namespace

DemoInfo phosphors_demo() {
  return {"phosphors",
          "1 Displays and coordinates",
          "Every phosphor after one flash of the beam: how long each glows, and in what colours",
          [](const DemoSetup& setup) { return std::make_unique<Phosphors>(setup); },
          kFirstTimeScale,
          {},
          {"persistence"}};
}

}  // namespace kinescope
