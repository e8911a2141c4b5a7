// What the program does when it is told to stop, and when a reader goes away.
#pragma once

namespace kinescope {

/// From now on SIGINT, SIGTERM and SIGHUP remove unfinished output files and end the process with
/// 128 + the signal's number (one that was ignored stays ignored); SIGPIPE is ignored, so that a
/// closed pipe is a failed write.
void install_signal_handlers();

}  // namespace kinescope
