#include "engine/io/reader.h"
#include "tests/fuzz/model_fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return kinescope::fuzz_model(data, size, kinescope::ModelFormat::kGltf);
}
