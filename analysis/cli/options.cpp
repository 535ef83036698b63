// SPDX-License-Identifier: MIT
#include "analysis/cli/options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "analysis/base/printable.h"
#include "analysis/cli/example_words.h"
#include "analysis/cli/process.h"
#include "simulator/base/choice.h"
#include "simulator/base/error.h"

namespace lanescope {
namespace {

constexpr const char* kOutput = "Output";

/// The text with a backslash before each of these characters.
std::string with_backslashes(const std::string& text, std::string_view characters) {
  std::string more;
  for (const char c : text)
    more += (characters.find(c) == characters.npos ? "" : "\\") + std::string(1, c);
  return more;
}

/// A word as a shell takes it; one that is not printable as bash does.
std::string quoted(const std::string& word) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./,:=+@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == word.npos) return word;
  if (!is_printable(word)) return fmt::format("$'{}'", printable(with_backslashes(word, "\\'")));
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + '\'';
}

}  // namespace

CLI::Option* CommandOptions::finished(CLI::Option* option, const std::string& group,
                                      const OptionWords& words, const std::string& default_text) {
  option->group(group)->type_name(words.form);
  if (!default_text.empty()) option->default_str(default_text);
  return option;
}

CLI::Option* CommandOptions::only_output(CLI::Option* option) {
  output_.insert(option);
  return option;
}

CLI::Option* CommandOptions::add_argument(const OptionWords& words, std::string& text) {
  return app_.add_option(words.name, text, words.help)->type_name(words.form);
}

CLI::Option* CommandOptions::add_arguments(const OptionWords& words,
                                           std::vector<std::string>& texts) {
  return app_.add_option(words.name, texts, words.help)->type_name(words.form);
}

CLI::Option* CommandOptions::add(const std::string& group, const OptionWords& words,
                                 std::string& text) {
  return finished(app_.add_option(words.name, text, words.help), group, words, text);
}

CLI::Option* CommandOptions::add_output(const OptionWords& words, std::string& text) {
  return only_output(add(kOutput, words, text));
}

CLI::Option* CommandOptions::add_output_flag(const std::string& name, const std::string& help,
                                             bool& flag) {
  return only_output(app_.add_flag(name, flag, help)->group(kOutput));
}

CLI::Option* CommandOptions::add_output_list(const OptionWords& words,
                                             std::vector<std::string>& texts) {
  CLI::Option* const option = app_.add_option(words.name, texts, words.help);
  option->type_size(1)->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  return only_output(finished(option, kOutput, words));
}

void CommandOptions::exclude_all_before(CLI::Option* option) {
  for (CLI::Option* other : app_.get_options())
    if (other != option && other != app_.get_help_ptr()) option->excludes(other);
}

void CommandOptions::add_command(std::string_view name, std::string_view summary,
                                 std::string_view examples,
                                 const std::function<Action(CommandOptions&)>& declare) {
  CLI::App* const app = app_.add_subcommand(std::string(name), std::string(summary));
  app->allow_extras();  // CLI11's own complaint has no suggestion: see refuse_mistakes().
  app->require_subcommand(0, 1);
  app->footer(fmt::format("\nExamples:\n{}", with_words(examples)));
  auto options = std::make_unique<CommandOptions>(*app);
  Action run = declare(*options);
  below_.push_back({std::move(options), std::move(run)});
}

std::vector<std::string> CommandOptions::command_names() const {
  std::vector<std::string> names;
  for (const Below& below : below_) names.push_back(below.options->app_.get_name());
  return names;
}

std::vector<std::string> CommandOptions::option_names() const {
  std::vector<std::string> names;
  for (const CLI::Option* option : app_.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

void CommandOptions::refuse_mistakes() const {
  // An option given without its value, or with an empty one, must not pass for one left out.
  const std::vector<std::string> options = option_names();
  for (const CLI::Option* option : app_.get_options())
    for (const std::string& value : option->results()) {
      if (value.empty()) throw InputError(option->get_name(), "has an empty value");
      if (std::find(options.begin(), options.end(), value) != options.end())
        throw InputError(option->get_name(), "needs a value; what follows is the option {}", value);
    }
  const std::vector<std::string> extras = app_.remaining();
  if (extras.empty()) return;
  const std::string word = extras.front().substr(0, extras.front().find('='));
  if (word.starts_with('-'))
    throw InputError(word, "is not an option of {}{}", name(), did_you_mean(word, options));
  if (below_.empty()) throw InputError(name(), "unexpected argument '{}'", word);
  const std::vector<std::string> names = command_names();
  throw InputError(word_, "'{}' is not a {}; use {}{}", word, word_, list_or(names),
                   did_you_mean(word, names));
}

std::optional<int> CommandOptions::run_command() const {
  for (const Below& below : below_) {
    if (!below.options->app_.parsed()) continue;
    below.options->refuse_mistakes();
    say_when_interrupted(below.options->name());
    return below.run();
  }
  return std::nullopt;
}

std::string CommandOptions::name() const {
  std::string name = app_.get_name();
  for (const CLI::App* app = app_.get_parent(); app && app->get_parent(); app = app->get_parent())
    name = app->get_name() + ' ' + name;
  return name;
}

bool CommandOptions::is_given(const std::string& option) const {
  return app_.get_option(option)->count() > 0;
}

std::string CommandOptions::command_line() const {
  std::string command = "lanescope " + name();
  for (const CLI::Option* option : app_.get_options()) {
    if (option->count() == 0 || output_.contains(option)) continue;
    if (!option->get_positional()) command += ' ' + option->get_name();
    for (const std::string& value : option->results()) command += ' ' + quoted(value);
  }
  return command;
}

}  // namespace lanescope
