// The one exception of the project: what went wrong, in which file, where in it.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace kinescope {

/// What kind of fault an Error reports; the value is the program's exit code.
enum class ErrorKind { kUsage = 2, kBadInput = 3, kCannotWrite = 4 };

/// Bad data or a failed write. Caught once, at the program's top, which prints what() as one line.
/// Misuse by a programmer asserts instead.
class Error : public std::runtime_error {
 public:
  /// @param what   the fault and what to do, in one line without a full stop
  /// @param file   the file's name as the user gave it; empty if there is none
  /// @param where  the place in it ("line 12", "byte 4096", "accessor 3"); empty if unknown
  Error(ErrorKind kind, const std::string& what, const std::string& file = {},
        const std::string& where = {});

  ErrorKind kind() const { return kind_; }
  int exit_code() const { return static_cast<int>(kind_); }

 private:
  ErrorKind kind_;
};

/// A reader's shorthand for Error{kBadInput, ...}.
[[noreturn]] void throw_bad_input(const std::string& what, const std::string& file = {},
                                  const std::string& where = {});

/// What a reader could work around: each entry one line for the user, in order.
using Warnings = std::vector<std::string>;

}  // namespace kinescope
