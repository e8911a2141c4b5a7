#include "virtual_display.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <thread>

#include "program_run.h"
#include "raster/image/codecs.h"

namespace kinescope::test {
namespace {

std::vector<char*> pointers(const std::vector<std::string>& words) {
  std::vector<char*> list;
  for (const std::string& word : words) list.push_back(const_cast<char*>(word.c_str()));
  list.push_back(nullptr);
  return list;
}

bool installed(const char* tool) {
  return std::system((std::string("command -v ") + tool + " > /dev/null 2>&1").c_str()) == 0;
}

}  // namespace

Child::Child(const std::vector<std::string>& command, const std::vector<std::string>& environment,
             const std::string& folder, int inherited_fd) {
  std::vector<char*> arguments = pointers(command);
  pid_ = fork();
  if (pid_ != 0) return;
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // a test that crashes leaves no server behind
  for (const std::string& entry : environment) putenv(strdup(entry.c_str()));
  if (!folder.empty() && chdir(folder.c_str()) != 0) _exit(126);
  const int null = open("/dev/null", O_RDWR);
  for (const int fd : {0, 1, 2}) {
    if (fd != inherited_fd) dup2(null, fd);
  }
  if (!folder.empty()) dup2(open("said.txt", O_WRONLY | O_CREAT | O_TRUNC, 0600), 2);
  execvp(arguments[0], arguments.data());
  _exit(127);
}

std::optional<int> Child::wait(double seconds) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  while (!exit_code_) {
    int status = 0;
    if (waitpid(pid_, &status, WNOHANG) == pid_) {
      exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    } else if (Clock::now() > end) {
      return std::nullopt;
    } else {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }
  return exit_code_;
}

Child::~Child() {
  if (exit_code_ || pid_ <= 0) return;
  kill(pid_, SIGTERM);
  if (wait(5)) return;
  kill(pid_, SIGKILL);
  wait(5);
}

bool VirtualDisplay::available() {
  return installed("Xvfb") && installed("xdotool") && installed("import");
}

VirtualDisplay::VirtualDisplay(int width, int height) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return;
  fcntl(ends[0], F_SETFD, FD_CLOEXEC);
  const std::string screen = std::to_string(width) + "x" + std::to_string(height) + "x24";
  // Without -noreset it would throw everybody out whenever one tool leaves as the last client.
  server_.emplace(std::vector<std::string>{"Xvfb", "-displayfd", std::to_string(ends[1]), "-screen",
                                           "0", screen, "-nolisten", "tcp", "-noreset"},
                  std::vector<std::string>{}, "", ends[1]);
  close(ends[1]);
  pollfd ready{ends[0], POLLIN, 0};
  // The server writes its number once it takes clients, and the line's end after it: it dies if
  // nobody reads that.
  std::string line;
  char c = 0;
  while (poll(&ready, 1, 30'000) > 0 && read(ends[0], &c, 1) == 1 && c != '\n') line += c;
  if (!line.empty()) name_ = ":" + line;
  close(ends[0]);
}

std::string VirtualDisplay::tool(const std::string& command) const {
  const std::string line = "DISPLAY=" + name_ + " timeout 20 " + command + " 2>/dev/null";
  const std::unique_ptr<FILE, int (*)(FILE*)> stream(popen(line.c_str(), "r"), pclose);
  std::string out;
  std::array<char, 256> part{};
  while (stream && std::fgets(part.data(), part.size(), stream.get()) != nullptr)
    out += part.data();
  return out;
}

Image<Srgb8> VirtualDisplay::screenshot() const {
  const TemporaryFolder folder;
  const std::string path = folder / "screen.png";
  tool("import -window root png32:" + path);
  return std::filesystem::exists(path) ? read_image_file(path) : Image<Srgb8>();
}

}  // namespace kinescope::test
