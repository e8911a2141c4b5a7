#include "tests/demos/program_run.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace kinescope::test {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kLongest(60);

struct Pipe {
  Pipe() { EXPECT_EQ(pipe2(ends.data(), O_CLOEXEC), 0); }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  void close_end(std::size_t i) {
    if (ends[i] >= 0) close(ends[i]);
    ends[i] = -1;
  }
  std::array<int, 2> ends{-1, -1};
};

[[noreturn]] void become(const std::vector<std::string>& command, const RunOptions& options, int in,
                         int out, int err) {
  if (!options.folder.empty() && chdir(options.folder.c_str()) != 0) _exit(125);
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"}) unsetenv(name);
  for (const std::string& setting : options.environment) {
    const std::size_t equals = setting.find('=');
    setenv(setting.substr(0, equals).c_str(), setting.substr(equals + 1).c_str(), 1);
  }
  if (!options.out_path.empty()) out = open(options.out_path.c_str(), O_WRONLY | O_CREAT, 0666);
  dup2(in, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) ::signal(signal, SIG_DFL);
  const std::string path = std::string(KINESCOPE_BIN_DIR ":") + getenv("PATH");
  setenv("PATH", path.c_str(), 1);
  std::vector<char*> argv;
  for (const std::string& word : command) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  execvp(argv.front(), argv.data());
  _exit(126);
}

/// Reads both ends until they close; sends the signal when its time has come.
void gather(pid_t child, const RunOptions& options, std::array<int, 2> ends, RunResult& result) {
  const Clock::time_point start = Clock::now();
  bool to_stop = options.stop_signal != 0;
  std::array<pollfd, 2> watched{{{ends[0], POLLIN, 0}, {ends[1], POLLIN, 0}}};
  while (watched[0].fd >= 0 || watched[1].fd >= 0) {
    poll(watched.data(), watched.size(), 20);
    const auto now = Clock::now() - start;
    if (to_stop && now >= std::chrono::milliseconds(options.stop_after_ms)) {
      kill(child, options.stop_signal);
      to_stop = false;
    }
    if (now > kLongest) {
      kill(child, SIGKILL);
      ADD_FAILURE() << "kinescope did not end within a minute";
      return;
    }
    for (std::size_t i = 0; i < 2; ++i) {
      if (watched[i].fd < 0 || watched[i].revents == 0) continue;
      std::array<char, 65536> buffer;
      const ssize_t count = read(watched[i].fd, buffer.data(), buffer.size());
      if (count <= 0) watched[i].fd = -1;
      if (count > 0) (i == 0 ? result.out : result.err).append(buffer.data(), size_t(count));
    }
  }
}

RunResult run_command(const std::vector<std::string>& command, const RunOptions& options) {
  Pipe in, out, err;
  // Small enough for the pipe's own buffer: no need to feed it.
  EXPECT_LE(options.input.size(), 60000u);
  EXPECT_EQ(write(in.ends[1], options.input.data(), options.input.size()),
            static_cast<ssize_t>(options.input.size()));
  if (options.close_out) out.close_end(0);
  const pid_t child = fork();
  if (child == 0) become(command, options, in.ends[0], out.ends[1], err.ends[1]);
  in.close_end(1);
  out.close_end(1);
  err.close_end(1);
  RunResult result;
  gather(child, options, {out.ends[0], err.ends[0]}, result);
  int status = 0;
  waitpid(child, &status, 0);
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

}  // namespace

int RunResult::lines_of_err() const {
  return static_cast<int>(std::count(err.begin(), err.end(), '\n'));
}

RunResult run_kinescope(const std::vector<std::string>& arguments, const RunOptions& options) {
  std::vector<std::string> command{KINESCOPE_BIN_DIR "/kinescope"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return run_command(command, options);
}

RunResult run_shell(const std::string& line, const RunOptions& options) {
  return run_command({"sh", "-c", line}, options);
}

TemporaryFolder::TemporaryFolder() {
  std::string pattern = ::testing::TempDir() + "/kinescope_XXXXXX";
  EXPECT_NE(mkdtemp(pattern.data()), nullptr);
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::vector<std::string> TemporaryFolder::files() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(path_)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void write_text(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

std::string cube_obj() {
  return "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
         "f 5 6 7 8\nf 2 1 4 3\nf 6 2 3 7\nf 1 5 8 4\nf 8 7 3 4\nf 1 2 6 5\n";
}

}  // namespace kinescope::test
