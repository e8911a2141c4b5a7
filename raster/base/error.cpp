#include "raster/base/error.h"

namespace kinescope {
namespace {

std::string join(const std::string& what, const std::string& file, const std::string& where) {
  std::string line;
  for (const std::string* part : {&file, &where}) {
    if (!part->empty()) line += *part + ": ";
  }
  line += what;
  // Names and texts out of files may hold anything; what reaches a terminal is one plain line.
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return line;
}

}  // namespace

Error::Error(ErrorKind kind, const std::string& what, const std::string& file,
             const std::string& where)
    : std::runtime_error(join(what, file, where)), kind_(kind) {}

void throw_bad_input(const std::string& what, const std::string& file, const std::string& where) {
  throw Error(ErrorKind::kBadInput, what, file, where);
}

}  // namespace kinescope
