// SPDX-License-Identifier: MIT
// Outputs that are used again and again.
#pragma once

#include <memory>
#include <vector>

#include "analysis/configuration/configuration.h"

namespace lanescope {

/// Hands out empty outputs in the memory of earlier ones: the operating system takes forty times as
/// long to provide an output's memory as it takes to clear it.
class OutputPool {
 public:
  /// An empty output of the kernel of a configuration. If none of the pool can become one, the pool
  /// lets go of all: no memory lies idle while more is asked for.
  std::unique_ptr<Output> take(const Configuration& configuration, const Source& source);
  /// Lets go of all that lies idle.
  void clear() { idle_.clear(); }
  /// Takes back an output of that kernel.
  void give_back(const Kernel& kernel, std::unique_ptr<Output> output);

 private:
  struct Idle {
    OpenOutput open;  ///< Says of which type it is.
    std::unique_ptr<Output> output;
  };
  std::vector<Idle> idle_;
};

}  // namespace lanescope
