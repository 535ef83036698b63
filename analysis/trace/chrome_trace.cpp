// SPDX-License-Identifier: MIT
#include "analysis/trace/chrome_trace.h"

#include <fmt/format.h>

#include <utility>

#include "analysis/configuration/configuration_json.h"

namespace lanescope {
namespace {

std::string json_string(std::string_view text) { return nlohmann::json(text).dump(); }

}  // namespace

void ChromeTrace::add(std::string_view members) {
  piece_ += first_ ? "{\"traceEvents\":[\n{" : ",\n{";
  first_ = false;
  piece_ += members;
  piece_ += '}';
  if (piece_.size() >= kPieceBytes) pass_on();
}

void ChromeTrace::begin(const Configuration& configuration, const Kernel& kernel) {
  kernel_ = &kernel;
  width_ = configuration.width;
  now_ = 0;
  slice_ = {};
  ++process_;
  const auto metadata = [&](std::string_view name, const std::string& arguments) {
    add(fmt::format(R"("name":"{}","ph":"M","pid":{},"tid":1,"args":{})", name, process_,
                    arguments));
  };
  metadata(
      "process_name",
      fmt::format(R"({{"name":{}}})", json_string(fmt::format("{}, W = {}", kernel.name, width_))));
  metadata("process_sort_index", fmt::format(R"({{"sort_index":{}}})", process_));
  metadata("process_labels", fmt::format(R"({{"labels":{}}})",
                                         json_string(configuration_json(configuration).dump())));
  metadata("thread_name", R"({"name":"stages"})");
}

void ChromeTrace::batch(std::uint64_t number) {
  end_slice();
  add(fmt::format(R"("name":"batch {}","ph":"i","pid":{},"tid":1,"ts":{},"s":"t")", number,
                  process_, now_));
}

void ChromeTrace::issued(const IssueEvent& event) {
  if (slice_.issued == 0 || slice_.stage != event.stage || slice_.active != event.active) {
    end_slice();
    slice_ = {event.stage, event.active, now_, 0, 0};
  }
  ++slice_.issued;
  slice_.charged += event.charged();
  ++now_;
}

void ChromeTrace::end_slice() {
  const Slice slice = std::exchange(slice_, {});
  if (slice.issued == 0) return;
  const double utilization = static_cast<double>(slice.charged) /
                             (static_cast<double>(slice.issued) * static_cast<double>(width_));
  add(fmt::format(R"("name":{},"cat":"stage","ph":"X","pid":{},"tid":1,"ts":{},"dur":{},)"
                  R"("args":{{"issued":{},"active":{},"utilization":{},"lanes":"{}"}})",
                  json_string(kernel_->stages[slice.stage]), process_, slice.start, slice.issued,
                  slice.issued, slice.charged, utilization, lanes_text(slice.active, width_)));
  add(fmt::format(R"("name":"utilization","ph":"C","pid":{},"ts":{},"args":{{"percent":{}}})",
                  process_, slice.start, 100.0 * utilization));
}

void ChromeTrace::end() {
  end_slice();
  add(fmt::format(R"("name":"utilization","ph":"C","pid":{},"ts":{},"args":{{"percent":0}})",
                  process_, now_));
}

void ChromeTrace::finish() {
  piece_ += "\n]}\n";
  pass_on();
}

void ChromeTrace::pass_on() {
  sink_(piece_);
  piece_.clear();
}

}  // namespace lanescope
