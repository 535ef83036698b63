// SPDX-License-Identifier: MIT
// The contract of a command of the program: a name, a sentence, examples, and its options.
#pragma once

#include <functional>
#include <string_view>
#include <type_traits>
#include <vector>

namespace lanescope {

class CommandOptions;

/// What runs a command once its options are parsed, and returns the exit status. It is made from a
/// callable that returns the status, or from one that returns nothing: then the status is 0.
class Action {
 public:
  template <class Run>
  Action(Run run)
      : run_([run]() -> int {
          if constexpr (std::is_void_v<decltype(run())>) {
            run();
            return 0;
          } else {
            return run();
          }
        }) {}
  int operator()() const { return run_(); }

 private:
  std::function<int()> run_;
};

/// The descriptor; analysis/cli/<name>.cpp ends in one, and the registry lists them.
struct Command {
  std::string_view name;
  std::string_view summary;
  /// Lines for the end of --help. Words in braces stand for what the program has: see with_words().
  std::string_view examples;
  /// Declares the command's options and returns what runs it. That throws InputError for the user's
  /// mistakes. `options` outlives the action.
  Action (*declare)(CommandOptions& options);
};

/// Every command, in the order of analysis/cli/CMakeLists.txt.
const std::vector<const Command*>& commands();

}  // namespace lanescope
