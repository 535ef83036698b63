// SPDX-License-Identifier: MIT
// The ratios that a run's counts give, as fractions that keep numerator and denominator.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string_view>

#include "analysis/report/report.h"

namespace lanescope {

/// A fraction of two counts. It has no value where the denominator is 0.
struct Ratio {
  std::uint64_t numerator = 0;
  std::uint64_t denominator = 0;
  std::optional<double> value() const;
};

/// Busy lanes of the lane slots of a stage: active / (issued x W).
Ratio utilization(const StageRecord& stage, int width);

/// Which stages a sum goes over: all, or all but one.
class Stages {
 public:
  Stages() = default;
  static Stages all_but(std::string_view stage) {
    Stages stages;
    stages.left_out_ = stage;
    return stages;
  }
  bool has(std::string_view stage) const { return stage != left_out_; }

 private:
  std::string_view left_out_;
};

/// Sum over stages of a run; without a mnemonic.
InstructionRecord total(const RunRecord& run, Stages stages = {});

/// Busy lanes of the lane slots of all those stages together.
Ratio utilization(const RunRecord& run, Stages stages = {});

/// Utilization of several stages together; stages that the run does not have add nothing.
Ratio utilization(const RunRecord& run, std::initializer_list<std::string_view> stages);

/// Instructions issued for each of the run's elements. No value if the kernel does not count them.
std::optional<double> instructions_per_element(const RunRecord& run, Stages stages = {});
std::optional<double> instructions_per_element(const RunRecord& run, std::string_view stage);

/// A quotient of two counters; no value if either is missing or the denominator is 0.
std::optional<double> counter_ratio(const RunRecord& run, std::string_view numerator,
                                    std::string_view denominator);

}  // namespace lanescope
