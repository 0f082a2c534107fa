#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "import/pbrt/pbrt_import.h"
#include "import/testing/import_checks.h"
#include "import/testing/temporary_folder.h"

namespace ajar {

/// Imports text as "test.pbrt", with the given files beside it.
inline desc::SceneDesc import_with(std::string_view text, Warnings& warnings,
                                   const Files& files = {}) {
  return import_pbrt_text(text, "test.pbrt", "", warnings, provider_of(files));
}

/// A world with `body` in it; there must be no warnings but the one about missing shapes.
inline std::string world(const std::string& body) {
  return "Integrator \"volpath\" Camera \"perspective\" WorldBegin\n" + body +
         "\nShape \"sphere\" WorldEnd";
}

/// Message of the SceneError that importing raises, or "no error".
inline std::string error_of(std::string_view text, const Files& files = {}) {
  return error_in([&](Warnings& warnings) { import_with(text, warnings, files); });
}

/// All warnings of importing, one per line.
inline std::string warnings_of(std::string_view text, const Files& files = {}) {
  return warnings_in([&](Warnings& warnings) { import_with(text, warnings, files); });
}

/// Imports a world without any warning.
inline desc::SceneDesc scene_of(const std::string& body, const Files& files = {}) {
  Warnings warnings;
  desc::SceneDesc scene = import_with(world(body), warnings, files);
  expect_none(warnings, body + "\n");
  return scene;
}
/// The material of a shape, or of the last one.
inline const desc::Node& material_node_of(const desc::SceneDesc& scene, const desc::Shape& shape) {
  return scene.materials.at(static_cast<std::size_t>(shape.material)).node;
}
inline desc::Node material_of(const std::string& body) {
  const desc::SceneDesc scene = scene_of(body);
  return material_node_of(scene, scene.shapes.back());
}
inline desc::Rgb constant(const desc::SceneDesc& scene, desc::TextureId id) {
  return scene.textures.at(static_cast<std::size_t>(id)).node.color("value");
}
/// The texture "t".
inline const desc::Node& named_texture(const desc::SceneDesc& scene) {
  for (const desc::Texture& texture : scene.textures) {
    if (texture.name == "t") return texture.node;
  }
  throw std::runtime_error("there is no texture \"t\"");
}
inline desc::Node texture_of(const std::string& body) { return named_texture(scene_of(body)); }
inline void expect_rgb(const desc::Rgb& actual, const desc::Rgb& expected,
                       float tolerance = 1e-6F) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], tolerance) << i;
}

}  // namespace ajar
