// SPDX-License-Identifier: MIT
// Kernels that are LOCKSTEP with one mistake each, which `lanescope check` is to find.
#include "kernels/kernel.h"
#include "kernels/micropolygons/counters.h"
#include "kernels/micropolygons/frame.h"
#include "kernels/micropolygons/frame_merge.h"
#include "kernels/micropolygons/lockstep.h"
#include "kernels/micropolygons/options.h"
#include "kernels/widths.h"
#include "simulator/base/error.h"
#include "workloads/micropolygons/workload.h"

namespace lanescope {
namespace {

/// LOCKSTEP, and what a derived class does beside it.
class Wrong : public Execution {
 public:
  explicit Wrong(const Launch& launch)
      : launch_(launch), right_(find_kernel("lockstep").start(launch)) {}
  void run(const Work& work) override {
    right_->run(work);
    ++pieces_;
  }
  KernelResult result() const override { return right_->result(); }

 protected:
  Launch launch_;
  int pieces_ = 0;

 private:
  std::unique_ptr<Execution> right_;
};

/// Counts a micropolygon too many from its second piece on.
class CountsTooMany final : public Wrong {
 public:
  using Wrong::Wrong;
  KernelResult result() const override {
    KernelResult result = Wrong::result();
    result.counters.front() += pieces_ > 1;
    return result;
  }
};

/// Has other hits at W = 8.
class HitsOthers final : public Wrong {
 public:
  using Wrong::Wrong;
  KernelResult result() const override {
    KernelResult result = Wrong::result();
    result.results_hash ^= launch_.width == 8;
    return result;
  }
};

/// Draws a sample that it does not hit.
class DrawsMore final : public Wrong {
 public:
  using Wrong::Wrong;
  void run(const Work& work) override {
    Wrong::run(work);
    static_cast<Frame&>(launch_.output).merge(0, 0.0f, 1);
  }
};

/// Breaks a rule of checked mode.
class BreaksARule final : public Wrong {
 public:
  using Wrong::Wrong;
  void run(const Work& work) override {
    LANESCOPE_CHECK(launch_.mode != Mode::kChecked, "a rule");
    Wrong::run(work);
  }
};

template <class Kind>
Kernel wrong(std::string_view name) {
  return {
      .name = name,
      .summary = "wrong, for tests",
      .workload = &w_micropolygons,
      .parameters = joined(raster_parameters(), sampling_parameters()),
      .stages = kLockstepStages,
      .counters = std::span<const CounterInfo>(kRasterizerCounters).first(kConflictHits + 1),
      .output_counters = kFrameCounters,
      .element = kMicropolygon,
      .instructions = kRasterizerInstructions,
      .most_width = kMostLanes,
      .open = open_frame,
      .output_bytes = frame_bytes,
      .start = [](const Launch& launch) -> std::unique_ptr<Execution> {
        return std::make_unique<Kind>(launch);
      },
  };
}

}  // namespace

extern const Kernel k_counts_too_many, k_hits_others, k_draws_more, k_breaks_a_rule;
const Kernel k_counts_too_many = wrong<CountsTooMany>("counts_too_many");
const Kernel k_hits_others = wrong<HitsOthers>("hits_others");
const Kernel k_draws_more = wrong<DrawsMore>("draws_more");
const Kernel k_breaks_a_rule = wrong<BreaksARule>("breaks_a_rule");

}  // namespace lanescope
