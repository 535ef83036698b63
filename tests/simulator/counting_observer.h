// SPDX-License-Identifier: MIT
// Counts what a tracing machine tells.
#pragma once

#include "simulator/observer.h"
#include "simulator/tally.h"

namespace lanescope::test {

class CountingObserver final : public Observer {
 public:
  CountingObserver(int width, std::size_t stage_count) : tally_(width, stage_count) {}
  void issued(const IssueEvent& event) override {
    tally_.charge(event.stage, {&event.info, event.overhead}, event.active);
  }
  Counts counts() const { return tally_.counts(); }

 private:
  Tally tally_;
};

}  // namespace lanescope::test
