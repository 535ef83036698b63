// SPDX-License-Identifier: MIT
// The options of a command, declared in one way: each says whether it decides what a report holds,
// or only where results go and how fast.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/cli/command.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace lanescope {

/// What the help says of an option.
struct OptionWords {
  std::string name;  ///< With its dashes: `--json`, `-o,--output`.
  std::string form;  ///< Of its value: `FILE`.
  std::string help;
};

class CommandOptions {
 public:
  /// The options that are parsed by `app`, which must outlive it.
  explicit CommandOptions(CLI::App& app) : app_(app) {}
  CommandOptions(const CommandOptions&) = delete;
  CommandOptions& operator=(const CommandOptions&) = delete;

  /// The texts must outlive the options; what they hold is shown as the default.

  /// An argument that is given without an option, and any number of them.
  CLI::Option* add_argument(const OptionWords& words, std::string& text);
  CLI::Option* add_arguments(const OptionWords& words, std::vector<std::string>& texts);
  /// An option that decides what is made.
  CLI::Option* add(const std::string& group, const OptionWords& words, std::string& text);
  /// Options that only decide where results go, how they are shown and how fast they are there. The
  /// command that a report names is without them.
  CLI::Option* add_output(const OptionWords& words, std::string& text);
  CLI::Option* add_output_flag(const std::string& name, const std::string& help, bool& flag);
  /// May be given several times.
  CLI::Option* add_output_list(const OptionWords& words, std::vector<std::string>& texts);
  /// Every option that was declared so far, and that may not be given beside `option`.
  void exclude_all_before(CLI::Option* option);

  /// Declares a command below this one.
  void add_command(std::string_view name, std::string_view summary, std::string_view examples,
                   const std::function<Action(CommandOptions&)>& declare);
  /// What the commands below are called in messages: `command`, `study`.
  void call_commands(std::string_view word) { word_ = word; }
  std::vector<std::string> command_names() const;
  /// Throws InputError for what is no option, argument or command here, and for empty values.
  void refuse_mistakes() const;
  /// Runs the command below that was given, and returns its exit status; nothing if none was given.
  std::optional<int> run_command() const;

  /// The command as it is typed, without the program: `study <name>`.
  std::string name() const;
  bool is_given(const std::string& option) const;
  /// The line that makes the same results, for reports.
  std::string command_line() const;

  CLI::App& app() { return app_; }

 private:
  struct Below {
    std::unique_ptr<CommandOptions> options;
    Action run;
  };

  CLI::Option* finished(CLI::Option* option, const std::string& group, const OptionWords& words,
                        const std::string& default_text = "");
  CLI::Option* only_output(CLI::Option* option);
  std::vector<std::string> option_names() const;

  CLI::App& app_;
  std::set<const CLI::Option*> output_;  ///< Those that decide nothing of what is made.
  std::string word_ = "command";
  std::vector<Below> below_;
};

}  // namespace lanescope
