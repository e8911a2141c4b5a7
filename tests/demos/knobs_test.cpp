#include <map>
#include <set>

#include "demo_testing.h"
#include "demos/knob.h"
#include "tests/sanitized.h"

namespace kinescope {
namespace {

TEST(Knob, ToggleFlipsOnItsKeyOnly) {
  Knob knob = toggle_knob("tube", "d", true, "help");
  EXPECT_FALSE(knob.answer("x"));
  EXPECT_TRUE(knob.on());
  EXPECT_TRUE(knob.answer("d"));
  EXPECT_EQ(knob.text(), "off");
  EXPECT_TRUE(knob.keys_to(0).empty());
  EXPECT_EQ(knob.keys_to(1), std::vector<std::string>{"d"});
}

TEST(Knob, ChoiceWithAKeyEachGoesStraightThere) {
  Knob knob = choice_knob("shading", {"w", "f", "g"}, {"wire", "flat", "Gouraud"}, 0, "help");
  EXPECT_TRUE(knob.answer("g"));
  EXPECT_EQ(knob.text(), "Gouraud");
  EXPECT_EQ(knob.keys_to(1), std::vector<std::string>{"f"});
}

TEST(Knob, ChoiceWithOneKeyGoesRound) {
  Knob knob = choice_knob("bits", {"b"}, {"8", "4", "2"}, 1, "help");
  EXPECT_EQ(knob.keys_to(0), (std::vector<std::string>{"b", "b"}));
  knob.answer("b");
  knob.answer("b");
  EXPECT_EQ(knob.index(), 0);
}

TEST(Knob, NumberStaysInRangeAndOnItsSteps) {
  Knob knob = number_knob("speed", "-", "=", 0.1, 1, 0.1, 0.3, "/s", "help");
  const auto ways = knob.keys_to(0.7);
  EXPECT_EQ(ways, (std::vector<std::string>(4, "=")));
  for (const std::string& key : ways) knob.answer(key);
  EXPECT_EQ(knob.text(), "0.7 /s");
  for (int i = 0; i < 20; ++i) knob.answer("=");
  EXPECT_DOUBLE_EQ(knob.value, 1);
  for (int i = 0; i < 20; ++i) knob.answer("-");
  EXPECT_DOUBLE_EQ(knob.value, 0.1);
  EXPECT_TRUE(knob.keys_to(-5).empty());
}

TEST(Knob, HeldDownTurnsNumbersOnAndNothingElse) {
  Knob toggle = toggle_knob("tube", "d", false, "help");
  Knob round = choice_knob("bits", {"b"}, {"8", "4", "2"}, 1, "help");
  Knob number = number_knob("speed", "-", "=", 0, 10, 1, 3, "", "help");
  EXPECT_FALSE(toggle.answer("x", true));
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(toggle.answer("d", i > 0));
    EXPECT_TRUE(round.answer("b", i > 0));
    EXPECT_TRUE(number.answer("=", i > 0));
  }
  EXPECT_TRUE(toggle.on());
  EXPECT_EQ(round.index(), 2);
  EXPECT_DOUBLE_EQ(number.value, 6);
}

class EveryKnob : public EveryDemo {};

TEST_P(EveryKnob, KeysAreItsOwnAndExplained) {
  const auto demo = info().create(small_setup());
  std::set<std::string> taken = {"Space", ".", ",", "[",   "]",     "Tab",
                                 "?",     "s", "S", "F11", "Escape"};
  ASSERT_FALSE(demo->knobs().empty());
  for (const Knob& knob : demo->knobs()) {
    EXPECT_FALSE(knob.name.empty());
    EXPECT_GT(knob.help.size(), 5u) << knob.name;
    EXPECT_FALSE(knob.help.ends_with('.')) << knob.name;
    for (const std::string& key : knob.keys) {
      EXPECT_TRUE(taken.insert(key).second) << knob.name << " shares the key " << key;
    }
  }
}

using Keys = std::vector<std::string>;

/// A run in whose second step keys are pressed.
class TurnedDemo {
 public:
  TurnedDemo(const DemoInfo& info, const Keys& keys)
      : player_(info, small_setup(), 0), length_(step_length(info, player_.demo())) {
    std::vector<InputEvent> events;
    for (const std::string& key : keys) events.push_back(key_down(key));
    player_.forward(length_);
    player_.forward(length_, events);
  }
  /// Hash of picture `i` after the keys.
  std::uint64_t picture(std::size_t i) {
    while (hashes_.size() <= i) {
      player_.forward(length_);
      hashes_.push_back(hash_picture(player_.picture()));
    }
    return hashes_[i];
  }

 private:
  Player player_;
  Seconds length_;
  std::vector<std::uint64_t> hashes_;
};

std::vector<double> other_values(const Knob& knob) {
  std::vector<double> values;
  switch (knob.kind) {
    case KnobKind::kToggle:
      return {knob.on() ? 0.0 : 1.0};
    case KnobKind::kChoice:
      for (int i = 0; i < static_cast<int>(knob.choices.size()); ++i) {
        if (i != knob.index()) values.push_back(i);
      }
      return values;
    case KnobKind::kNumber:
      return {knob.value > knob.minimum ? knob.minimum : knob.maximum};
  }
  return values;
}

/// A knob may act only while another stands in a certain place (a page flip shows on a picture that
/// moves): the keys that put it there.
std::vector<Keys> circumstances(std::span<const Knob> knobs, std::size_t but) {
  std::vector<Keys> all = {{}};
  for (std::size_t i = 0; i < knobs.size(); ++i) {
    if (i == but || knobs[i].kind == KnobKind::kNumber) continue;
    for (const double value : other_values(knobs[i])) all.push_back(knobs[i].keys_to(value));
  }
  return all;
}

TEST_P(EveryKnob, EachTurnOfEachKnobChangesThePicture) {
  const auto demo = info().create(small_setup());
  const std::span<const Knob> knobs = demo->knobs();
  std::map<Keys, TurnedDemo> unturned;
  for (std::size_t i = 0; i < knobs.size(); ++i) {
    for (const double value : other_values(knobs[i])) {
      if (kSanitized) {  // which looks for what a turn breaks, not for where it shows
        TurnedDemo(info(), knobs[i].keys_to(value)).picture(0);
        continue;
      }
      bool changed = false;
      for (const Keys& before : circumstances(knobs, i)) {
        TurnedDemo& base = unturned.try_emplace(before, info(), before).first->second;
        Keys keys = before;
        const Keys turn = knobs[i].keys_to(value);
        keys.insert(keys.end(), turn.begin(), turn.end());
        TurnedDemo turned(info(), keys);
        for (std::size_t k = 0; k < 4 && !changed; ++k)
          changed = base.picture(k) != turned.picture(k);
        if (changed) break;
      }
      EXPECT_TRUE(changed) << knobs[i].name << " turned to " << value;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Knobs, EveryKnob, ::testing::ValuesIn(demo_names()), test_name);

}  // namespace
}  // namespace kinescope
