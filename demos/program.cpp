#include "demos/program.h"

#include <exception>
#include <new>
#include <string>
#include <variant>

#include "demos/command_line.h"
#include "demos/commands/commands.h"
#include "demos/console.h"
#include "demos/signals.h"
#include "raster/base/error.h"
#include "raster/base/simd.h"

namespace kinescope {
namespace {

struct Entry {
  const char* name;  ///< as typed, with a space behind it
  int (*run)(const Options& options);
};

Entry entry_of(Command command) {
  switch (command) {
    case Command::kGallery:
      return {"", run_gallery};
    case Command::kList:
      return {"list ", run_list};
    case Command::kDemo:
      return {"demo ", run_demo};
    case Command::kRender:
      return {"render ", run_render};
    case Command::kDisplay:
      return {"display ", run_display};
    case Command::kVector:
      return {"vector ", run_vector};
    case Command::kTiming:
      return {"timing ", run_timing};
  }
  return {"", run_gallery};
}

int run_command(const Options& options) {
  const Entry entry = entry_of(options.command);
  try {
    use_simd_target(options.common.simd);
    return entry.run(options);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::kUsage) throw;
    throw Error(ErrorKind::kUsage,
                std::string(error.what()) + "; try kinescope " + entry.name + "--help");
  }
}

}  // namespace

int run_program(int argc, const char* const* argv) {
  install_signal_handlers();
  try {
    const auto parsed = parse_command_line(argc, argv);
    if (const auto* answer = std::get_if<Answer>(&parsed)) {
      print_result(answer->text);
      return 0;
    }
    return run_command(std::get<Options>(parsed));
  } catch (const Error& error) {
    print_fault(error.what());
    return error.exit_code();
  } catch (const std::bad_alloc&) {
    print_fault("there is not enough memory for this; try a smaller --size or fewer --samples");
  } catch (const std::exception& error) {
    print_fault(error.what());
  }
  return static_cast<int>(ErrorKind::kBadInput);
}

}  // namespace kinescope
