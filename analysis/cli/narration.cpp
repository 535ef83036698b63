// SPDX-License-Identifier: MIT
#include "analysis/cli/narration.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/cli/output.h"

namespace lanescope {

Narration::Notes::~Notes() {
  for (const std::string& note : all_) tell("warning: " + note);
}

void Narration::Notes::add(const std::string& note) {
  if (std::find(all_.begin(), all_.end(), note) == all_.end()) all_.push_back(note);
}

void Narration::update(double fraction, std::string_view detail) {
  fraction_ = fraction;
  progress_.update(fraction, detail);
}

OpeningListener Narration::listener() {
  return {[this](double opened) {
            progress_.update(fraction_, fmt::format("{:.0f}% of the scene opened", 100.0 * opened));
          },
          [this](const std::string& note) { notes_.add(note); }};
}

}  // namespace lanescope
