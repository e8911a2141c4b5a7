#include "demos/program.h"

#include <exception>
#include <new>
#include <variant>

#include "demos/command_line.h"
#include "demos/commands/commands.h"
#include "demos/console.h"
#include "demos/signals.h"
#include "raster/base/error.h"
#include "raster/base/simd.h"

namespace kinescope {
namespace {

int run_command(const Options& options) {
  use_simd_target(options.common.simd);
  switch (options.command) {
    case Command::kGallery:
      return run_gallery(options);
    case Command::kList:
      return run_list(options);
    case Command::kDemo:
      return run_demo(options);
    case Command::kRender:
      return run_render(options);
    case Command::kTiming:
      return run_timing(options);
  }
  return 0;
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
