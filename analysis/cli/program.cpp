// SPDX-License-Identifier: MIT
#include "analysis/cli/program.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <new>
#include <sstream>

#include "analysis/base/build_info.h"
#include "analysis/base/memory.h"
#include "analysis/cli/example_words.h"
#include "analysis/cli/options.h"
#include "analysis/cli/output.h"
#include "analysis/cli/process.h"
#include "kernels/instructions.h"
#include "simulator/base/choice.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

constexpr int kUsersMistake = 2;
constexpr int kOurMistake = 70;

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

/// --help and --version.
int print_asked_for(const CLI::App& app, const CLI::ParseError& what) {
  std::ostringstream output;
  const int status = app.exit(what, output, output);
  print(output.str());
  return status;
}

/// The words of the command line, the last first, as CLI11 takes them. It would give `--option=`
/// the word that follows as its value: that option gets an empty one.
std::vector<std::string> words_of(int argc, char** argv) {
  std::vector<std::string> words;
  for (int i = 1; i < argc; ++i) {
    std::string word = argv[i];
    const bool is_empty_value = word.starts_with("--") && word.find('=') + 1 == word.size();
    if (is_empty_value) word.pop_back();
    words.push_back(std::move(word));
    if (is_empty_value) words.emplace_back();
  }
  std::reverse(words.begin(), words.end());
  return words;
}

int run(int argc, char** argv) {
  all_instructions();  // Refuses a program whose reports would be ambiguous.
  CLI::App app("A software SIMD machine, vector programs that run on it, and what their lanes do",
               "lanescope");
  describe(app);
  CommandOptions options(app);
  for (const Command* command : commands())
    options.add_command(command->name, command->summary, command->examples, command->declare);
  try {
    app.parse(words_of(argc, argv));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return print_asked_for(app, error);
    tell(explained(error));
    return kUsersMistake;
  }
  options.refuse_mistakes();
  if (const auto status = options.run_command()) return *status;
  throw InputError("command", "none given; use {}", list_or(options.command_names()));
}

}  // namespace

int run_program(int argc, char** argv) {
  set_up_process();
  try {
    return run(argc, argv);
  } catch (const ClosedPipe& error) {
    end_by_closed_pipe();
    tell(error.what());
    return kUsersMistake;
  } catch (const InputError& error) {
    tell(error.what());
    return kUsersMistake;
  } catch (const std::bad_alloc&) {
    tell(kOutOfMemory);
    return kUsersMistake;
  } catch (const std::exception& error) {
    tell(error.what());
    return kOurMistake;
  }
}

}  // namespace lanescope
