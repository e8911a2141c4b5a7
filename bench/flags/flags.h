// The options of a measuring program: CLI11's, behind a header that costs its users nothing to
// read.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace kinescope {

class Flags {
 public:
  /// Where an option's value goes; lists take commas, or several values.
  using Value = std::variant<int*, unsigned*, std::uint64_t*, float*, double*, std::string*,
                             std::vector<int>*, std::vector<std::string>*>;
  /// Numbers from `least` to `most`, both included.
  struct Within {
    double least, most;
  };
  struct OneOf {
    std::vector<std::string> values;
  };
  struct ExistingFile {};
  using Check = std::variant<std::monostate, Within, OneOf, ExistingFile>;
  enum class Need { kOptional, kRequired, kHidden };

  /// `about`: the help's first line.
  explicit Flags(const std::string& about);
  ~Flags();

  /// `name` as it is typed ("--pairs"); `about` is its line of the help.
  void option(const std::string& name, Value value, const std::string& about,
              const Check& check = {}, Need need = Need::kOptional);
  void flag(const std::string& name, bool& value, const std::string& about);
  /// One of the two may be given, not both.
  void exclude(const std::string& name, const std::string& other);

  /// Fills the values. The exit code, after it printed help or what is wrong; nothing: go on.
  std::optional<int> parse(int argc, char** argv);

 private:
  struct App;
  std::unique_ptr<App> app_;
};

}  // namespace kinescope
