#include "display/tube/preset.h"

#include <gtest/gtest.h>

#include <set>

#include "raster/base/error.h"

namespace kinescope {
namespace {

TubePreset parsed(const std::string& text) { return parse_tube_preset(text, "test", "test.txt"); }

std::string fault_of(const std::string& text) {
  try {
    parsed(text);
  } catch (const Error& error) {
    EXPECT_EQ(error.exit_code(), 3);
    return error.what();
  }
  return "";
}

TEST(TubePreset, KeysUnitsAndCommentsAreRead) {
  const TubePreset preset = parsed(
      "# a tube\n"
      "note  a test tube\n"
      "mode 800x600@60\n"
      "phosphor P31  # green\n"
      "glass.diagonal 14in\n"
      "gun.bandwidth 4.2 MHz\n"
      "mask.open 85 %\n"
      "mask.kind slots\n"
      "glass.tint 0.9 0.8 0.7\n"
      "convergence.blue.edge_y -0.5 mm\n");
  EXPECT_EQ(preset.note, "a test tube");
  EXPECT_EQ(preset.mode_name, "800x600@60");
  EXPECT_EQ(preset.settings.mode.horizontal.active, 800);
  EXPECT_EQ(preset.settings.phosphor, "P31");
  EXPECT_DOUBLE_EQ(preset.settings.glass.diagonal_mm, 355.6);
  EXPECT_DOUBLE_EQ(preset.settings.gun.bandwidth_hz, 4.2e6);
  EXPECT_DOUBLE_EQ(preset.settings.mask.open, 0.85);
  EXPECT_EQ(preset.settings.mask.kind, MaskKind::kSlots);
  EXPECT_EQ(preset.settings.glass.tint[2], 0.7);
  EXPECT_EQ(preset.settings.deflection.convergence[2].edge_y_mm, -0.5);
}

TEST(TubePreset, FaultsAreToldByLine) {
  const auto expect = [](const std::string& text, const std::string& what) {
    const std::string fault = fault_of("mode 640x480@60\n" + text);
    EXPECT_NE(fault.find(what), std::string::npos) << text << ": " << fault;
    EXPECT_NE(fault.find("line 2"), std::string::npos) << fault;
    EXPECT_EQ(fault.find('\n'), std::string::npos) << fault;
  };
  expect("spot.colour 3", "no setting is called \"spot.colour\"");
  expect("spot.sigma 3 Hz", "given in mm or cm or m or in");
  expect("spot.sigma -0.1 mm", "must lie from 0");
  expect("spot.sigma nan mm", "not a number");
  expect("spot.sigma 1e400 mm", "not a number");
  expect("spot.sigma mm", "not a number");
  expect("spot.sigma", "a key and its value");
  expect("mask.kind sieve", "there are none, dots, grille, slots");
  expect("phosphor P99", "P31");
  expect("mode 0x0@0", "");
  expect("glass.tint 1 2 3", "shares");
  expect("glass.tint 1", "red, green and blue");
  EXPECT_NE(fault_of("phosphor P1\n").find("mode"), std::string::npos);
  EXPECT_NE(fault_of("").find("mode"), std::string::npos);
}

TEST(TubePreset, AnyKeyCanBeOverridden) {
  TubeSettings settings = find_tube_preset("vga-14").settings;
  override_tube_setting(settings, "spot.sigma=0.3mm");
  EXPECT_EQ(settings.spot.sigma_mm, 0.3);
  override_tube_setting(settings, "mask.kind=none");
  EXPECT_EQ(settings.mask.kind, MaskKind::kNone);
  for (const char* bad : {"spot.sigma", "spot.sigma=3 kg", "what=1", "=", "spot.sigma="}) {
    try {
      override_tube_setting(settings, bad);
      FAIL() << bad;
    } catch (const Error& error) {
      EXPECT_EQ(error.exit_code(), 2) << bad;
    }
  }
}

TEST(TubePreset, HelpNamesEveryKeyOnce) {
  std::set<std::string_view> keys;
  const std::string help = tube_setting_help();
  for (const TubeNumber& number : tube_numbers()) {
    EXPECT_TRUE(keys.insert(number.key).second) << number.key;
    EXPECT_NE(help.find(number.key), std::string::npos);
    TubeSettings settings;
    const double is = number.of(settings);
    EXPECT_GE(is, number.least) << number.key;
    EXPECT_LE(is, number.most) << number.key;
  }
}

TEST(TubePreset, BuiltInOnesAreWholeAndDifferent) {
  std::set<std::string> names, notes;
  for (const TubePreset& preset : tube_presets()) {
    EXPECT_TRUE(names.insert(preset.name).second);
    EXPECT_TRUE(notes.insert(preset.note).second) << preset.name;
    EXPECT_FALSE(preset.note.empty()) << preset.name;
  }
  for (const char* name : {"terminal-green", "terminal-amber", "television-white", "vga-14",
                           "grille-pro", "television-slot", "arcade", "radar"}) {
    EXPECT_EQ(names.count(name), 1u) << name;
  }
}

TEST(TubePreset, UnknownNamesAndMissingFilesAreToldApart) {
  try {
    find_tube_preset("plasma");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.exit_code(), 2);
    EXPECT_NE(std::string(error.what()).find("arcade"), std::string::npos);
  }
  try {
    find_tube_preset("no/such.txt");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.exit_code(), 3);
  }
}

}  // namespace
}  // namespace kinescope
