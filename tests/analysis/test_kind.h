// SPDX-License-Identifier: MIT
// A kind of work that only tests know: lists of numbers, a kernel that adds them up, and one whose
// later work depends on earlier work.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "kernels/kernel.h"

namespace lanescope {

/// A piece of work: a list of numbers.
class Numbers final : public Work {
 public:
  std::uint64_t element_count() const override { return values.size(); }
  std::uint64_t hash() const override;

  std::vector<std::uint64_t> values;
};

/// What the kernels write: a number for each piece.
class NumberForEachPiece final : public Output {
 public:
  using Place = std::pair<std::uint64_t, std::uint64_t>;  ///< Segment and ordinal.

  /// Safe from any number of threads.
  void write(const Work& piece, std::uint64_t number);
  const std::map<Place, std::uint64_t>& numbers() const { return numbers_; }

  std::uint64_t hash() const override;
  std::vector<std::uint64_t> counters() const override;
  bool reopen(const Arguments& arguments, const Source& source) override;

  /// Of k_running_sum: what it has seen in earlier pieces.
  std::uint64_t running_sum = 0;
  std::optional<std::uint64_t> highest;

 private:
  std::mutex mutex_;
  std::map<Place, std::uint64_t> numbers_;
};

/// Scenes `scattered` and `rising`, or files that end in `.numbers`.
extern const Workload w_numbers;
/// Writes the sum of each piece. Has a parameter, `refused`: a number that it cannot take.
extern const Kernel k_sum;
/// Of Order::kSequential: writes the sum of all numbers so far, and counts those that are higher
/// than all before. Has a parameter, `start`: what the sum starts with.
extern const Kernel k_running_sum;

}  // namespace lanescope
