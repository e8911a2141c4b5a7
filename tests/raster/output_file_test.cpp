#include "raster/base/output_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <functional>
#include <thread>

#include "raster/base/error.h"
#include "tests/raster/scratch.h"

namespace kinescope {
namespace {

using ::testing::HasSubstr;
using testing::Scratch;
using ::testing::StartsWith;

std::string error_of(ErrorKind kind, const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind);
    return error.what();
  }
  return "no error";
}

void write_whole(const std::string& path, const std::string& text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

TEST(OutputFile, AppearsWhenCommittedAndNotBefore) {
  const Scratch scratch;
  const std::string path = scratch.path("a.txt");
  {
    OutputFile file(path);
    file.write("half");
    EXPECT_FALSE(std::filesystem::exists(path));
    file.write(" and half");
    file.commit();
    EXPECT_EQ(Scratch::text(path), "half and half");
  }
  EXPECT_EQ(Scratch::text(path), "half and half");
  EXPECT_EQ(scratch.file_count(), 1);
}

TEST(OutputFile, WithoutCommitLeavesTheOlderFileAndNothingElse) {
  const Scratch scratch;
  const std::string path = scratch.path("a.txt");
  Scratch::put(path, "older");
  {
    OutputFile file(path);
    file.write("newer");
    EXPECT_EQ(Scratch::text(path), "older");
    EXPECT_EQ(scratch.file_count(), 2);
  }
  EXPECT_EQ(Scratch::text(path), "older");
  EXPECT_EQ(scratch.file_count(), 1);
}

TEST(OutputFile, SeveralAtOnceForOneNameDoNotMix) {
  const Scratch scratch;
  OutputFile a(scratch.path("x")), b(scratch.path("x"));
  a.write("aaa");
  b.write("b");
  a.commit();
  EXPECT_EQ(Scratch::text(scratch.path("x")), "aaa");
  b.commit();
  EXPECT_EQ(Scratch::text(scratch.path("x")), "b");
  EXPECT_EQ(scratch.file_count(), 1);
}

TEST(OutputFile, KeepsPermissionsAndSymbolicLinks) {
  const Scratch scratch;
  Scratch::put(scratch.path("real"), "older");
  chmod(scratch.path("real").c_str(), 0640);
  std::filesystem::create_symlink("real", scratch.path("link"));
  write_whole(scratch.path("link"), "newer");
  EXPECT_TRUE(std::filesystem::is_symlink(scratch.path("link")));
  EXPECT_EQ(Scratch::text(scratch.path("real")), "newer");
  struct stat info {};
  stat(scratch.path("real").c_str(), &info);
  EXPECT_EQ(info.st_mode & 07777, 0640u);
}

TEST(OutputFile, NamesTheFileThatCannotBeWritten) {
  const Scratch scratch;
  const std::string folder = scratch.path("folder");
  std::filesystem::create_directory(folder);
  for (const std::string& path : {scratch.path("none/a.png"), folder, std::string("/proc/a.png"),
                                  std::string(), scratch.path(std::string(300, 'n'))}) {
    EXPECT_THAT(error_of(ErrorKind::kCannotWrite, [&] { write_whole(path, "x"); }),
                StartsWith(path.empty() ? "cannot be written: " : path + ": cannot be written: "));
  }
  EXPECT_EQ(scratch.file_count(), 1);
}

TEST(OutputFile, AFullDeviceIsAnError) {
  const std::string line =
      error_of(ErrorKind::kCannotWrite, [] { write_whole("/dev/full", "some text"); });
  EXPECT_EQ(line, "/dev/full: cannot be written: No space left on device");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST(OutputFile, AFullDiskLeavesTheOlderFile) {
  const Scratch scratch;
  const std::string path = scratch.path("a.bin");
  Scratch::put(path, "older");
  // The limit on the size of a file stands for the end of a disk.
  const auto before_signal = std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{10000, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string line =
      error_of(ErrorKind::kCannotWrite, [&] { write_whole(path, std::string(100000, 'x')); });
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, before_signal);
  EXPECT_THAT(line, StartsWith(path + ": cannot be written: "));
  EXPECT_EQ(Scratch::text(path), "older");
  EXPECT_EQ(scratch.file_count(), 1);
}

TEST(OutputFile, WritesIntoAPipeThatExists) {
  const Scratch scratch;
  const std::string path = scratch.path("pipe");
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  std::string got;
  std::thread reader([&] { got = Scratch::text(path); });
  write_whole(path, std::string(200000, 'p'));
  reader.join();
  EXPECT_EQ(got, std::string(200000, 'p'));
  EXPECT_TRUE(std::filesystem::is_fifo(path));
  EXPECT_EQ(scratch.file_count(), 1);
}

// No test changes what SIGPIPE does: had one been raised, this program would be gone.
TEST(OutputFile, AClosedPipeIsAnErrorAndNoSignal) {
  const Scratch scratch;
  const std::string path = scratch.path("pipe");
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  const int reader = open(path.c_str(), O_RDONLY | O_NONBLOCK);
  {
    OutputFile file(path);
    close(reader);
    EXPECT_EQ(error_of(ErrorKind::kCannotWrite, [&] { file.write(std::string(100000, 'p')); }),
              path + ": cannot be written: Broken pipe");
  }
  sigset_t pending;
  sigpending(&pending);
  EXPECT_FALSE(sigismember(&pending, SIGPIPE));
}

class StandardOutput : public ::testing::Test {
 protected:
  StandardOutput() : saved_(dup(STDOUT_FILENO)) {
    std::fflush(stdout);
    EXPECT_EQ(pipe(ends_), 0);
    dup2(ends_[1], STDOUT_FILENO);
    close(ends_[1]);
  }
  ~StandardOutput() override { restore(); }
  void restore() {
    if (saved_ < 0) return;
    dup2(saved_, STDOUT_FILENO);
    close(saved_);
    saved_ = -1;
  }
  int saved_;
  int ends_[2];
};

TEST_F(StandardOutput, IsWrittenForADash) {
  write_whole("-", "bytes");
  restore();
  std::string got(16, '\0');
  got.resize(static_cast<std::size_t>(read(ends_[0], got.data(), got.size())));
  close(ends_[0]);
  EXPECT_EQ(got, "bytes");
}

TEST_F(StandardOutput, ClosedIsAnErrorThatSaysSo) {
  close(ends_[0]);
  const std::string line = error_of(ErrorKind::kCannotWrite, [] { write_whole("-", "bytes"); });
  restore();
  EXPECT_EQ(line, "standard output: cannot be written: Broken pipe");
}

TEST(OutputFile, UnfinishedFilesGoWhenASignalAsks) {
  const Scratch scratch;
  Scratch::put(scratch.path("older"), "older");
  {
    OutputFile done(scratch.path("done")), replaced(scratch.path("older"));
    done.commit();
    OutputFile fresh(scratch.path("fresh"));
    EXPECT_EQ(scratch.file_count(), 4);
    OutputFile::remove_unfinished();
    EXPECT_EQ(scratch.file_count(), 2);
    EXPECT_THAT(error_of(ErrorKind::kCannotWrite, [&] { fresh.commit(); }), HasSubstr("renamed"));
  }
  EXPECT_EQ(Scratch::text(scratch.path("older")), "older");
  EXPECT_TRUE(std::filesystem::exists(scratch.path("done")));
  EXPECT_EQ(scratch.file_count(), 2);
}

TEST(OutputFile, MoreThanASignalHandlerCanRemoveIsRefused) {
  const Scratch scratch;
  std::vector<std::unique_ptr<OutputFile>> files;
  const std::string line = error_of(ErrorKind::kCannotWrite, [&] {
    for (int i = 0; i < 100; ++i) {
      files.push_back(std::make_unique<OutputFile>(scratch.path(std::to_string(i))));
    }
  });
  EXPECT_THAT(line, HasSubstr("too many files"));
  OutputFile::remove_unfinished();
  EXPECT_EQ(scratch.file_count(), 0);
}

}  // namespace
}  // namespace kinescope
