#pragma once
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <string_view>

#include "core/error.h"
#include "core/warnings.h"
#include "import/mitsuba/mitsuba_import.h"

namespace ajar::mitsuba {

/// Files beside the scene.
using Files = std::map<std::string, std::string>;

inline desc::SceneDesc import_with(std::string_view text, Warnings& warnings,
                                   const Files& files = {}, const Definitions& definitions = {}) {
  return import_mitsuba_text(
      text, "test.xml", "", warnings,
      [&](const std::string& path) -> std::optional<std::string_view> {
        const auto found = files.find(path);
        if (found == files.end()) return std::nullopt;
        return found->second;
      },
      definitions);
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
  for (const std::string& message : warnings.messages()) ADD_FAILURE() << body << "\n" << message;
  return scene;
}

/// Message of the SceneError that importing raises, or "no error".
inline std::string error_of(std::string_view text, const Files& files = {}) {
  Warnings warnings;
  try {
    import_with(text, warnings, files);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no error";
}

/// All warnings of importing such a scene, one per line.
inline std::string warnings_of(const std::string& body, const Files& files = {}) {
  Warnings warnings;
  import_with(world(body), warnings, files);
  std::string result;
  for (const std::string& message : warnings.messages()) result += message + "\n";
  return result;
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

inline void expect_near(const Vec3& actual, const Vec3& expected, float tolerance = 1e-5F) {
  EXPECT_NEAR(length(actual - expected), 0.F, tolerance)
      << actual.x << " " << actual.y << " " << actual.z;
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
    for (const std::string& message : of_import.messages()) warnings += message + "\n";
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
