// SPDX-License-Identifier: MIT
// A trace in the Trace Event format of Chrome, which Perfetto and speedscope open: a process for
// each kernel, time in instructions.
#pragma once

#include <string>

#include "analysis/trace/listing.h"
#include "analysis/trace/trace.h"

namespace lanescope {

/// Consecutive instructions of one stage under one mask are a slice; utilization is a counter that
/// changes with them. An instruction takes one unit of time, which viewers call a microsecond.
class ChromeTrace final : public TraceSink {
 public:
  explicit ChromeTrace(TextSink sink) : sink_(std::move(sink)) {}

  void begin(const Configuration& configuration, const Kernel& kernel) override;
  void batch(std::uint64_t number) override;
  void issued(const IssueEvent& event) override;
  void end() override;
  /// Completes the document, after the last kernel.
  void finish();

 private:
  static constexpr std::size_t kPieceBytes = 1 << 16;

  struct Slice {
    std::size_t stage = 0;
    std::uint64_t active = 0;  ///< The mask.
    std::uint64_t start = 0;
    std::uint64_t issued = 0;  ///< None: there is no slice.
    std::uint64_t charged = 0;
  };

  /// Appends an event, given as the text of its members.
  void add(std::string_view members);
  void end_slice();
  void pass_on();

  TextSink sink_;
  std::string piece_;
  bool first_ = true;  ///< No event yet.
  const Kernel* kernel_ = nullptr;
  int process_ = 0;
  int width_ = 0;
  std::uint64_t now_ = 0;
  Slice slice_;
};

}  // namespace lanescope
