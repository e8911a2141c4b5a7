// `kinescope demo`, and `kinescope` alone, from outside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/demos/program_render.h"

namespace kinescope::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

TEST(ProgramDemo, AloneWithoutADisplayWritesTheTeapot) {
  TemporaryFolder folder;
  const RunResult run = run_kinescope({}, {.folder = folder.path()});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("out/teapot.png"));
  const Image<Srgb8> p = read_image_file(folder / "out/teapot.png");
  EXPECT_EQ(p.width(), 1280);
  EXPECT_GT(mean_brightness(p), 5);
}

TEST(ProgramDemo, FramesFollowTheSeedAndTheScriptAndNothingElse) {
  TemporaryFolder folder;
  write_text(folder / "script.txt", "2 drag 100 100 160 110 4\n");
  const std::vector<std::string> common{"demo", "teapot", "--size", "320x240", "--frames",
                                        "0-7",  "--json", "-o",     "film.y4m"};
  auto scripted = common, one = common;
  one.insert(one.end(), {"--threads", "1"});
  scripted.insert(scripted.end(), {"--script", "script.txt"});
  const auto hashes = [&](const std::vector<std::string>& arguments) {
    const RunResult run = run_kinescope(arguments, {.folder = folder.path()});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return parse_json(run.out)["picture_hashes"];
  };
  const json plain = hashes(common);
  EXPECT_EQ(plain.size(), 8u);
  EXPECT_EQ(plain, hashes(one));
  EXPECT_NE(plain, hashes(scripted));
}

}  // namespace
}  // namespace kinescope::test
