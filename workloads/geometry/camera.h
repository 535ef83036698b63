// SPDX-License-Identifier: MIT
// A pinhole camera, and its projection onto a frame.
#pragma once

#include "workloads/geometry/vector.h"

namespace lanescope {

/// A point in camera space: x to the right, y down, z along the view, all in world units.
struct CameraPoint {
  float x = 0.0f;
  float y = 0.0f;
  float z = 0.0f;
};

/// A point on the frame: x and y in pixels, y down, (0, 0) the upper left corner; depth in [0, 1),
/// smaller is nearer and linear on the frame.
struct FramePoint {
  float x_px = 0.0f;
  float y_px = 0.0f;
  float depth = 0.0f;
};

/// A camera on a frame of a certain size.
class Projection {
 public:
  /// Camera space of a world point.
  CameraPoint to_camera(Vec3 world) const {
    const Vec3 d = world - eye_;
    return {dot(d, right_), dot(d, down_), dot(d, forward_)};
  }

  /// The frame point of a camera-space point. Requires p.z > 0.
  FramePoint to_frame(CameraPoint p) const {
    const float inverse_z = 1.0f / p.z;
    return {centre_x_px_ + p.x * inverse_z * focal_px_, centre_y_px_ + p.y * inverse_z * focal_px_,
            1.0f - near_ * inverse_z};
  }

  Vec3 eye() const { return eye_; }
  float near() const { return near_; }
  /// How far x and y reach at z = 1, from the axis to the edge of the frame.
  float half_width() const { return centre_x_px_ / focal_px_; }
  float half_height() const { return centre_y_px_ / focal_px_; }

 private:
  friend struct Camera;
  Vec3 eye_, right_, down_, forward_;
  float focal_px_ = 1.0f;
  float centre_x_px_ = 0.0f;
  float centre_y_px_ = 0.0f;
  float near_ = 0.0f;
};

struct Camera {
  Vec3 eye;
  Vec3 target{0.0f, 0.0f, -1.0f};
  Vec3 up{0.0f, 1.0f, 0.0f};
  /// Angle of view from the top of the frame to its bottom.
  float field_degrees = 40.0f;
  /// Counterclockwise turn of the picture about the view axis.
  float roll_degrees = 0.0f;
  /// Distance along the view within which nothing is drawn.
  float near = 0.1f;

  /// The same camera with the picture turned further.
  Camera turned(float degrees) const;

  /// Requires eye != target, `up` not along the view, 0 < field_degrees < 180, and a frame of at
  /// least one pixel.
  Projection projection(int width_px, int height_px) const;
};

}  // namespace lanescope
