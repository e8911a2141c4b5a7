#include "tests/demos/parse_json.h"

template class nlohmann::basic_json<>;

namespace kinescope::test {

nlohmann::json parse_json(const std::string& text) { return nlohmann::json::parse(text); }

}  // namespace kinescope::test
