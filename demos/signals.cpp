#include "demos/signals.h"

#include <unistd.h>
#include <csignal>

#include "raster/base/output_file.h"

namespace kinescope {
namespace {

void stop(int signal) {
  OutputFile::remove_unfinished();
  _exit(128 + signal);
}

}  // namespace

void install_signal_handlers() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler == SIG_IGN) continue;  // nohup, or a shell's background job
    struct sigaction action {};
    action.sa_handler = stop;
    sigaction(signal, &action, nullptr);
  }
  std::signal(SIGPIPE, SIG_IGN);
}

}  // namespace kinescope
