#pragma once
#include <string>
#include <string_view>
#include <variant>

#include "import/testing/import_checks.h"
#include "import/tungsten/tungsten_import.h"

namespace ajar::tungsten {

/// Imports text as "test.json", with the given files beside it.
inline desc::SceneDesc import_with(std::string_view text, Warnings& warnings,
                                   const Files& files = {}) {
  return import_tungsten_text(text, "test.json", "", warnings, provider_of(files));
}

/// Message of the SceneError that importing raises, or "no error".
inline std::string error_of(std::string_view text, const Files& files = {}) {
  return error_in([&](Warnings& warnings) { import_with(text, warnings, files); });
}

/// All warnings of importing, one per line, those too that the camera may leave out.
inline std::string warnings_of(std::string_view text, const Files& files = {}) {
  return warnings_in([&](Warnings& warnings) {
    const desc::SceneDesc scene = import_with(text, warnings, files);
    for (const desc::WarningIfSeen& candidate : scene.warnings_if_seen) {
      warnings.add(candidate.warning);
    }
  });
}

/// A scene with these members of "bsdfs" and "primitives", written with ' in place of ".
inline std::string scene_text(const std::string& bsdfs, const std::string& primitives,
                              const std::string& camera = "{}") {
  std::string text =
      "{'camera': " + camera + ",\n'bsdfs': [" + bsdfs + "],\n'primitives': [" + primitives + "]}";
  for (char& c : text) c = c == '\'' ? '"' : c;
  return text;
}

/// Imports such a scene without any warning.
inline desc::SceneDesc scene_of(const std::string& bsdfs, const std::string& primitives,
                                const std::string& camera = "{}", const Files& files = {}) {
  Warnings warnings;
  desc::SceneDesc scene = import_with(scene_text(bsdfs, primitives, camera), warnings, files);
  expect_none(warnings);
  return scene;
}

/// The material of a sphere with the bsdf "m", whose members are these.
inline desc::SceneDesc scene_with_bsdf(const std::string& members) {
  return scene_of("{'name': 'm', " + members + "}", "{'type': 'sphere', 'bsdf': 'm'}");
}
inline const desc::Node& material_of(const desc::SceneDesc& scene) {
  return scene.materials.at(static_cast<std::size_t>(scene.shapes.at(0).material)).node;
}
inline const desc::Node& part_of(const desc::SceneDesc& scene, const desc::Node& node,
                                 std::string_view name) {
  return scene.materials.at(static_cast<std::size_t>(node.material(name))).node;
}

inline Vec3 moved(const Mat4& transform, const Vec3& point) {
  return transform_point(transform, point);
}

}  // namespace ajar::tungsten
