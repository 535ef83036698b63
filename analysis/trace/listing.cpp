// SPDX-License-Identifier: MIT
#include "analysis/trace/listing.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "analysis/configuration/configuration_json.h"
#include "analysis/pictures/picture_title.h"

namespace lanescope {

std::string lanes_text(std::uint64_t active, int width) {
  std::string text(static_cast<std::size_t>(width), '_');
  for (int lane = 0; lane < width; ++lane)
    if (active >> lane & 1) text[static_cast<std::size_t>(lane)] = '*';
  return text;
}

void Listing::begin(const Configuration& configuration, const Kernel& kernel) {
  kernel_ = &kernel;
  number_ = 0;
  stage_columns_ = 0;
  for (const std::string_view stage : kernel.stages)
    stage_columns_ = std::max(stage_columns_, stage.size());
  fmt::format_to(
      std::back_inserter(piece_),
      "# {} on {}, W = {}\n"
      "# parameters: {}\n"
      "# number, lanes from 0 (* on, _ off), stage, instruction, + if overhead, source\n",
      kernel.name, picture_title(configuration), configuration.width,
      configuration_json(configuration).dump());
}

void Listing::batch(std::uint64_t number) {
  fmt::format_to(std::back_inserter(piece_), "# batch {}\n", number);
}

void Listing::issued(const IssueEvent& event) {
  fmt::format_to(std::back_inserter(piece_), "{:>8}  {}  {:<{}}  {:<17} {} {}:{}\n", number_++,
                 lanes_text(event.active, event.width), kernel_->stages[event.stage],
                 stage_columns_, event.info.mnemonic, event.overhead ? '+' : ' ',
                 event.at.file_name(), event.at.line());
  if (piece_.size() >= kPieceBytes) pass_on();
}

void Listing::end() { pass_on(); }

void Listing::pass_on() {
  sink_(piece_);
  piece_.clear();
}

}  // namespace lanescope
