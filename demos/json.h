// Writes one JSON value, indented; strings must be UTF-8 (other bytes are replaced).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace kinescope {

/// Calls nest: an object's members come as key() then a value or begin_...(); arrays as values.
class JsonWriter {
 public:
  JsonWriter& begin_object();
  JsonWriter& end_object();
  JsonWriter& begin_array();
  JsonWriter& end_array();
  JsonWriter& key(std::string_view name);
  JsonWriter& value(std::string_view text);
  JsonWriter& value(const char* text) { return value(std::string_view(text)); }
  JsonWriter& value(bool truth);
  JsonWriter& value(int number) { return value(static_cast<std::int64_t>(number)); }
  JsonWriter& value(std::int64_t number);
  JsonWriter& value(std::uint64_t number);
  /// The shortest text that reads back the same; null if not finite.
  JsonWriter& value(double number);
  /// 16 hexadecimal digits as a string: readers that hold numbers as doubles keep all 64 bits.
  JsonWriter& hash(std::uint64_t bits);
  JsonWriter& hash_member(std::string_view name, std::uint64_t bits) {
    return key(name).hash(bits);
  }
  template <typename Value>
  JsonWriter& member(std::string_view name, const Value& v) {
    return key(name).value(v);
  }

  /// The finished text, with a newline.
  std::string text() const { return text_ + "\n"; }

 private:
  void open(char bracket);
  void close(char bracket);
  void before_item();
  std::string text_;
  std::vector<bool> has_items_;  // one a level
  bool after_key_ = false;
};

}  // namespace kinescope
