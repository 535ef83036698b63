// SPDX-License-Identifier: MIT
// A scene as a source of packets.
#pragma once

#include "workloads/micropolygons/tessellator.h"

namespace lanescope {

/// Keeps the scene, and tessellates it.
class SceneSource final : public Source {
 public:
  SceneSource(Scene scene, const TessellationOptions& options, const OpeningProgress& progress = {})
      : scene_(std::move(scene)), tessellator_(scene_, options, progress) {}

  /// The colour of samples that nothing covers, as displayed, each channel in [0, 1].
  Vec3 background() const { return scene_.lighting.background; }

  int segment_count() const override { return tessellator_.segment_count(); }
  std::vector<std::uint64_t> produce(int segment, const WorkSink& sink) const override {
    return tessellator_.tessellate(segment, sink).values();
  }
  std::vector<std::string> notes() const override { return scene_.notes; }

 private:
  Scene scene_;
  Tessellator tessellator_;
};

}  // namespace lanescope
