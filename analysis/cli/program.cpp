// SPDX-License-Identifier: MIT
#include "analysis/cli/program.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "analysis/base/build_info.h"
#include "analysis/cli/example_words.h"
#include "analysis/cli/options.h"
#include "simulator/base/choice.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

constexpr int kUsersMistake = 2;
constexpr int kOurMistake = 70;

void print_error(std::string_view text) {
  std::fputs(fmt::format("lanescope: {}\n", text).c_str(), stderr);
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

void describe(CLI::App& app) {
  app.set_version_flag("--version", fmt::format("lanescope {}", program_version()));
  app.footer(fmt::format("\nExamples:\n{}", with_words("  lanescope study {study} --out out\n"
                                                       "  lanescope run --help")));
  app.allow_extras();
  app.require_subcommand(0, 1);  // So that `list tables` is one command.
}

int run(int argc, char** argv) {
  CLI::App app("A software SIMD machine, vector programs that run on it, and what their lanes do",
               "lanescope");
  describe(app);
  CommandOptions options(app);
  for (const Command* command : commands())
    options.add_command(command->name, command->summary, command->examples, command->declare);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help and --version.
    print_error(explained(error));
    return kUsersMistake;
  }
  options.refuse_mistakes();
  if (const auto status = options.run_command()) return *status;
  throw InputError("command", "none given; use {}", list_or(options.command_names()));
}

}  // namespace

int run_program(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const InputError& error) {
    print_error(error.what());
    return kUsersMistake;
  } catch (const std::exception& error) {
    print_error(error.what());
    return kOurMistake;
  }
}

}  // namespace lanescope
