// SPDX-License-Identifier: MIT
// One configuration of a group, and its executions while the group runs.
#pragma once

#include <cstdint>
#include <memory>

#include "analysis/configuration/configuration.h"
#include "analysis/experiment/observation.h"

namespace lanescope {

/// One configuration while its group runs.
struct Member {
  const Configuration* configuration;
  const Kernel* kernel;
  std::unique_ptr<Output> output;
  /// Of the observed execution; null if that writes into `output` or there is none.
  std::unique_ptr<Output> observed_output;
};

/// What the pieces that are observed show. The kernel takes them once more on a tracing machine:
/// just these and into the same output, which changes nothing, if it is of Order::kAny; else all of
/// them, into an output of their own, and the others are not looked at.
class ObservedExecution {
 public:
  explicit ObservedExecution(const Member& member);

  void take(const Work& piece);

  /// Pieces that were observed.
  std::uint64_t pieces() const { return pieces_; }
  /// Null if nothing is observed.
  const MemoryAndSource* seen() const { return seen_.get(); }

 private:
  /// Passes on what a machine tells while it is open.
  class Gate final : public Observer {
   public:
    explicit Gate(Observer& next) : next_(next) {}
    void issued(const IssueEvent& event) override {
      if (is_open) next_.issued(event);
    }
    bool is_open = false;

   private:
    Observer& next_;
  };

  int every_;
  std::unique_ptr<MemoryAndSource> seen_;
  std::unique_ptr<Gate> gate_;  ///< Of Order::kSequential.
  std::unique_ptr<Execution> execution_;
  std::uint64_t pieces_ = 0;
};

/// An execution of a member, observed in some pieces, with its times.
class MemberExecution {
 public:
  explicit MemberExecution(const Member& member);

  void take(const Work& piece);

  const Member& member() const { return *member_; }
  KernelResult result() const { return execution_->result(); }
  const ObservedExecution& observed() const { return observed_; }
  double kernel_ms() const { return kernel_ms_; }
  double observation_ms() const { return observation_ms_; }

 private:
  const Member* member_;
  std::unique_ptr<Execution> execution_;
  ObservedExecution observed_;
  double kernel_ms_ = 0.0;
  double observation_ms_ = 0.0;
};

}  // namespace lanescope
