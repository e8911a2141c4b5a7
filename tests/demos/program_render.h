// `kinescope render` in a folder with a model, and what its pictures are compared by.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "raster/image/codecs.h"
#include "tests/demos/parse_json.h"
#include "tests/demos/program_run.h"

namespace kinescope::test {

/// A folder with model.obj in it, to render in.
class ProgramRender : public ::testing::Test {
 protected:
  ProgramRender() { write_text(folder_ / "model.obj", cube_obj()); }
  RunResult run(std::vector<std::string> more) const {
    std::vector<std::string> arguments{"render", "model.obj"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const RunResult result = run_kinescope(arguments, {.folder = folder_.path()});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result;
  }
  nlohmann::json figures(std::vector<std::string> more) const {
    more.push_back("--json");
    return parse_json(run(std::move(more)).out);
  }
  Image<Srgb8> picture(std::vector<std::string> more) const {
    more.insert(more.end(), {"-o", "picture.png"});
    run(std::move(more));
    return read_image_file(folder_ / "picture.png");
  }
  TemporaryFolder folder_;
};

inline double brightness(Srgb8 c) { return (c.r + c.g + c.b) / 3.0; }

inline double mean_brightness(const Image<Srgb8>& picture) {
  double sum = 0;
  for (const Srgb8 c : picture.pixels()) sum += brightness(c);
  return sum / static_cast<double>(picture.pixels().size());
}

/// Mean over the pixels of how far the brightness is apart.
inline double difference(const Image<Srgb8>& a, const Image<Srgb8>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    sum += std::abs(brightness(a.pixels()[i]) - brightness(b.pixels()[i]));
  }
  return sum / static_cast<double>(a.pixels().size());
}

}  // namespace kinescope::test
