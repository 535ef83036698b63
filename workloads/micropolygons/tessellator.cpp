// SPDX-License-Identifier: MIT
#include "workloads/micropolygons/tessellator.h"

#include <cmath>

#include "simulator/base/error.h"

namespace lanescope {
namespace {

// Splits before a patch that still crosses the eye plane is dropped, and before one that is still
// too large is diced at the limit: 20 along each parameter.
constexpr int kMaxDepth = 40;

// Splits before a patch that is still partly not finite is dropped: fewer, since such patches may
// lie along a line, and their number grows as the square root of two to this power.
constexpr int kMaxBrokenDepth = 20;

// Splits at most, when segments are made, of a patch that crosses the eye plane.
constexpr int kMaxSegmentDepth = 10;

// Quads in a segment, about: large enough that a segment's last packet, which is not full, matters
// little; small enough to keep many threads busy.
constexpr float kSegmentQuads = 80000.0f;

// The quads of a grid differ in size, because of perspective and displacement: grids aim at this
// share of the target area, so that few quads come out larger than it.
constexpr float kAim = 0.9f;

struct Rates {
  float columns = 1.0f;
  float rows = 1.0f;
};

/// How many quads of the target area cover a patch along u and v, not rounded: as many as its
/// projected area asks for, in the proportion of its sides.
Rates dice_rates(const PatchProbe& probe, float dice_area_px) {
  const float quads = probe.area_px / (kAim * dice_area_px);
  const float proportion = (probe.length_u + 1e-6f) / (probe.length_v + 1e-6f);
  return {std::sqrt(quads * proportion), std::sqrt(quads / proportion)};
}

/// Rounded up, at least 1; too large and not finite rates come out as kMaxRate.
int rounded_up(float rate) {
  constexpr float kMaxRate = 1e6f;
  return rate < kMaxRate ? std::max(1, static_cast<int>(std::ceil(rate)))
                         : static_cast<int>(kMaxRate);
}

/// Splits patches, dices the small ones and fills packets with them.
class SegmentTessellator {
 public:
  SegmentTessellator(const Projection& projection, const Lighting& lighting,
                     const TessellationOptions& options, const Tessellator::PacketSink& sink,
                     std::uint64_t segment)
      : projection_(projection),
        options_(options),
        sink_(sink),
        grid_(projection, lighting, samples_per_axis(options.samples_per_pixel),
              options.grid_overlap_px),
        packet_(options.shape, options.packet_capacity) {
    packet_.first_id = segment << 32;
    packet_.segment = segment;
  }

  void add(const Patch& patch) {
    const PatchProbe seen = probe(patch, projection_);
    switch (seen.place) {
      case PatchProbe::Place::kOutside:
        ++counts_.patches_culled;
        return;
      case PatchProbe::Place::kNotFinite:
        ++counts_.patches_dropped;
        return;
      case PatchProbe::Place::kCrossing:
        split_or_drop(patch, seen, kMaxDepth);
        return;
      case PatchProbe::Place::kBroken:
        split_or_drop(patch, seen, kMaxBrokenDepth);
        return;
      case PatchProbe::Place::kInside:
        split_or_dice(patch, seen);
        return;
    }
  }

  TessellationCounts finish() {
    if (packet_.size() > 0) flush();
    return counts_;
  }

 private:
  void split(const Patch& patch, bool along_u) {
    ++counts_.patches_split;
    const auto [low, high] = patch.halves(along_u);
    add(low);
    add(high);
  }

  void split_or_drop(const Patch& patch, const PatchProbe& seen, int max_depth) {
    if (patch.depth < max_depth)
      split(patch, seen.length_u >= seen.length_v);
    else
      ++counts_.patches_dropped;
  }

  void split_or_dice(const Patch& patch, const PatchProbe& seen) {
    const Rates rates = dice_rates(seen, options_.dice_area_px);
    const int columns = rounded_up(rates.columns), rows = rounded_up(rates.rows);
    const int limit = options_.grid_limit;
    if (std::max(columns, rows) > limit && patch.depth < kMaxDepth)
      split(patch, columns >= rows);
    else
      dice(patch, std::min(columns, limit), std::min(rows, limit));
  }

  void dice(const Patch& patch, int columns, int rows) {
    ++counts_.grids;
    grid_.dice(patch, columns, rows);
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column) emit(column, row);
  }

