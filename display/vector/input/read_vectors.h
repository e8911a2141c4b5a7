// Any random-scan input, told apart by its content.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "display/vector/input/drawing.h"
#include "raster/base/error.h"
#include "raster/base/input_file.h"

namespace kinescope {

enum class VectorKind { kTek, kHpgl, kSvg, kWav };

/// Their names, in the order of the enumeration.
std::span<const std::string_view> vector_kind_names();

/// What the first bytes of an input show; none if they show nothing known.
std::optional<VectorKind> recognise_vectors(std::span<const std::uint8_t> first_bytes);

/// How many bytes it wants to see.
inline constexpr std::size_t kRecogniseBytes = 4096;

/// All of an input. @param kind none: by its content
/// @param warnings if given, receives what could be worked around
/// @throws Error (bad input)
VectorDrawing read_vectors(InputFile& input, std::optional<VectorKind> kind,
                           Warnings* warnings = nullptr);

}  // namespace kinescope
