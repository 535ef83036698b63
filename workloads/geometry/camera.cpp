// SPDX-License-Identifier: MIT
#include "workloads/geometry/camera.h"

#include "simulator/base/error.h"

namespace lanescope {

Camera Camera::turned(float degrees) const {
  Camera result = *this;
  result.roll_degrees += degrees;
  return result;
}

Projection Camera::projection(int width_px, int height_px) const {
  LANESCOPE_CHECK(width_px > 0 && height_px > 0, "frame of {}x{}", width_px, height_px);
  LANESCOPE_CHECK(field_degrees > 0.0f && field_degrees < 180.0f, "field of {}", field_degrees);
  Projection result;
  result.eye_ = eye;
  result.forward_ = normalized(target - eye);
  const Vec3 level_right = normalized(cross(result.forward_, up));
  const Vec3 level_down = cross(result.forward_, level_right);
  const float roll = roll_degrees / 360.0f;
  const float c = cos_turns(roll), s = sin_turns(roll);
  result.right_ = level_right * c + level_down * s;
  result.down_ = level_down * c - level_right * s;
  LANESCOPE_CHECK(is_finite(result.right_), "the camera has no direction or 'up' lies along it");
  const float half_field = field_degrees / 720.0f;
  result.centre_x_px_ = static_cast<float>(width_px) * 0.5f;
  result.centre_y_px_ = static_cast<float>(height_px) * 0.5f;
  result.focal_px_ = result.centre_y_px_ * cos_turns(half_field) / sin_turns(half_field);
  result.near_ = near;
  return result;
}

}  // namespace lanescope
