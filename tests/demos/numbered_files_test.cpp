#include "demos/numbered_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "raster/base/error.h"
#include "tests/demos/program_run.h"

namespace kinescope {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(NumberedName, NumbersFillTheHashes) {
  EXPECT_EQ(numbered_name("frame_####.png", 7), "frame_0007.png");
  EXPECT_EQ(numbered_name("frame_##.png", 12345), "frame_12345.png");
  EXPECT_EQ(numbered_name("#", 0), "0");
  EXPECT_EQ(numbered_name("a#/b##.png", 3), "a#/b03.png");
  EXPECT_EQ(numbered_name("plain.png", 3), "plain.png");
}

TEST(NumberedFiles, AreFoundByNumberAndNothingElseIs) {
  test::TemporaryFolder folder;
  for (const char* name : {"f_08.png", "f_09.png", "f_10.png", "f_7.png", "f_011.png", "f_x1.png",
                           "g_11.png", "f_11.jpg", "f_-1.png", "f_11.png.part"}) {
    test::write_text(folder / name, "");
  }
  EXPECT_THAT(numbered_files(folder / "f_##.png"),
              ElementsAre(folder / "f_08.png", folder / "f_09.png", folder / "f_10.png"));
  for (const char* name : {"f_99.png", "f_100.png"}) test::write_text(folder / name, "");
  EXPECT_THROW(numbered_files(folder / "f_##.png"), Error);
}

TEST(NumberedFiles, GrowLongerThanTheirHashes) {
  test::TemporaryFolder folder;
  for (const char* name : {"8", "9", "10", "11"}) test::write_text(folder / name, "");
  EXPECT_EQ(numbered_files(folder / "#").size(), 4u);
}

TEST(NumberedFiles, SayWhatIsMissing) {
  test::TemporaryFolder folder;
  const auto fault = [&](const std::string& pattern) -> std::string {
    try {
      numbered_files(pattern);
    } catch (const Error& error) {
      EXPECT_EQ(error.exit_code(), 3);
      return error.what();
    }
    return "none";
  };
  EXPECT_THAT(fault(folder / "f#.png"), HasSubstr("f#.png: there are no pictures"));
  EXPECT_THAT(fault(folder / "none/f#.png"), HasSubstr("none/f#.png: cannot be read"));
  for (const char* name : {"f1.png", "f2.png", "f4.png"}) test::write_text(folder / name, "");
  EXPECT_THAT(fault(folder / "f#.png"), HasSubstr("f3.png: missing"));
}

}  // namespace
}  // namespace kinescope
