#include "raster/base/error.h"

#include <gtest/gtest.h>

namespace kinescope {
namespace {

TEST(Error, JoinsFileAndPlaceAndFaultInOneLine) {
  EXPECT_STREQ(Error(ErrorKind::kBadInput, "an odd index", "a.obj", "line 12").what(),
               "a.obj: line 12: an odd index");
  EXPECT_STREQ(Error(ErrorKind::kBadInput, "an odd index", "a.obj").what(), "a.obj: an odd index");
  EXPECT_STREQ(Error(ErrorKind::kBadInput, "an odd index", "", "line 12").what(),
               "line 12: an odd index");
  EXPECT_STREQ(Error(ErrorKind::kUsage, "no such demo").what(), "no such demo");
}

TEST(Error, KeepsControlCharactersOutOfTheLine) {
  EXPECT_STREQ(Error(ErrorKind::kBadInput, "tag \"a\nb\x1b[2J\"", "x\r.ply").what(),
               "x?.ply: tag \"a?b?[2J\"");
  EXPECT_STREQ(Error(ErrorKind::kBadInput, "µ stays", "é.obj").what(), "é.obj: µ stays");
}

TEST(Error, KindIsTheExitCode) {
  EXPECT_EQ(Error(ErrorKind::kUsage, "x").exit_code(), 2);
  EXPECT_EQ(Error(ErrorKind::kBadInput, "x").exit_code(), 3);
  EXPECT_EQ(Error(ErrorKind::kCannotWrite, "x").exit_code(), 4);
}

TEST(Error, ShorthandThrowsBadInput) {
  try {
    throw_bad_input("no triangles", "b.stl", "byte 80");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
    EXPECT_STREQ(error.what(), "b.stl: byte 80: no triangles");
  }
}

}  // namespace
}  // namespace kinescope
