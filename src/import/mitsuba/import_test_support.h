#pragma once
#include <string>
#include <string_view>

#include "import/mitsuba/mitsuba_import.h"
#include "import/testing/import_checks.h"

namespace ajar::mitsuba {

inline desc::SceneDesc import_with(std::string_view text, Warnings& warnings,
                                   const Files& files = {},
                                   const SceneDefinitions& definitions = {}) {
  return import_mitsuba_text(text, "test.xml", "", warnings, provider_of(files), definitions);
}

/// A scene of Mitsuba 3 with `body`, a camera and a shape in it. `body` begins in line 2.
inline std::string world(const std::string& body) {
  return "<scene version=\"3.0.0\">\n" + body +
         "\n<sensor type=\"perspective\"/><shape type=\"sphere\"/></scene>";
}

/// Imports such a scene; there must be no warnings.
inline desc::SceneDesc scene_of(const std::string& body, const Files& files = {}) {
  Warnings warnings;
  desc::SceneDesc scene = import_with(world(body), warnings, files);
  expect_none(warnings, body + "\n");
  return scene;
}

/// Message of the SceneError that importing raises, or "no error".
inline std::string error_of(std::string_view text, const Files& files = {}) {
  return error_in([&](Warnings& warnings) { import_with(text, warnings, files); });
}

/// All warnings of importing such a scene, one per line, those too that the camera may leave out.
inline std::string warnings_of(const std::string& body, const Files& files = {}) {
  return warnings_in([&](Warnings& warnings) {
    const desc::SceneDesc scene = import_with(world(body), warnings, files);
    for (const desc::WarningIfSeen& candidate : scene.warnings_if_seen) {
      warnings.add(candidate.warning);
    }
  });
}

/// A sphere of this material. It is closed, so that its back does not matter.
inline std::string sphere_of(const std::string& bsdf) {
  return "<shape type=\"sphere\">" + bsdf + "</shape>";
}

/// The material of a sphere with this bsdf, and the scene it refers to.
struct MaterialOf {
  explicit MaterialOf(const std::string& bsdf, const Files& files = {}) {
    Warnings of_import;
    scene = import_with(world(sphere_of(bsdf)), of_import, files);
    warnings = lines_of(of_import);
  }
  const desc::Material& material(int id) const {
    return scene.materials[static_cast<std::size_t>(id)];
  }
  const desc::Node& node() const { return material(scene.shapes.front().material).node; }
  const desc::Node& texture(std::string_view name) const {
    return scene.textures[static_cast<std::size_t>(node().texture(name))].node;
  }
  desc::SceneDesc scene;
  std::string warnings;
};

}  // namespace ajar::mitsuba
