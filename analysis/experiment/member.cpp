// SPDX-License-Identifier: MIT
#include "analysis/experiment/member.h"

#include "analysis/experiment/experiment_groups.h"
#include "analysis/experiment/stopwatch.h"

namespace lanescope {

ObservedExecution::ObservedExecution(const Member& member)
    : every_(member.configuration->observe_every) {
  const Configuration& c = *member.configuration;
  if (!observes(c)) return;
  seen_ = std::make_unique<MemoryAndSource>();
  if (observes_apart(c)) gate_ = std::make_unique<Gate>(*seen_);
  Observer* const observer = gate_ ? static_cast<Observer*>(gate_.get()) : seen_.get();
  Output& output = member.observed_output ? *member.observed_output : *member.output;
  execution_ = member.kernel->start({c.width, Mode::kTracing, c.arguments, output, observer});
}

void ObservedExecution::take(const Work& piece) {
  if (!execution_) return;
  const bool wanted = is_observed(piece, every_);
  if (wanted) ++pieces_;
  if (gate_) gate_->is_open = wanted;
  if (wanted || gate_) execution_->run(piece);
}

MemberExecution::MemberExecution(const Member& member)
    : member_(&member),
      execution_(member.kernel->start({member.configuration->width, member.configuration->mode,
                                       member.configuration->arguments, *member.output})),
      observed_(member) {}

void MemberExecution::take(const Work& piece) {
  Stopwatch watch;
  execution_->run(piece);
  kernel_ms_ += watch.ms();
  observed_.take(piece);
  observation_ms_ += watch.ms();
}

}  // namespace lanescope
