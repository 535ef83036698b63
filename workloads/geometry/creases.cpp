// SPDX-License-Identifier: MIT
#include "workloads/geometry/creases.h"

#include <algorithm>
#include <bit>
#include <span>

namespace lanescope {
namespace {

bool equal(Vec3 a, Vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

bool less(Vec3 a, Vec3 b) {
  if (a.x != b.x) return a.x < b.x;
  if (a.y != b.y) return a.y < b.y;
  return a.z < b.z;
}

/// Edge `number % 3` of triangle `number / 3`; turned so that equal edges have equal ends.
struct Edge {
  std::uint32_t number;
  bool turned;
};

class EdgeFinder {
 public:
  explicit EdgeFinder(const std::vector<MeshTriangle>& triangles) : triangles_(triangles) {}

  /// The edges at whose ends there are several normals, those between the same points together.
  std::vector<Edge> run() {
    mark_split_corners();
    std::vector<Edge> edges;
    for (std::uint32_t i = 0; i < split_.size(); ++i)
      if (split_[i] || split_[next(i)])
        edges.push_back({i, less(corner(next(i)).position, corner(i).position)});
    std::sort(edges.begin(), edges.end(), [this](const Edge& a, const Edge& b) {
      if (!equal(low(a), low(b))) return less(low(a), low(b));
      if (!equal(high(a), high(b))) return less(high(a), high(b));
      return a.number < b.number;
    });
    return edges;
  }

  bool same(const Edge& a, const Edge& b) const {
    return equal(low(a), low(b)) && equal(high(a), high(b));
  }

 private:
  static std::uint32_t next(std::uint32_t i) { return i % 3 == 2 ? i - 2 : i + 1; }
  const MeshCorner& corner(std::uint32_t i) const { return triangles_[i / 3][i % 3]; }
  Vec3 low(const Edge& e) const { return corner(e.turned ? next(e.number) : e.number).position; }
  Vec3 high(const Edge& e) const { return corner(e.turned ? e.number : next(e.number)).position; }

  /// A table of the normal first met at each position tells which positions have several.
  void mark_split_corners() {
    const auto count = static_cast<std::uint32_t>(3 * triangles_.size());
    split_.resize(count);
    std::vector<std::uint32_t> first(std::bit_ceil(2 * std::size_t{count} + 1), UINT32_MAX);
    std::vector<std::uint32_t> slots(count);
    for (std::uint32_t i = 0; i < count; ++i) {
      std::size_t slot = hash(corner(i).position) & (first.size() - 1);
      while (first[slot] != UINT32_MAX && !equal(corner(first[slot]).position, corner(i).position))
        slot = (slot + 1) & (first.size() - 1);
      if (first[slot] == UINT32_MAX) first[slot] = i;
      slots[i] = first[slot];
      if (!equal(corner(slots[i]).normal, corner(i).normal)) split_[slots[i]] = true;
    }
    for (std::uint32_t i = 0; i < count; ++i) split_[i] = split_[slots[i]];
  }

  static std::size_t hash(Vec3 p) {
    std::uint64_t h = 0;
    for (const float x : {p.x, p.y, p.z})
      h = (h ^ std::bit_cast<std::uint32_t>(x + 0.0f)) * 0x9e3779b97f4a7c15;  // -0 as 0.
    return h >> 20;
  }

  const std::vector<MeshTriangle>& triangles_;
  std::vector<bool> split_;
};

}  // namespace

EdgeOffsets edge_offsets(const MeshTriangle& triangle) {
  EdgeOffsets offsets;
  for (std::size_t e = 0; e < 3; ++e) {
    const MeshCorner &a = triangle[e], &b = triangle[(e + 1) % 3];
    const Vec3 along = b.position - a.position;
    offsets[2 * e] = a.normal * dot(along, a.normal);
    offsets[2 * e + 1] = b.normal * -dot(along, b.normal);
  }
  return offsets;
}

Creases::Creases(const std::vector<MeshTriangle>& triangles) {
  EdgeFinder finder(triangles);
  const std::vector<Edge> edges = finder.run();
  for (const Edge& edge : edges) triangles_.push_back(edge.number / 3);
  std::sort(triangles_.begin(), triangles_.end());
  triangles_.erase(std::unique(triangles_.begin(), triangles_.end()), triangles_.end());
  for (const std::uint32_t t : triangles_) offsets_.push_back(edge_offsets(triangles[t]));

  const auto offsets_at = [this](const Edge& edge, bool high) -> Vec3& {
    const auto place = std::lower_bound(triangles_.begin(), triangles_.end(), edge.number / 3);
    EdgeOffsets& all = offsets_[static_cast<std::size_t>(place - triangles_.begin())];
    return all[2 * (edge.number % 3) + (edge.turned != high ? 1 : 0)];
  };
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    while (end < edges.size() && finder.same(edges[begin], edges[end])) ++end;
    const auto shared = std::span(edges).subspan(begin, end - begin);
    for (const bool high : {false, true}) {
      Vec3 sum;
      for (const Edge& edge : shared) sum = sum + offsets_at(edge, high);
      const Vec3 average = sum * (1.0f / static_cast<float>(shared.size()));
      for (const Edge& edge : shared) offsets_at(edge, high) = average;
    }
  }
}

const EdgeOffsets* Creases::find(std::size_t triangle) const {
  const auto place = std::lower_bound(triangles_.begin(), triangles_.end(), triangle);
  return place == triangles_.end() || *place != triangle
             ? nullptr
             : &offsets_[static_cast<std::size_t>(place - triangles_.begin())];
}

}  // namespace lanescope
