#pragma once
#include "import/pbrt/import_test_support.h"

namespace ajar {

/// A file of pbrt-v4 with `body` in its world, and `options` before it. The world starts in line 2.
inline std::string v4_world(const std::string& body, const std::string& options = "") {
  return "Film \"rgb\" Camera \"perspective\" " + options + " WorldBegin\n" + body +
         "\nShape \"sphere\"";
}

/// Imports it without any warning.
inline desc::SceneDesc v4_scene(const std::string& body, const Files& files = {},
                                const std::string& options = "") {
  Warnings warnings;
  desc::SceneDesc scene = import_with(v4_world(body, options), warnings, files);
  expect_none(warnings, body + "\n");
  return scene;
}
/// Scene of a body, whatever the warnings.
inline desc::SceneDesc v4_scene_with_warnings(const std::string& body, const Files& files = {}) {
  Warnings warnings;
  return import_with(v4_world(body), warnings, files);
}
/// The material of the last shape.
inline desc::Node v4_material(const std::string& body) {
  const desc::SceneDesc scene = v4_scene(body);
  return material_node_of(scene, scene.shapes.back());
}
inline std::string v4_warnings(const std::string& body, const Files& files = {}) {
  return warnings_of(v4_world(body), files);
}

}  // namespace ajar
