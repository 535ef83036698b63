// SPDX-License-Identifier: MIT
// The contract of a command of the program: a name, a sentence, examples, and its options.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace lanescope {

/// The descriptor; analysis/cli/<name>.cpp ends in one, and the registry lists them.
struct Command {
  std::string_view name;
  std::string_view summary;
  std::string_view examples;  ///< Lines for the end of --help.
  /// Declares the command's options on `app` and returns what runs it once they are parsed. That
  /// throws InputError for the user's mistakes.
  std::function<void()> (*declare)(CLI::App& app);
};

/// Every command, in the order of analysis/cli/CMakeLists.txt.
const std::vector<const Command*>& commands();

}  // namespace lanescope
