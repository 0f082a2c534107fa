#pragma once
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <utility>

#include "scene/bsdf/bsdf_catalogue.h"
#include "scene/desc/models.h"
#include "scene/material/material.h"

/// Fixtures for tests of materials.
namespace ajar::testing {

class Constant final : public Texture {
 public:
  explicit Constant(const Spectrum& value) : value_(value) {}
  Spectrum eval(const SurfacePoint&) const override { return value_; }
  const Spectrum* constant() const override { return &value_; }

 private:
  Spectrum value_;
};

/// slope · u, everywhere.
class Ramp final : public Texture {
 public:
  explicit Ramp(float slope) : slope_(slope) {}
  Spectrum eval(const SurfacePoint& at) const override { return Spectrum(slope_ * at.uv.x); }

 private:
  float slope_;
};

inline SurfacePoint flat_point() {
  SurfacePoint at;
  at.p = {0.F, 0.F, 0.F};
  at.ng = {0.F, 0.F, 1.F};
  at.ns = at.ng;
  at.uv = {0.5F, 0.5F};
  at.dpdu = {1.F, 0.F, 0.F};
  at.dpdv = {0.F, 1.F, 0.F};
  at.dndu = {0.F, 0.F, 0.F};
  at.dndv = {0.F, 0.F, 0.F};
  return at;
}

/// A scene description of materials alone, and its built materials.
struct Fixture {
  desc::SceneDesc scene;
  TextureList textures;
  Warnings warnings;
  MaterialList materials;

  desc::Value constant(const Spectrum& value) {
    textures.push_back(std::make_unique<Constant>(value));
    return desc::TextureRef{static_cast<int>(textures.size()) - 1};
  }
  desc::Value constant(float value) { return constant(Spectrum(value)); }
  /// slope · u.
  desc::Value ramp(float slope) {
    textures.push_back(std::make_unique<Ramp>(slope));
    return desc::TextureRef{static_cast<int>(textures.size()) - 1};
  }
  desc::MaterialId add(std::string_view model, desc::Node::Given given = {}) {
    return add(desc::material_node(model, given));
  }
  desc::MaterialId add(const desc::Node& node) {
    desc::Material material;
    material.name = "m";
    material.name += std::to_string(scene.materials.size());
    material.node = node;
    scene.materials.push_back(material);
    return static_cast<int>(scene.materials.size()) - 1;
  }
  Bsdf bsdf(desc::MaterialId id) {
    materials = build_materials(scene, textures, warnings);
    return materials[id]->bsdf(flat_point());
  }
};

inline desc::Node mix_of(desc::MaterialId first, desc::MaterialId second,
                         const Vec3& amount = Vec3(0.5F)) {
  return desc::material_node("mix", {{"amount", amount},
                                     {"first", desc::MaterialRef{first}},
                                     {"second", desc::MaterialRef{second}}});
}

inline const Vec3 kWo = direction(50.F, 200.F);
inline const Vec3 kWi = direction(35.F, 20.F);
inline constexpr TransportMode kRadiance = TransportMode::Radiance;

}  // namespace ajar::testing
