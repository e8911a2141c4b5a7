// What the program prints as JSON, read back. The library's templates are compiled once, for all
// tests.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

extern template class nlohmann::basic_json<>;

namespace kinescope::test {

/// Throws nlohmann::json::exception at what is not JSON in UTF-8.
nlohmann::json parse_json(const std::string& text);

}  // namespace kinescope::test
