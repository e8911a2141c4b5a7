// What YUV4MPEG2 headers are taken, and how damaged films end.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "raster/base/error.h"
#include "tests/raster/y4m_bytes.h"

namespace kinescope {
namespace {

using ::testing::HasSubstr;
using testing::HeldFilm;
using ::testing::StartsWith;

/// The fault of the film, and how many frames came before it.
struct Ending {
  std::string fault;
  int frames = 0;
};

Ending ending_of(const std::string& bytes) {
  Ending ending;
  try {
    HeldFilm film(bytes);
    Image<Srgb8> frame;
    while (film->read(frame)) ++ending.frames;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
    EXPECT_THAT(error.what(), StartsWith("film: "));
    ending.fault = error.what();
  }
  return ending;
}

const std::string kHeader = "YUV4MPEG2 W4 H2 F30000:1001 Ip A10:11 C444\n";
const std::string kFrame = "FRAME\n" + std::string(24, '\x80');

TEST(Y4mReader, ReadsHeadersAndFrames) {
  HeldFilm film(kHeader + kFrame + "FRAME Xanything\n" + std::string(24, '\x60'));
  EXPECT_EQ(film->format().width, 4);
  EXPECT_EQ(film->format().height, 2);
  EXPECT_EQ(film->rate().numerator, 30000);
  EXPECT_EQ(film->rate().denominator, 1001);
  EXPECT_DOUBLE_EQ(film->pixel_aspect().value(), 10.0 / 11);
  Image<Srgb8> frame;
  EXPECT_TRUE(film->read(frame));
  EXPECT_TRUE(film->read(frame));
  EXPECT_FALSE(film->read(frame));
  EXPECT_FALSE(film->read(frame));
}

TEST(Y4mReader, MostWordsMayBeLeftOut) {
  HeldFilm film("YUV4MPEG2 H2 W4\nFRAME\n" + std::string(12, '\x80'));
  EXPECT_EQ(film->format().chroma_across, 2);
  EXPECT_DOUBLE_EQ(film->rate().hertz(), 25);
  EXPECT_FALSE(film->pixel_aspect().has_value());
  Image<Srgb8> frame;
  EXPECT_TRUE(film->read(frame));
  HeldFilm unknown("YUV4MPEG2 H2 W4 F0:0 A0:0 I? Xwhatever=7 XYSCSS=420JPEG\n");
  EXPECT_DOUBLE_EQ(unknown->rate().hertz(), 25);
  EXPECT_FALSE(unknown->pixel_aspect().has_value());
}

TEST(Y4mReader, OddSizesHaveHalfSamplesAtTheirEnds) {
  const Ending ending = ending_of("YUV4MPEG2 W5 H3 C420\nFRAME\n" + std::string(15 + 2 * 6, 'a'));
  EXPECT_EQ(ending.frames, 1);
  EXPECT_EQ(ending.fault, "");
}

TEST(Y4mReader, FilmsLaidEndToEndAreOne) {
  const Ending ending = ending_of(kHeader + kFrame + kHeader + kFrame + kFrame);
  EXPECT_EQ(ending.frames, 3);
  EXPECT_EQ(ending.fault, "");
}

TEST(Y4mReader, AFilmThatChangesEndsThere) {
  const Ending size = ending_of(kHeader + kFrame + "YUV4MPEG2 W8 H2 C444\n" + kFrame);
  EXPECT_EQ(size.frames, 1);
  EXPECT_EQ(size.fault, "film: frame 1: the film changes its size from 4x2 to 8x2");
  const Ending colours = ending_of(kHeader + kFrame + "YUV4MPEG2 W4 H2 C422\n" + kFrame);
  EXPECT_EQ(colours.fault, "film: frame 1: the film changes its format");
}

TEST(Y4mReader, CutOffAnywhereItGivesWholeFramesAndOneLine) {
  const std::string whole = kHeader + kFrame + kFrame;
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const Ending ending = ending_of(whole.substr(0, size));
    const std::size_t after = size < kHeader.size() ? 0 : size - kHeader.size();
    EXPECT_EQ(ending.frames, static_cast<int>(after / kFrame.size())) << size;
    const bool between = size >= kHeader.size() && after % kFrame.size() == 0;
    EXPECT_EQ(ending.fault.empty(), between) << size << ending.fault;
  }
  EXPECT_EQ(ending_of(whole.substr(0, whole.size() - 5)).fault,
            "film: frame 1: the film ends in the middle of a frame, after 19 of its 24 bytes");
}

TEST(Y4mReader, RefusesHeadersInOneLine) {
  const auto refused = [](const std::string& words, const std::string& why) {
    const Ending ending = ending_of("YUV4MPEG2 " + words + "\n" + kFrame);
    EXPECT_EQ(ending.frames, 0) << words;
    EXPECT_THAT(ending.fault, HasSubstr(why)) << words;
  };
  refused("W31623 H31623", "31623x31623 pixels is too large");
  refused("W999999999 H2", "too large");
  refused("W99999999999999999999 H2", "\"W99999999999999999999\" in the YUV4MPEG2 header");
  refused("W-4 H2", "not a number of pixels");
  refused("W4.5 H2", "not a number of pixels");
  refused("W4", "4x0 pixels has no pixels");
  refused("W0 H2", "0x2 pixels has no pixels");
  refused("", "has no pixels");
  refused("W4 H2 F30", "not a rate");
  refused("W4 H2 F-30:1", "not a rate");
  refused("W4 H2 F1:0", "not a rate at which a film can run");
  refused("W4 H2 F1000000000:1", "not a rate at which a film can run");
  refused("W4 H2 Im", "interlaced frames among others");
  refused("W4 H2 Iz", "order of fields");
  refused("W4 H2 A1", "not a shape of pixels");
  refused("W4 H2 C410", "4:2:0, 4:2:2");
  refused("W4 H2 C444alpha", "4:2:0, 4:2:2");
  refused("W4 H2 C420p8", "4:2:0, 4:2:2");
  refused("W4 H2 C420p17", "4:2:0, 4:2:2");
  refused("W4 H2 C420p", "4:2:0, 4:2:2");
  refused("W4 H2 C", "4:2:0, 4:2:2");
  refused("W4 H2 XMATRIX=2020", "601 or 709");
  refused("W4 H2 Q7", "no such parameter");
  EXPECT_THAT(ending_of("YUV4MPEG2X W4 H2\n").fault, HasSubstr("not a YUV4MPEG2 film"));
  EXPECT_THAT(ending_of("YUV4MPEG2 " + std::string(2000, 'X') + "\n").fault,
              HasSubstr("no end of a header line"));
  EXPECT_EQ(ending_of(kHeader + kFrame + "FRAMES\n").fault,
            "film: frame 1: no FRAME where one should begin");
}

TEST(Y4mReader, TheUsersMatrixWins) {
  const std::string bytes = "YUV4MPEG2 W1 H1 C444 XMATRIX=601\nFRAME\n\x50\x40\xa0";
  const std::vector<std::uint8_t> held(bytes.begin(), bytes.end());
  InputFile file(held, "film");
  Workers workers(2);
  EXPECT_EQ(read_y4m(file, workers, YuvMatrix::kBt709)->format().matrix, YuvMatrix::kBt709);
}

TEST(RawVideo, ReadsEachLayout) {
  const auto first = [](const std::string& name, std::vector<std::uint8_t> bytes) {
    InputFile file(bytes, "film");
    Workers workers(2);
    const auto reader = read_raw_video(file, workers, raw_format(name, 1, 1).value(), Rate{60, 1});
    Image<Srgb8> frame;
    EXPECT_TRUE(reader->read(frame)) << name;
    EXPECT_FALSE(reader->read(frame)) << name;
    return frame.at(0, 0);
  };
  EXPECT_EQ(first("rgb24", {1, 2, 3}), (Srgb8{1, 2, 3, 255}));
  EXPECT_EQ(first("rgba", {1, 2, 3, 4}), (Srgb8{1, 2, 3, 4}));
  EXPECT_EQ(first("bgra", {1, 2, 3, 4}), (Srgb8{3, 2, 1, 4}));
  EXPECT_EQ(first("gray8", {7}), (Srgb8{7, 7, 7, 255}));
  EXPECT_EQ(first("gray", {7}), (Srgb8{7, 7, 7, 255}));
  EXPECT_EQ(first("yuv420p", {235, 128, 128}), (Srgb8{255, 255, 255, 255}));
  EXPECT_EQ(first("yuv444p", {16, 128, 128}), (Srgb8{0, 0, 0, 255}));
  EXPECT_FALSE(raw_format("nv12", 1, 1).has_value());
}

TEST(RawVideo, EndsInOneLine) {
  const auto fault = [](std::size_t size) -> std::string {
    const std::vector<std::uint8_t> bytes(size);
    InputFile file(bytes, "film");
    Workers workers(2);
    const auto reader =
        read_raw_video(file, workers, raw_format("rgb24", 2, 2).value(), Rate{60, 1});
    Image<Srgb8> frame;
    try {
      while (reader->read(frame)) {
      }
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(fault(0), "film: an empty file, not a film");
  EXPECT_EQ(fault(24), "");
  EXPECT_EQ(fault(30),
            "film: frame 2: the film ends in the middle of a frame, after 6 of its 12 bytes");
}

}  // namespace
}  // namespace kinescope
