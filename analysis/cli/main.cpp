// SPDX-License-Identifier: MIT
// The program: finds the command, and turns what goes wrong into one line and an exit status.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "analysis/base/build_info.h"
#include "analysis/cli/command.h"
#include "analysis/cli/output.h"
#include "analysis/cli/values.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

constexpr int kUsersMistake = 2;
constexpr int kOurMistake = 70;

void print_error(std::string_view text) {
  std::fputs(fmt::format("lanescope: {}\n", text).c_str(), stderr);
}

/// Options that may be given to `app`, as they are typed.
std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

/// Complains of the first argument that nothing took. CLI11 is told to collect them, because its
/// own complaint has no suggestion.
void refuse_extras(const CLI::App& app) {
  const std::vector<std::string> extras = app.remaining();
  if (extras.empty()) return;
  const std::string word = extras.front().substr(0, extras.front().find('='));
  if (word.rfind('-', 0) == 0)
    throw InputError(word, "is not an option of {}{}", app.get_name(),
                     did_you_mean(word, option_names(app)));
  throw InputError(app.get_name(), "unexpected argument '{}'", word);
}

void refuse_unknown_command(const CLI::App& app) {
  const std::vector<std::string> extras = app.remaining();
  const std::vector<std::string> names = names_of(commands());
  if (extras.empty()) throw InputError("command", "none given; use {}", list_or(names));
  if (extras.front().rfind('-', 0) == 0) refuse_extras(app);
  throw InputError("command", "'{}' is not a command; use {}{}", extras.front(), list_or(names),
                   did_you_mean(extras.front(), names));
}

/// An option given without its value, or with an empty one, must not pass for one left out.
void refuse_empty_values(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options())
    for (const std::string& value : option->results())
      if (value.empty()) throw InputError(option->get_name(), "has an empty value");
}

Action declare(CLI::App& app, const Command& command) {
  CLI::App* sub = app.add_subcommand(std::string(command.name), std::string(command.summary));
  sub->footer(fmt::format("\nExamples:\n{}", command.examples));
  sub->allow_extras();
  Action action = command.declare(*sub);
  return [sub, action] {
    refuse_extras(*sub);
    refuse_empty_values(*sub);
    return action();
  };
}

/// What CLI11 complains of, in our words where its own are unclear.
std::string explained(const CLI::ParseError& error) {
  const std::string text = error.what();
  const std::string option = text.substr(0, text.find(':'));
  if (error.get_name() == "ArgumentMismatch")
    return option + (text.find("missing") != text.npos ? ": needs a value" : ": is given twice");
  if (error.get_name() == "ConversionError" && text.rfind("Could not convert: ", 0) == 0) {
    const std::string rest = text.substr(text.find(": ") + 2);
    return rest.substr(0, rest.find(' ')) + ": takes no value";
  }
  return text.substr(0, text.find('\n'));
}

int run(int argc, char** argv) {
  CLI::App app("A software SIMD machine and the micropolygon rasterizers that run on it",
               "lanescope");
  app.set_version_flag("--version", fmt::format("lanescope {}", program_version()));
  app.footer("\nExamples:\n  lanescope tables --out out\n  lanescope run --help");
  app.allow_extras();
  app.require_subcommand(0, 1);  // So that `list tables` is one command.
  std::vector<std::pair<const CLI::App*, Action>> actions;
  for (const Command* command : commands()) {
    Action action = declare(app, *command);
    actions.emplace_back(app.get_subcommand(std::string(command->name)), std::move(action));
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help and --version.
    print_error(explained(error));
    return kUsersMistake;
  }
  for (const auto& [command, action] : actions)
    if (command->parsed()) return action();
  refuse_unknown_command(app);
  return 0;
}

}  // namespace
}  // namespace lanescope

int main(int argc, char** argv) {
  try {
    return lanescope::run(argc, argv);
  } catch (const lanescope::InputError& error) {
    lanescope::print_error(error.what());
    return lanescope::kUsersMistake;
  } catch (const std::exception& error) {
    lanescope::print_error(error.what());
    return lanescope::kOurMistake;
  }
}
