// SPDX-License-Identifier: MIT
#include "workloads/micropolygons/grid.h"

#include <cmath>

namespace lanescope {

void Grid::dice(const Patch& patch, int columns, int rows) {
  columns_ = columns;
  rows_ = rows;
  const auto count = static_cast<std::size_t>((columns + 1) * (rows + 1));
  points_.resize(count);
  normals_.resize(count);
  materials_.resize(count);
  vertices_.resize(count);
  valid_.resize(count);
  evaluate(patch);
  shade(patch.surface);
  project();
  if (overlap_px_ > 0.0f) extend_edges();
  snap();
}

void Grid::evaluate(const Patch& patch) {
  ParameterGrid grid;
  grid.du = (patch.u1 - patch.u0) / static_cast<float>(columns_);
  grid.dv = (patch.v1 - patch.v0) / static_cast<float>(rows_);
  grid.u0 = patch.u0;
  grid.v0 = patch.v0;
  grid.columns = columns_ + 1;
  grid.rows = rows_ + 1;
  if (patch.surface->evaluate_normals(patch.index, grid, normals_.data())) {
    patch.surface->evaluate(patch.index, grid, points_.data());
  } else {
    grid.u0 -= grid.du;
    grid.v0 -= grid.dv;
    grid.columns += 2;
    grid.rows += 2;
    ringed_.resize(static_cast<std::size_t>(grid.size()));
    patch.surface->evaluate(patch.index, grid, ringed_.data());
    take_normals_from_differences(ringed_);
  }
  patch.surface->materials(points_.data(), normals_.data(), static_cast<int>(points_.size()),
                           materials_.data());
}

void Grid::take_normals_from_differences(const std::vector<SurfacePoint>& ringed) {
  const auto stride = static_cast<std::size_t>(columns_ + 3);
  bool degenerate = false;
  for (int row = 0; row <= rows_; ++row)
    for (int column = 0; column <= columns_; ++column) {
      const std::size_t i =
          static_cast<std::size_t>(row + 1) * stride + static_cast<std::size_t>(column + 1);
      const Vec3 along_u = ringed[i + 1].position - ringed[i - 1].position;
      const Vec3 along_v = ringed[i + stride].position - ringed[i - stride].position;
      const Vec3 normal = cross(along_u, along_v);
      const float size2 = dot(normal, normal);
      // Relative to the steps, so that tiny patches are not taken for degenerate ones.
      const float steps2 = dot(along_u, along_u) * dot(along_v, along_v);
      const bool sound = size2 > 1e-7f * steps2;
      degenerate = degenerate || !sound;
      normals_[index(column, row)] = sound ? normal * (1.0f / std::sqrt(size2)) : Vec3{};
      points_[index(column, row)] = ringed[i];
    }
  if (degenerate) fill_degenerate_normals();
}

/// Where a patch comes to a point (a pole) it takes the normal of the next row or column inward.
void Grid::fill_degenerate_normals() {
  const auto is_zero = [](Vec3 n) { return n.x == 0.0f && n.y == 0.0f && n.z == 0.0f; };
  for (int row = 0; row <= rows_; ++row)
    for (int column = 0; column <= columns_; ++column) {
      Vec3& normal = normals_[index(column, row)];
      if (!is_zero(normal)) continue;
      const int inner_row = row == 0 ? 1 : row - 1;
      const int inner_column = column == 0 ? 1 : column - 1;
      normal = normals_[index(column, inner_row)];
      if (is_zero(normal)) normal = normals_[index(inner_column, row)];
      if (is_zero(normal)) normal = {0.0f, 1.0f, 0.0f};
    }
}

void Grid::shade(const Surface* surface) {
  const Vec3 centre = (points_.front().position + points_.back().position) * 0.5f;
  float radius2 = 0.0f;
  for (const SurfacePoint& point : points_) {
    const Vec3 d = point.position - centre;
    radius2 = std::max(radius2, dot(d, d));
  }
  lighting_.shadowers_near(surface, centre, std::sqrt(radius2), shadowers_);
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const Vec3 colour = lighting_.shade(materials_[i], points_[i].position, normals_[i],
                                        projection_.eye(), shadowers_);
    Vertex& vertex = vertices_[i];
    vertex[Attribute::kRed] = colour.x;
    vertex[Attribute::kGreen] = colour.y;
    vertex[Attribute::kBlue] = colour.z;
    vertex[Attribute::kAlpha] = 1.0f;
  }
}

void Grid::project() {
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const CameraPoint p = projection_.to_camera(points_[i].position);
    const bool in_front = p.z >= projection_.near() && std::isfinite(p.z);
    const FramePoint at = in_front ? projection_.to_frame(p) : FramePoint{};
    const float x = at.x_px * cells_per_px_, y = at.y_px * cells_per_px_;
    // Also false for coordinates that are not numbers.
    const bool valid =
        in_front && std::abs(x) < kMaxCoordinateCells && std::abs(y) < kMaxCoordinateCells;
    valid_[i] = valid ? 1 : 0;
    Vertex& vertex = vertices_[i];
    vertex[Attribute::kX] = valid ? x : 0.0f;
    vertex[Attribute::kY] = valid ? y : 0.0f;
    vertex[Attribute::kZ] = at.depth;
  }
}

void Grid::extend_edges() {
  for (int row = 0; row <= rows_; ++row) {
    extend(index(0, row), index(1, row));
    extend(index(columns_, row), index(columns_ - 1, row));
  }
  for (int column = 0; column <= columns_; ++column) {
    extend(index(column, 0), index(column, 1));
    extend(index(column, rows_), index(column, rows_ - 1));
  }
}

void Grid::extend(std::size_t outer, std::size_t inner) {
  if (!valid_[outer] || !valid_[inner]) return;
  Vertex& vertex = vertices_[outer];
  const float dx = vertex[Attribute::kX] - vertices_[inner][Attribute::kX];
  const float dy = vertex[Attribute::kY] - vertices_[inner][Attribute::kY];
  const float distance = std::sqrt(dx * dx + dy * dy);
  if (!(distance > 0.0f)) return;
  const float step = overlap_px_ * cells_per_px_ / distance;
  vertex[Attribute::kX] += dx * step;
  vertex[Attribute::kY] += dy * step;
}

void Grid::snap() {
  for (Vertex& vertex : vertices_)
    for (const Attribute a : {Attribute::kX, Attribute::kY})
      vertex[a] = std::floor(vertex[a] * (1.0f / kSubpixel) + 0.5f) * kSubpixel;
}

}  // namespace lanescope
