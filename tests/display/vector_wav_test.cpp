#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "display/vector/input/wav_reader.h"
#include "raster/base/error.h"

namespace kinescope {
namespace {

std::string number(std::uint32_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> 8 * i & 255);
  return text;
}

std::string wav(unsigned kind, unsigned channels, unsigned bits, const std::string& data) {
  const unsigned frame = channels * bits / 8;
  return "RIFF" + number(36 + static_cast<unsigned>(data.size()), 4) + "WAVEfmt " + number(16, 4) +
         number(kind, 2) + number(channels, 2) + number(48000, 4) + number(48000 * frame, 4) +
         number(frame, 2) + number(bits, 2) + "junk" + number(3, 4) + "abc" + '\0' + "data" +
         number(static_cast<unsigned>(data.size()), 4) + data;
}

VectorDrawing read(const std::string& text) {
  return read_wav({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, "a.wav");
}

TEST(WavReader, EveryWidthOfSampleGivesTheSameStrokes) {
  // From (0, 0) to (1/256, -1/2) of full scale.
  const VectorSegment expected{0, 0, 128, -16384, 128.0f / std::hypot(128.0f, 16384.0f)};
  const auto pcm = [&](int bytes) {
    const auto sample = [&](std::int32_t high16) {
      return number(static_cast<std::uint32_t>(high16) << 16 >> (32 - 8 * bytes), bytes);
    };
    return sample(0) + sample(0) + sample(128) + sample(-16384);
  };
  for (const int bytes : {2, 3, 4}) {
    const auto drawing = read(wav(1, 2, static_cast<unsigned>(8 * bytes), pcm(bytes)));
    EXPECT_EQ(drawing.segments, std::vector{expected}) << bytes;
    EXPECT_EQ(drawing.origin, glm::vec2(-32768));
  }
  EXPECT_EQ(read(wav(1, 2, 8, "\x80\x80\x81\x40")).segments.at(0).x2, 256);
  const float floats[] = {0, 0, 1.0f / 256, -0.5f};
  std::string data(sizeof floats, '\0');
  std::memcpy(data.data(), floats, sizeof floats);
  EXPECT_EQ(read(wav(3, 2, 32, data)).segments, std::vector{expected});
}

TEST(WavReader, MoreChannelsAndCutOffData) {
  const std::string frame = number(1, 2) + number(2, 2) + number(99, 2);
  EXPECT_EQ(read(wav(1, 3, 16, frame + frame)).segments,
            (std::vector<VectorSegment>{{1, 2, 1, 2, 1}}));
  const std::string whole = wav(1, 3, 16, frame + frame + frame);
  EXPECT_EQ(read(whole.substr(0, whole.size() - 1)).segments.size(), 1u);
}

TEST(WavReader, BadFilesAreOneClearLine) {
  const auto fault = [](const std::string& text) -> std::string {
    try {
      read(text);
    } catch (const Error& error) {
      return error.what();
    }
    return "none";
  };
  using ::testing::HasSubstr;
  EXPECT_THAT(fault(""), HasSubstr("no RIFF"));
  EXPECT_THAT(fault(wav(1, 1, 16, "abcd")), HasSubstr("one channel"));
  EXPECT_THAT(fault(wav(2, 2, 4, "abcd")), HasSubstr("samples are neither"));
  EXPECT_THAT(fault(wav(1, 2, 16, "").substr(0, 40)), HasSubstr("no data"));
  EXPECT_THAT(fault("RIFF____WAVEdata" + number(4, 4) + "abcd"), HasSubstr("no fmt"));
}

}  // namespace
}  // namespace kinescope
