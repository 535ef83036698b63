// SPDX-License-Identifier: MIT
#include "analysis/experiment/group_run.h"

#include <algorithm>
#include <span>

#include "analysis/base/parallel.h"
#include "analysis/experiment/experiment_groups.h"
#include "analysis/experiment/run_record.h"
#include "analysis/experiment/stopwatch.h"

namespace lanescope {

GroupWorker::GroupWorker(const Workload& workload, const std::vector<const Member*>& members)
    : workload_(workload), source_counters_(workload.counters.size()) {
  for (const Member* member : members) executions_.emplace_back(*member);
}

void GroupWorker::run(const Source& source, int segment) {
  Stopwatch total;
  double elsewhere_ms = 0.0;
  const auto counted = source.produce(segment, [&](const Work& piece) {
    Stopwatch elsewhere;
    ++pieces_;
    source_hash_ += piece.hash();
    for (MemberExecution& execution : executions_) execution.take(piece);
    elsewhere_ms += elsewhere.ms();
  });
  merge_counters(workload_.counters, source_counters_, counted);
  source_ms_ += total.ms() - elsewhere_ms;
}

GroupRun::GroupRun(const std::vector<const Configuration*>& configurations, OutputPool& outputs,
                   int threads, const OpeningListener& opening)
    : workload_(workload_of(*configurations.front())),
      outputs_(outputs),
      threads_(threads),
      source_(open_source(*configurations.front(), opening)) {
  for (const Configuration* c : configurations) {
    Member& member = members_.emplace_back(Member{c, &find_kernel(c->kernel), nullptr, nullptr});
    member.output = outputs.take(*c, *source_);
    if (observes_apart(*c)) member.observed_output = outputs.take(*c, *source_);
  }
}

GroupRun::~GroupRun() {
  for (Member& member : members_)
    for (auto* output : {&member.output, &member.observed_output})
      if (*output) outputs_.give_back(*member.kernel, std::move(*output));
}

void GroupRun::start_workers(std::size_t segments) {
  std::vector<const Member*> any_order;
  std::vector<const Member*> sequential;
  for (const Member& member : members_)
    (member.kernel->order == Order::kSequential ? sequential : any_order).push_back(&member);
  const auto shares = static_cast<std::size_t>(sequential_workers(sequential.size(), threads_));
  for (std::size_t share = 0; share < shares; ++share) {
    std::vector<const Member*> members;
    for (std::size_t i = share; i < sequential.size(); i += shares)
      members.push_back(sequential[i]);
    sequential_.emplace_back(workload_, members);
  }
  if (any_order.empty()) return;
  const std::size_t busy = std::min(static_cast<std::size_t>(threads_), shares + segments);
  for (std::size_t thread = 0; thread < std::max<std::size_t>(1, busy); ++thread)
    any_order_.emplace_back(workload_, any_order);
}

void GroupRun::run(const std::vector<int>& segments, const std::function<void(double)>& progress) {
  start_workers(segments.size());
  const std::size_t passes = sequential_.size() + (any_order_.empty() ? 0 : 1);
  std::atomic<std::size_t> done{0};
  const auto run_segment = [&](GroupWorker& of, int segment, int thread) {
    of.run(*source_, segment);
    const std::size_t now = ++done;
    if (thread == 0 && progress)
      progress(static_cast<double>(now) / static_cast<double>(passes * segments.size()));
  };
  // Those that take longest first: all pieces of a sequential worker, then segments.
  const std::size_t items = sequential_.size() + (any_order_.empty() ? 0 : segments.size());
  parallel_for(threads_, static_cast<int>(items), [&](int thread, int item) {
    const auto i = static_cast<std::size_t>(item);
    if (i < sequential_.size())
      for (const int segment : segments) run_segment(sequential_[i], segment, thread);
    else
      run_segment(any_order_[static_cast<std::size_t>(thread)], segments[i - sequential_.size()],
                  thread);
  });
}

template <class Use>
void GroupRun::for_executions(std::size_t member, const Use& use) const {
  for (const auto* workers : {&any_order_, &sequential_})
    for (const GroupWorker& worker : *workers)
      for (const MemberExecution& execution : worker.executions())
        if (&execution.member() == &members_[member]) use(execution);
}

SourceRecord GroupRun::source_record() const {
  // Each sequential worker has seen all pieces, those of any order have them together.
  const auto workers = any_order_.empty() ? std::span(sequential_).first(1) : std::span(any_order_);
  SourceRecord record;
  std::vector<std::uint64_t> counters(workload_.counters.size());
  for (const GroupWorker& worker : workers) {
    record.hash += worker.source_hash();
    record.pieces += worker.pieces();
    merge_counters(workload_.counters, counters, worker.source_counters());
  }
  record.counters = counter_records(workload_.counters, counters);
  return record;
}

RunRecord GroupRun::record(std::size_t i, Dictionary& dictionary) const {
  const Member& member = members_[i];
  std::vector<KernelResult> results;
  MemoryAndSource seen;
  SourceRecord source = source_record();
  for_executions(i, [&](const MemberExecution& execution) {
    results.push_back(execution.result());
    source.pieces_observed += execution.observed().pieces();
    if (execution.observed().seen()) seen += *execution.observed().seen();
  });
  KernelResult& sum = results.front();
  for (std::size_t r = 1; r < results.size(); ++r) merge(*member.kernel, sum, results[r]);
  for (const StageCounts& stage : sum.counts.stages)
    for (const InstructionCounts& c : stage.instructions)
      dictionary.emplace(c.info->mnemonic, c.info);
  RunRecord run = run_record(*member.configuration, *member.kernel, sum, seen);
  run.source = std::move(source);
  return run;
}

double GroupRun::kernel_ms(std::size_t member) const {
  double sum = 0.0;
  for_executions(member, [&](const MemberExecution& e) { sum += e.kernel_ms(); });
  return sum;
}

double GroupRun::source_ms() const {
  double sum = 0.0;
  for (const auto* workers : {&any_order_, &sequential_})
    for (const GroupWorker& worker : *workers) sum += worker.source_ms();
  return sum;
}

double GroupRun::observation_ms() const {
  double sum = 0.0;
  for (std::size_t i = 0; i < members_.size(); ++i)
    for_executions(i, [&](const MemberExecution& e) { sum += e.observation_ms(); });
  return sum;
}

}  // namespace lanescope
