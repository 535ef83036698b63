// SPDX-License-Identifier: MIT
// The scalar reference with someone who watches its tests and hits. They are those of every kernel.
#pragma once

#include <cstdint>
#include <memory>

#include "kernels/kernel.h"

namespace lanescope {

/// Watches the reference at work. Called on the thread of the execution; one that watches several
/// executions must be safe for their threads.
class SampleObserver {
 public:
  virtual ~SampleObserver() = default;
  /// A sample is tested: counter `tests`.
  virtual void tested(std::uint32_t /*sample*/) {}
  /// The test found it covered: counter `hits`. `colour` is 0xAABBGGRR, as in the frame.
  virtual void hit(std::uint64_t /*micropolygon_id*/, std::uint32_t /*sample*/, float /*depth*/,
                   std::uint32_t /*colour*/) {}
};

/// Starts the reference without a frame; the observer must outlive the execution.
std::unique_ptr<Execution> start_observed_rastmp(const Arguments& arguments,
                                                 SampleObserver& observer);

}  // namespace lanescope
