// SPDX-License-Identifier: MIT
#include "workloads/micropolygons/mesh_scene.h"

#include <fmt/format.h>

#include "workloads/geometry/facing.h"

namespace lanescope {
namespace {

/// Why little or nothing of a mesh is drawn, if that is so; else empty.
std::string facing_note(const Facing& facing, const std::string& path) {
  if (facing.toward == 0)
    return fmt::format(
        "{}: nothing faces the viewer; {} of its triangles are seen from behind, and drawn only "
        "with --cull off",
        path, facing.away);
  if (facing.backs_in_view > 0.5)
    return fmt::format(
        "{}: most faces look away; {:.0f}% of what the viewer meets first are backs, which are "
        "drawn only with --cull off",
        path, 100.0 * facing.backs_in_view);
  return {};
}

}  // namespace

Scene load_mesh_scene(const std::string& path, MeshPatches patches, const MeshProgress& progress) {
  TriangleMesh mesh = load_mesh(path, progress);
  Scene scene;
  scene.camera.eye = {1.35f, 1.0f, 2.85f};
  scene.camera.target = {};
  scene.camera.field_degrees = 36.0f;
  scene.camera.near = 0.2f;
  scene.lighting.to_sun = normalized({-0.4f, 0.75f, 0.55f});
  scene.lighting.background = {0.16f, 0.18f, 0.21f};
  scene.notes = mesh.notes;
  if (std::string note = facing_note(facing_of(mesh, scene.camera), path); !note.empty())
    scene.notes.push_back(std::move(note));
  scene.add(make_mesh_surface(std::move(mesh), patches));
  return scene;
}

}  // namespace lanescope
