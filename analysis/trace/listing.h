// SPDX-License-Identifier: MIT
// A trace as text: a line for each instruction.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "analysis/trace/trace.h"

namespace lanescope {

/// Takes a document piece by piece.
using TextSink = std::function<void(std::string_view)>;

/// Lanes from 0 on, `*` where on and `_` where off.
std::string lanes_text(std::uint64_t active, int width);

/// One line an instruction: number, lanes, stage, mnemonic, `+` if it is overhead, source line.
/// Lines that begin with `#` say what is traced and where batches begin.
class Listing final : public TraceSink {
 public:
  explicit Listing(TextSink sink) : sink_(std::move(sink)) {}

  void begin(const Configuration& configuration, const Kernel& kernel) override;
  void batch(std::uint64_t number) override;
  void issued(const IssueEvent& event) override;
  void end() override;

 private:
  /// Lines are passed on in pieces of about this size.
  static constexpr std::size_t kPieceBytes = 1 << 16;

  void pass_on();

  TextSink sink_;
  std::string piece_;
  const Kernel* kernel_ = nullptr;
  std::size_t stage_columns_ = 0;  ///< Width of the column of stages.
  std::uint64_t number_ = 0;       ///< Of the next instruction.
};

}  // namespace lanescope