  void emit(int column, int row) {
    const bool triangles = options_.shape == Micropolygon::kTriangle;
    const bool sound = grid_.valid(column, row) && grid_.valid(column + 1, row) &&
                       grid_.valid(column, row + 1) && grid_.valid(column + 1, row + 1);
    if (!sound) {
      counts_.dropped += triangles ? 2 : 1;
      return;
    }
    // Counterclockwise in parameters is clockwise on the frame, whose y is down: the front.
    const Vertex corners[] = {grid_.vertex(column, row), grid_.vertex(column, row + 1),
                              grid_.vertex(column + 1, row + 1), grid_.vertex(column + 1, row)};
    if (triangles) {
      append(corners);
      const Vertex second[] = {corners[0], corners[2], corners[3]};
      append(second);
    } else {
      append(corners);
    }
  }

  void append(const Vertex* corners) {
    packet_.append(corners);
    ++counts_.micropolygons;
    if (packet_.full()) flush();
  }

  void flush() {
    sink_(packet_);
    packet_.clear(packet_.first_id + static_cast<std::uint64_t>(packet_.size()));
    ++packet_.ordinal;
  }

  const Projection& projection_;
  const TessellationOptions& options_;
  const Tessellator::PacketSink& sink_;
  Grid grid_;
  Packet packet_;
  TessellationCounts counts_;
};

void check(const TessellationOptions& options) {
  for (const auto& binding : tessellation_parameters()) {
    const Value value = binding.get(options);
    const Parameter& parameter = binding.parameter();
    if (!parameter.allows(value))
      throw ParameterError(parameter.words, fmt::format("{} is not {}", value_text(value),
                                                        parameter.allowed_values()));
  }
}

}  // namespace

Tessellator::Tessellator(const Scene& scene, const TessellationOptions& options,
                         const OpeningProgress& progress)
    : scene_(scene), options_(options) {
  check(options);
  projection_ = scene.camera.projection(options.width_px, options.height_px);
  divide_into_segments(progress);
}

void Tessellator::divide_into_segments(const OpeningProgress& progress) {
  constexpr int kPatchesBetween = 1 << 12;
  segment_starts_.push_back(0);
  float quads_in_segment = 0.0f;
  const auto place = [&](const auto& self, const Patch& patch) -> void {
    const PatchProbe seen = probe(patch, projection_);
    const bool inside = seen.place == PatchProbe::Place::kInside;
    const bool crossing = seen.place == PatchProbe::Place::kCrossing;
    const float quads = inside ? seen.area_px / (kAim * options_.dice_area_px) : 0.0f;
    if ((crossing && patch.depth < kMaxSegmentDepth) ||
        (quads > kSegmentQuads && patch.depth < kMaxDepth)) {
      const auto [low, high] = patch.halves(seen.length_u >= seen.length_v);
      self(self, low);
      self(self, high);
      return;
    }
    append(patch);
    quads_in_segment += std::max(1.0f, quads);
    if (quads_in_segment > 0.5f * kSegmentQuads) {
      segment_starts_.push_back(runs_.size());
      quads_in_segment = 0.0f;
    }
  };
  for (const std::unique_ptr<Surface>& surface : scene_.surfaces) {
    const int count = surface->patch_count();
    for (int index = 0; index < count; ++index) {
      place(place, Patch{surface.get(), index});
      if (progress && index % kPatchesBetween == 0) progress(static_cast<double>(index) / count);
    }
  }
  if (segment_starts_.back() < runs_.size()) segment_starts_.push_back(runs_.size());
}

void Tessellator::append(const Patch& patch) {
  const bool begins_segment = segment_starts_.back() == runs_.size();
  if (!begins_segment && runs_.back().goes_on_with(patch))
    ++runs_.back().count;
  else
    runs_.push_back({patch, 1});
}

TessellationCounts Tessellator::tessellate(int segment, const PacketSink& sink) const {
  LANESCOPE_CHECK(segment >= 0 && segment < segment_count(), "segment {} of {}", segment,
                  segment_count());
  SegmentTessellator work(projection_, scene_.lighting, options_, sink,
                          static_cast<std::uint64_t>(segment));
  const auto s = static_cast<std::size_t>(segment);
  for (std::size_t i = segment_starts_[s]; i < segment_starts_[s + 1]; ++i) {
    Patch patch = runs_[i].first;
    for (int k = 0; k < runs_[i].count; ++k, ++patch.index) work.add(patch);
  }
  return work.finish();
}

}  // namespace lanescope
