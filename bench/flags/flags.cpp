#include "bench/flags/flags.h"

#include <CLI/CLI.hpp>
#include <type_traits>

namespace kinescope {

struct Flags::App {
  CLI::App cli;
};

namespace {

template <typename T>
CLI::Option* add(CLI::App& app, const std::string& name, std::vector<T>* list,
                 const std::string& about) {
  return app.add_option(name, *list, about)->delimiter(',');
}

template <typename T>
CLI::Option* add(CLI::App& app, const std::string& name, T* value, const std::string& about) {
  return app.add_option(name, *value, about);
}

struct Checked {
  CLI::Option& option;

  void operator()(std::monostate) const {}
  void operator()(Flags::Within range) const { option.check(CLI::Range(range.least, range.most)); }
  void operator()(const Flags::OneOf& choice) const { option.check(CLI::IsMember(choice.values)); }
  void operator()(Flags::ExistingFile) const { option.check(CLI::ExistingFile); }
};

}  // namespace

Flags::Flags(const std::string& about) : app_(std::make_unique<App>()) {
  app_->cli.description(about);
}

Flags::~Flags() = default;

void Flags::option(const std::string& name, Value value, const std::string& about,
                   const Check& check, Need need) {
  CLI::Option* option =
      std::visit([&](auto* to) { return add(app_->cli, name, to, about); }, value);
  std::visit(Checked{*option}, check);
  if (need == Need::kRequired) option->required();
  if (need == Need::kHidden) option->group("");
}

void Flags::flag(const std::string& name, bool& value, const std::string& about) {
  app_->cli.add_flag(name, value, about);
}

void Flags::exclude(const std::string& name, const std::string& other) {
  app_->cli.get_option(name)->excludes(app_->cli.get_option(other));
}

std::optional<int> Flags::parse(int argc, char** argv) {
  try {
    app_->cli.parse(argc, argv);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    return app_->cli.exit(error);
  }
}

}  // namespace kinescope
