#include "demos/json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/demos/parse_json.h"

namespace kinescope {
namespace {

using test::parse_json;

TEST(Json, NestedValuesReadBack) {
  JsonWriter w;
  w.begin_object().member("a", 1).member("b", true).key("c").begin_array();
  w.value("x").value(2.5).begin_object().end_object().begin_array().end_array().end_array();
  w.hash_member("h", 0xABCDu).end_object();
  const auto expected =
      parse_json(R"({"a":1,"b":true,"c":["x",2.5,{},[]],"h":"000000000000abcd"})");
  EXPECT_EQ(parse_json(w.text()), expected);
}

TEST(Json, NumbersReadBackTheSame) {
  for (const double number : {0.1, 1e300, -1.0 / 3, 5e-324, 1e15}) {
    JsonWriter w;
    EXPECT_EQ(parse_json(w.value(number).text()).get<double>(), number);
  }
  JsonWriter w;
  const std::uint64_t big = std::numeric_limits<std::uint64_t>::max();
  EXPECT_EQ(parse_json(w.value(big).text()).get<std::uint64_t>(), big);
}

TEST(Json, WhatIsNoNumberIsNull) {
  for (const double number : {std::nan(""), static_cast<double>(INFINITY)}) {
    JsonWriter w;
    EXPECT_EQ(w.value(number).text(), "null\n");
  }
}

TEST(Json, AnyBytesBecomeValidText) {
  std::string bytes;
  for (int i = 1; i < 256; ++i) bytes += static_cast<char>(i);
  bytes += "\xE2\x82\xAC \xF0\x9F\x98\x80 \xED\xA0\x80 \xC0\xAF \xE2\x82";
  JsonWriter w;
  const std::string text = w.value(bytes).text();
  const auto read = parse_json(text);  // throws on invalid UTF-8
  EXPECT_NE(read.get<std::string>().find("\xE2\x82\xAC \xF0\x9F\x98\x80"), std::string::npos);
  EXPECT_EQ(read.get<std::string>().substr(0, 127), bytes.substr(0, 127));
}

}  // namespace
}  // namespace kinescope
