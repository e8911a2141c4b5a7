#include "raster/base/input_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <functional>
#include <thread>

#include "raster/base/error.h"
#include "tests/raster/scratch.h"

namespace kinescope {
namespace {

using ::testing::HasSubstr;
using testing::Scratch;

std::string error_of(ErrorKind kind, const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind);
    return error.what();
  }
  return "no error";
}

TEST(ReadFile, GivesTheWholeFile) {
  const Scratch scratch;
  for (const std::size_t size : {0, 1, 65535, 65536, 65537, 300000}) {
    std::string text;
    for (std::size_t i = 0; i < size; ++i) text += static_cast<char>(i * 7);
    Scratch::put(scratch.path("f"), text);
    const std::vector<std::uint8_t> bytes = read_file(scratch.path("f"));
    EXPECT_EQ(std::string(bytes.begin(), bytes.end()), text);
  }
}

TEST(ReadFile, ReadsAPipe) {
  const Scratch scratch;
  const std::string path = scratch.path("pipe");
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  std::thread writer([&] { Scratch::put(path, std::string(150000, 'q')); });
  EXPECT_EQ(read_file(path).size(), 150000u);
  writer.join();
}

TEST(ReadFile, SaysWhatIsWrong) {
  const Scratch scratch;
  const auto line = [](const std::string& path, std::size_t limit) {
    return error_of(ErrorKind::kBadInput, [&] { read_file(path, limit); });
  };
  EXPECT_EQ(line(scratch.path("none"), 10),
            scratch.path("none") + ": cannot be read: No such file or directory");
  EXPECT_EQ(line(scratch.path(""), 10), scratch.path("") + ": cannot be read: Is a directory");
  Scratch::put(scratch.path("f"), "12345678901");
  EXPECT_THAT(line(scratch.path("f"), 10), HasSubstr("larger than the 10 bytes"));
  EXPECT_THAT(line("/dev/zero", 100000), HasSubstr("larger than"));
  EXPECT_EQ(read_file(scratch.path("f"), 11).size(), 11u);
}

/// The same bytes as a file and at hand.
class InputFileBytes : public ::testing::TestWithParam<bool> {
 protected:
  InputFileBytes() {
    for (int i = 0; i < 200000; ++i) bytes_.push_back(static_cast<std::uint8_t>(i * 31 >> 3));
    bytes_[5] = bytes_[70000] = '\n';
    for (std::size_t i = 6; i < 70000; ++i) bytes_[i] &= 0xf0;
    for (std::size_t i = 0; i < 5; ++i) bytes_[i] = 'a';
    if (!GetParam()) Scratch::put(scratch_.path("f"), {bytes_.begin(), bytes_.end()});
  }
  std::unique_ptr<InputFile> open() {
    return GetParam() ? std::make_unique<InputFile>(bytes_, "bytes")
                      : std::make_unique<InputFile>(scratch_.path("f"));
  }
  const Scratch scratch_;
  std::vector<std::uint8_t> bytes_;
};

TEST_P(InputFileBytes, PeekTakesNothing) {
  const auto file = open();
  const auto ahead = file->peek(100000);
  ASSERT_GE(ahead.size(), 100000u);
  EXPECT_TRUE(std::equal(ahead.begin(), ahead.begin() + 100000, bytes_.begin()));
  EXPECT_EQ(file->position(), 0u);
  EXPECT_EQ(file->peek(1000000).size(), bytes_.size());
  EXPECT_EQ(file->rest(1000000), bytes_);
  EXPECT_EQ(file->position(), bytes_.size());
  EXPECT_TRUE(file->peek(1).empty());
}

TEST_P(InputFileBytes, LinesAndPiecesFollowEachOther) {
  const auto file = open();
  std::string line;
  ASSERT_TRUE(file->read_line(line, 100));
  EXPECT_EQ(line, "aaaaa");
  EXPECT_EQ(file->position(), 6u);
  EXPECT_FALSE(file->read_line(line, 100)) << "none ends so soon";
  EXPECT_EQ(file->position(), 6u);
  std::vector<std::uint8_t> piece{1, 2};
  EXPECT_EQ(file->append_to(piece, 10), 10u);
  EXPECT_EQ(piece.size(), 12u);
  EXPECT_EQ(piece[0], 1);
  EXPECT_EQ(piece[2], bytes_[6]);
  ASSERT_TRUE(file->read_line(line, 100000));
  EXPECT_EQ(line.size(), 70000u - 16);
  EXPECT_EQ(file->position(), 70001u);
  piece.clear();
  EXPECT_EQ(file->append_to(piece, 1000000), bytes_.size() - 70001);
  EXPECT_TRUE(std::equal(piece.begin(), piece.end(), bytes_.begin() + 70001));
  EXPECT_EQ(file->append_to(piece, 5), 0u);
  EXPECT_FALSE(file->read_line(line, 5));
}

INSTANTIATE_TEST_SUITE_P(FromAFileAndAtHand, InputFileBytes, ::testing::Bool());

TEST(InputFile, WhatIsClaimedButDoesNotComeTakesNoMemory) {
  const std::vector<std::uint8_t> few(10);
  InputFile file(few, "few");
  std::vector<std::uint8_t> bytes;
  EXPECT_EQ(file.append_to(bytes, std::size_t{1} << 40), 10u);
  const Scratch scratch;
  Scratch::put(scratch.path("f"), std::string(10, 'x'));
  InputFile on_disk(scratch.path("f"));
  bytes.clear();
  EXPECT_EQ(on_disk.append_to(bytes, std::size_t{1} << 40), 10u);
  EXPECT_LT(bytes.capacity(), 1u << 18);
}

}  // namespace
}  // namespace kinescope
