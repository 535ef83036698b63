// SPDX-License-Identifier: MIT
// What a command says on standard error while it works, beside its results.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/cli/progress.h"
#include "analysis/configuration/configuration.h"

namespace lanescope {

/// Shows progress, also while scenes are opened, and at the end of its life what the user should
/// know of them, each sentence once. Everything happens on the thread that calls it.
class Narration {
 public:
  explicit Narration(std::string title) : progress_(std::move(title)) {}
  Narration(const Narration&) = delete;
  Narration& operator=(const Narration&) = delete;

  /// As Progress::update.
  void update(double fraction, std::string_view detail = {});
  double elapsed_s() const { return progress_.elapsed_s(); }

  /// To be told of the scenes that are opened. The narration must outlive it.
  OpeningListener listener();

 private:
  /// Sentences that are printed at the end, in their order.
  class Notes {
   public:
    Notes() = default;
    Notes(const Notes&) = delete;
    Notes& operator=(const Notes&) = delete;
    ~Notes();
    void add(const std::string& note);

   private:
    std::vector<std::string> all_;
  };

  Notes notes_;  // Printed once the line of the progress has been cleared.
  Progress progress_;
  double fraction_ = 0.0;
};

}  // namespace lanescope
