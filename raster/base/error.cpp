#include "raster/base/error.h"

namespace kinescope {
namespace {

std::string join(const std::string& what, const std::string& file, const std::string& where) {
  std::string line;
  for (const std::string* part : {&file, &where}) {
    if (!part->empty()) line += *part + ": ";
  }
  return line + what;
}

}  // namespace

Error::Error(ErrorKind kind, const std::string& what, const std::string& file,
             const std::string& where)
    : std::runtime_error(join(what, file, where)), kind_(kind) {}

void throw_bad_input(const std::string& what, const std::string& file, const std::string& where) {
  throw Error(ErrorKind::kBadInput, what, file, where);
}

}  // namespace kinescope
