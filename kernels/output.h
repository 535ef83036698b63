// SPDX-License-Identifier: MIT
// What kernels write: something with a hash, counters, and perhaps a picture.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "workloads/work.h"

namespace lanescope {

/// Red, green and blue as displayed, 0 to 255.
using Colour = std::array<std::uint8_t, 3>;

/// A picture, by rows from the top: colours, or counts to be shown as a heat map.
struct Raster {
  int width_px = 0;
  int height_px = 0;
  std::vector<Colour> pixels;         ///< [height_px * width_px], or empty.
  std::vector<std::uint64_t> counts;  ///< [height_px * width_px], or empty.
  std::uint64_t count_unit = 1;       ///< What is shown is a count divided by this.
  std::string counted;                ///< What is shown, for the scale: `tests per pixel`.
};

/// What executions write into. Several executions may write into one output at a time, if their
/// kernel is of Order::kAny.
class Output {
 public:
  virtual ~Output() = default;
  /// Equal for equal content.
  virtual std::uint64_t hash() const = 0;
  /// In the order of Kernel::output_counters.
  virtual std::vector<std::uint64_t> counters() const { return {}; }
  virtual std::optional<Raster> picture() const { return std::nullopt; }
  /// Becomes empty, as `open` would give it for these arguments, in the memory that it has. Returns
  /// false, and may be left in any state, if it cannot.
  virtual bool reopen(const Arguments&, const Source&) { return false; }
};

}  // namespace lanescope
