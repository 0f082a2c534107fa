#include "scene/material/relief.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "scene/testing/materials.h"

namespace ajar {
namespace {
using namespace testing;

TEST(Bump, TiltsTheNormalAgainstTheSlope) {
  const Ramp ramp(0.5F);
  const ReliefFrame bumped = bump_frame(TextureSlot(&ramp), flat_point());
  const Vec3 expected = normalize(Vec3(-0.5F, 0.F, 1.F));
  EXPECT_LT(length(bumped.ns - expected), 1e-3F);
  EXPECT_NEAR(dot(bumped.ns, normalize(bumped.dpdu)), 0.F, 1e-3F);
  Fixture f;
  f.textures.push_back(std::make_unique<Ramp>(0.5F));
  f.scene.materials.resize(2);
  f.scene.materials[0].bump = 0;
  f.scene.materials[0].node = desc::material_node("diffuse");
  f.scene.materials[1].node = mix_of(0, 0);
  EXPECT_LT(length(f.bsdf(0).ns() - expected), 1e-3F);
  EXPECT_LT(length(f.bsdf(1).ns() - expected), 1e-3F);
  EXPECT_EQ(f.bsdf(0).ng(), Vec3(0.F, 0.F, 1.F));
}

TEST(Bump, OfNoHeightKeepsTheNormalsOfASmoothMesh) {
  // A facet of a round mesh: its tangents are in its own plane, not in that of the shading normal.
  SurfacePoint round = flat_point();
  round.ns = normalize(Vec3(0.3F, -0.2F, 1.F));
  const Ramp level(0.F);
  EXPECT_LT(length(bump_frame(TextureSlot(&level), round).ns - round.ns), 1e-6F);
  // The part of dp/du along the shading plane goes up with the slope.
  const Ramp ramp(0.5F);
  const Vec3 u = Vec3(1.F, 0.F, 0.F) - round.ns * round.ns.x;
  const Vec3 v = Vec3(0.F, 1.F, 0.F) - round.ns * round.ns.y;
  const Vec3 expected = normalize(cross(u + round.ns * 0.5F, v));
  EXPECT_LT(length(bump_frame(TextureSlot(&ramp), round).ns - expected), 1e-3F);
}

TEST(Bump, KeepsTheNormalOnItsSideAndWhereItIsDegenerate) {
  const Ramp ramp(0.5F);
  SurfacePoint flipped = flat_point();
  flipped.ng = flipped.ns = Vec3(0.F, 0.F, -1.F);
  EXPECT_GT(dot(bump_frame(TextureSlot(&ramp), flipped).ns, flipped.ng), 0.F);
  for (const float slope : {std::numeric_limits<float>::quiet_NaN(), 1e38F}) {
    const Ramp broken(slope);
    EXPECT_EQ(bump_frame(TextureSlot(&broken), flat_point()).ns, Vec3(0.F, 0.F, 1.F));
  }
  SurfacePoint pinched = flat_point();
  pinched.dpdv = pinched.dpdu;
  EXPECT_EQ(bump_frame(TextureSlot(&ramp), pinched).ns, Vec3(0.F, 0.F, 1.F));
}

/// The colour of a vector in a normal map.
TextureSlot code_of(const Vec3& n) {
  const Vec3 c = (n + Vec3(1.F)) * 0.5F;
  return TextureSlot(Spectrum(c.x, c.y, c.z));
}

TEST(NormalMap, TurnsItsVectorsIntoTheFrameOfTheSurface) {
  // A surface whose u runs along y, slanted, and whose v is mirrored: along +x.
  SurfacePoint at = flat_point();
  at.dpdu = {0.F, 2.F, 1.F};
  at.dpdv = {3.F, 0.5F, 0.F};
  const Vec3 n = normalize(Vec3(0.2F, -0.4F, 0.8F));
  const auto ns_of = [&](float strength, bool right_handed) {
    return normal_map_frame(code_of(n), strength, right_handed, at).ns;
  };
  // x of the map is the world's y, z its z, and y the side of v; or z × y = −x whatever v is.
  EXPECT_LT(length(ns_of(1.F, false) - Vec3(n.y, n.x, n.z)), 1e-6F);
  EXPECT_LT(length(ns_of(1.F, true) - Vec3(-n.y, n.x, n.z)), 1e-6F);
  EXPECT_LT(length(ns_of(0.5F, false) - normalize(Vec3(0.5F * n.y, 0.5F * n.x, n.z))), 1e-6F);
  EXPECT_EQ(ns_of(0.F, false), at.ns);
}

TEST(NormalMap, KeepsTheNormalOnItsSideAndWhereItIsNoDirection) {
  const Vec3 up(0.F, 0.F, 1.F);
  const auto ns_of = [](const TextureSlot& normals, const SurfacePoint& at) {
    return normal_map_frame(normals, 1.F, false, at).ns;
  };
  EXPECT_GT(ns_of(code_of({0.6F, 0.F, -0.8F}), flat_point()).z, 0.F);
  EXPECT_EQ(ns_of(code_of({0.F, 0.F, 0.F}), flat_point()), up);
  EXPECT_EQ(ns_of(code_of({1.F, 0.F, 0.F}), flat_point()), up) << "grazing";
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(ns_of(code_of({nan, 0.F, 1.F}), flat_point()), up);
}

TEST(NormalMap, TiltsTheReflectionOfAMaterial) {
  Fixture f;
  // The map in a texture: a constant one tilts, too, as a constant bump does not.
  const Vec3 n(0.6F, 0.F, 0.8F);
  f.scene.textures.resize(1);
  f.scene.textures[0].node = desc::texture_node("constant", {{"value", (n + Vec3(1.F)) * 0.5F}});
  f.textures = build_textures(f.scene, f.warnings);
  f.scene.materials.resize(2);
  f.scene.materials[0].normal_map.texture = 0;
  f.scene.materials[0].node = desc::material_node("diffuse", {{"reflectance", Vec3(0.5F)}});
  f.scene.materials[1].node = mix_of(0, 0);
  for (const std::size_t material : {0U, 1U}) {
    EXPECT_LT(length(f.bsdf(material).ns() - n), 1e-6F);
    EXPECT_EQ(f.bsdf(material).ng(), Vec3(0.F, 0.F, 1.F));
    EXPECT_TRUE(f.materials[material]->needs_derivatives());
  }
}

}  // namespace
}  // namespace ajar
