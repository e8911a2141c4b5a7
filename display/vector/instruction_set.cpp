#include "display/vector/instruction_set.h"

#include "display/vector/dvg_words.h"
#include "display/vector/generic_words.h"
#include "raster/base/error.h"

namespace kinescope {

bool has_instruction_set(std::string_view name) { return name == "generic" || name == "dvg"; }
std::string instruction_set_names() { return "generic, dvg"; }

const InstructionSet& instruction_set(std::string_view name) {
  static const GenericWords generic;
  static const DvgWords dvg;
  if (name == "generic") return generic;
  if (name == "dvg") return dvg;
  throw Error(ErrorKind::kUsage, "no instruction set \"" + std::string(name) + "\"; there are " +
                                     instruction_set_names());
}

}  // namespace kinescope
