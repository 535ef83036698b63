// SPDX-License-Identifier: MIT
// Runs the configurations that one source feeds, piece by piece, on several threads.
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <string_view>
#include <vector>

#include "analysis/experiment/member.h"
#include "analysis/experiment/output_pool.h"
#include "analysis/report/report.h"

namespace lanescope {

/// Instructions by mnemonic.
using Dictionary = std::map<std::string_view, const InstructionInfo*>;

/// What one thread has of a group: executions of some members, which take the same pieces.
class GroupWorker {
 public:
  GroupWorker(const Workload& workload, const std::vector<const Member*>& members);

  void run(const Source& source, int segment);

  const std::vector<MemberExecution>& executions() const { return executions_; }
  std::uint64_t source_hash() const { return source_hash_; }
  std::uint64_t pieces() const { return pieces_; }
  /// In the order of Workload::counters.
  const std::vector<std::uint64_t>& source_counters() const { return source_counters_; }
  double source_ms() const { return source_ms_; }

 private:
  const Workload& workload_;
  std::vector<MemberExecution> executions_;
  std::uint64_t source_hash_ = 0;
  std::uint64_t pieces_ = 0;
  std::vector<std::uint64_t> source_counters_;
  double source_ms_ = 0.0;
};

/// Members of Order::kAny are fed by all threads, which take segments as they get free. A member of
/// Order::kSequential stays on one thread, which makes all pieces for it in order; several share
/// such a thread if there are more of them than threads.
class GroupRun {
 public:
  /// Requires at least one configuration, all of one source, and threads > 0.
  GroupRun(const std::vector<const Configuration*>& configurations, OutputPool& outputs,
           int threads, const OpeningListener& opening = {});
  GroupRun(const GroupRun&) = delete;
  GroupRun& operator=(const GroupRun&) = delete;
  /// Gives the outputs back.
  ~GroupRun();

  int segment_count() const { return source_->segment_count(); }

  /// Runs the pieces of some segments, in their order. Requires that it is called once. `progress`
  /// is called with the finished share of them on the caller's thread, if there is one.
  void run(const std::vector<int>& segments, const std::function<void(double)>& progress);

  std::size_t size() const { return members_.size(); }
  const Member& member(std::size_t i) const { return members_[i]; }
  /// The run of a member as a report has it; adds the instructions that it issued to `dictionary`.
  RunRecord record(std::size_t member, Dictionary& dictionary) const;
  /// Times summed over threads.
  double kernel_ms(std::size_t member) const;
  double source_ms() const;
  double observation_ms() const;

 private:
  void start_workers(std::size_t segments);
  /// Calls use(const MemberExecution&) for each execution of a member.
  template <class Use>
  void for_executions(std::size_t member, const Use& use) const;
  SourceRecord source_record() const;

  const Workload& workload_;
  OutputPool& outputs_;
  int threads_;
  std::unique_ptr<Source> source_;
  std::vector<Member> members_;
  std::vector<GroupWorker> any_order_;   ///< One a thread; each has some of the pieces.
  std::vector<GroupWorker> sequential_;  ///< Each has all of them.
};

}  // namespace lanescope
