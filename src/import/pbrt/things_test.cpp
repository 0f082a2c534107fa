// Materials, textures, lights, shapes, camera, film and hints: pbrt-v3's defaults and meanings.
#include <gtest/gtest.h>

#include "core/color.h"
#include "core/spectrum.h"
#include "import/pbrt/import_test_support.h"
#include "import/pbrt/metals.h"

namespace ajar {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Imports a world without any warning.
desc::SceneDesc scene_of(const std::string& body,
                         const std::map<std::string, std::string>& files = {}) {
  Warnings warnings;
  desc::SceneDesc scene = import_with(world(body), warnings, files);
  for (const std::string& message : warnings.messages()) ADD_FAILURE() << body << "\n" << message;
  return scene;
}
template <typename Node>
Node material_of(const std::string& body) {
  const desc::SceneDesc scene = scene_of(body);
  return std::get<Node>(
      scene.materials.at(static_cast<std::size_t>(scene.shapes.back().material)).node);
}
desc::Rgb constant(const desc::SceneDesc& scene, desc::TextureId id) {
  return std::get<desc::ConstantTexture>(scene.textures.at(static_cast<std::size_t>(id)).node)
      .value;
}
/// The texture "t"; the scene's other textures are constants for the parameters of materials.
template <typename Node>
Node named_texture(const desc::SceneDesc& scene) {
  for (const desc::Texture& texture : scene.textures) {
    if (texture.name == "t") return std::get<Node>(texture.node);
  }
  throw std::runtime_error("there is no texture \"t\"");
}
template <typename Node>
Node texture_of(const std::string& body) {
  return named_texture<Node>(scene_of(body));
}
void expect_rgb(const desc::Rgb& actual, const desc::Rgb& expected, float tolerance = 1e-6F) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], tolerance) << i;
}

TEST(PbrtMaterials, HaveTheDefaultsOfPbrt) {
  {
    const desc::SceneDesc s = scene_of("");
    const auto m = std::get<desc::MatteMaterial>(s.materials[0].node);
    expect_rgb(constant(s, m.kd), desc::Rgb(0.5F));
    expect_rgb(constant(s, m.sigma), desc::Rgb(0.F));
  }
  {
    const desc::SceneDesc s = scene_of("Material \"glass\"");
    const auto m = std::get<desc::GlassMaterial>(s.materials[0].node);
    expect_rgb(constant(s, m.kr), desc::Rgb(1.F));
    expect_rgb(constant(s, m.eta), desc::Rgb(1.5F));
    expect_rgb(constant(s, m.u_roughness), desc::Rgb(0.F));
    EXPECT_TRUE(m.remap_roughness);
    EXPECT_FALSE(m.thin);
  }
  {
    const desc::SceneDesc s =
        scene_of("Material \"uber\" \"float roughness\" .3 \"float vroughness\" .4");
    const auto m = std::get<desc::UberMaterial>(s.materials[0].node);
    expect_rgb(constant(s, m.kd), desc::Rgb(0.25F));
    expect_rgb(constant(s, m.kr), desc::Rgb(0.F));
    expect_rgb(constant(s, m.opacity), desc::Rgb(1.F));
    expect_rgb(constant(s, m.u_roughness), desc::Rgb(0.3F));
    expect_rgb(constant(s, m.v_roughness), desc::Rgb(0.4F));
  }
  {
    const desc::SceneDesc s = scene_of("Material \"disney\" \"color color\" [.1 .2 .3]");
    const auto m = std::get<desc::DisneyMaterial>(s.materials[0].node);
    expect_rgb(constant(s, m.color), {0.1F, 0.2F, 0.3F});
    expect_rgb(constant(s, m.roughness), desc::Rgb(0.5F));
    expect_rgb(constant(s, m.sheen_tint), desc::Rgb(0.5F));
    expect_rgb(constant(s, m.clearcoat_gloss), desc::Rgb(1.F));
    expect_rgb(constant(s, m.diff_trans), desc::Rgb(1.F));
  }
  {
    const desc::SceneDesc s = scene_of("Material \"translucent\"");
    const auto m = std::get<desc::TranslucentMaterial>(s.materials[0].node);
    expect_rgb(constant(s, m.reflect), desc::Rgb(0.5F));
    expect_rgb(constant(s, m.roughness), desc::Rgb(0.1F));
  }
  const desc::SceneDesc mirror = scene_of("Material \"mirror\"");
  expect_rgb(constant(mirror, std::get<desc::MirrorMaterial>(mirror.materials[0].node).kr),
             desc::Rgb(0.9F));
}

TEST(PbrtMaterials, MetalIsCopperUnlessToldOtherwise) {
  // The RGB constants of copper that exporters compute from the same measurements (veach-mis
  // scene).
  const desc::SceneDesc s = scene_of("Material \"metal\"");
  const auto m = std::get<desc::MetalMaterial>(s.materials[0].node);
  expect_rgb(constant(s, m.eta), {0.200438F, 0.924033F, 1.102212F}, 0.01F);
  expect_rgb(constant(s, m.k), {3.912949F, 2.452848F, 2.142188F}, 0.02F);
  EXPECT_EQ(m.u_roughness, m.v_roughness);
  expect_rgb(constant(s, m.u_roughness), desc::Rgb(0.01F));
}

TEST(PbrtMaterials, MetalsAreKnownByNameUnlessTheFileExists) {
  const desc::Rgb gold_eta(*pbrt::metal_rgb("Au", pbrt::MetalQuantity::Eta));
  const desc::Rgb gold_k(*pbrt::metal_rgb("Au", pbrt::MetalQuantity::K));
  EXPECT_GT(gold_k.x, gold_k.z);
  for (const auto& [eta, k] : {std::pair("spds/metals/Au.eta.spd", "spds/metals/Au.k.spd"),
                               std::pair("metal-Au-eta", "metal-Au-k")}) {
    const desc::SceneDesc s = scene_of("Material \"metal\" \"spectrum eta\" \"" + std::string(eta) +
                                       "\" \"spectrum k\" [\"" + k + "\"]");
    const auto m = std::get<desc::MetalMaterial>(s.materials[0].node);
    expect_rgb(constant(s, m.eta), gold_eta);
    expect_rgb(constant(s, m.k), gold_k);
  }
  const desc::SceneDesc s = scene_of("Material \"metal\" \"spectrum eta\" \"Au.eta.spd\"",
                                     {{"Au.eta.spd", "# mine\n400 2\n700 2\n"}});
  const auto m = std::get<desc::MetalMaterial>(s.materials[0].node);
  EXPECT_NEAR(luminance({constant(s, m.eta).x, constant(s, m.eta).y, constant(s, m.eta).z}), 2.F,
              1e-3F);
}

TEST(PbrtMaterials, MissingSpectraAreWarningsWithTheDefault) {
  const std::string warning =
      warnings_of(world("Material \"matte\" \"spectrum Kd\" \"nothing.spd\""));
  EXPECT_TRUE(contains(warning, "test.pbrt:2:18: spectrum \"nothing.spd\" cannot be used"))
      << warning;
  EXPECT_TRUE(contains(
      warnings_of(world("Material \"matte\" \"spectrum Kd\" \"a.spd\""), {{"a.spd", "400 x"}}),
      "a.spd:1:5"));
}

TEST(PbrtMaterials, NamedOnesAreScopedAndMixed) {
  const desc::SceneDesc s = scene_of(
      "MakeNamedMaterial \"a\" \"string type\" \"mirror\" "
      "AttributeBegin MakeNamedMaterial \"a\" \"string type\" \"plastic\" NamedMaterial \"a\" "
      "Shape \"disk\" AttributeEnd "
      "MakeNamedMaterial \"m\" \"string type\" \"mix\" \"string namedmaterial1\" \"a\" \"string "
      "namedmaterial2\" \"a\" "
      "NamedMaterial \"m\"");
  EXPECT_TRUE(std::holds_alternative<desc::PlasticMaterial>(
      s.materials.at(static_cast<std::size_t>(s.shapes[0].material)).node));
  const auto mix = std::get<desc::MixMaterial>(
      s.materials.at(static_cast<std::size_t>(s.shapes[1].material)).node);
  EXPECT_TRUE(std::holds_alternative<desc::MirrorMaterial>(
      s.materials.at(static_cast<std::size_t>(mix.a)).node));
  expect_rgb(constant(s, mix.amount), desc::Rgb(0.5F));
  EXPECT_TRUE(contains(error_of("WorldBegin MakeNamedMaterial \"glas\" \"string type\" \"glass\" "
                                "NamedMaterial \"glass\""),
                       "unknown named material \"glass\"; did you mean \"glas\"?"));
  EXPECT_TRUE(contains(error_of("WorldBegin MakeNamedMaterial \"x\""), "needs \"string type\""));
}

TEST(PbrtMaterials, EmptyAndNoneAreInterfaces) {
  material_of<desc::InterfaceMaterial>("Material \"\"");
  material_of<desc::InterfaceMaterial>("Material \"none\"");
  material_of<desc::InterfaceMaterial>(
      "MakeNamedMaterial \"x\" \"string type\" \"none\" NamedMaterial \"x\"");
}

TEST(PbrtMaterials, ShapesMayOverrideParameters) {
  for (const char* set : {"Material \"plastic\" \"rgb Kd\" [.1 .2 .3]",
                          "MakeNamedMaterial \"p\" \"string type\" \"plastic\" \"rgb Kd\" [.1 .2 "
                          ".3] NamedMaterial \"p\""}) {
    const desc::SceneDesc s =
        scene_of(std::string(set) +
                 " Shape \"disk\" \"rgb Kd\" [.9 .8 .7] Shape \"disk\" \"float radius\" 2");
    const auto over = std::get<desc::PlasticMaterial>(
        s.materials.at(static_cast<std::size_t>(s.shapes[0].material)).node);
    const auto plain = std::get<desc::PlasticMaterial>(
        s.materials.at(static_cast<std::size_t>(s.shapes[1].material)).node);
    expect_rgb(constant(s, over.kd), {0.9F, 0.8F, 0.7F});
    expect_rgb(constant(s, plain.kd), {0.1F, 0.2F, 0.3F});
    EXPECT_EQ(s.shapes[1].material, s.shapes[2].material);
  }
}

TEST(PbrtMaterials, UnsupportedOnesHaveStandIns) {
  for (const char* type : {"fourier", "hair", "subsurface", "kdsubsurface"}) {
    const std::string warning = warnings_of(world("Material \"" + std::string(type) + "\""));
    EXPECT_TRUE(contains(warning, "is not supported: a matte one stands in")) << warning;
  }
  EXPECT_TRUE(contains(error_of(world("Material \"mate\"")),
                       "unknown material \"mate\"; did you mean \"matte\"?"));
}

TEST(PbrtMaterials, BumpMapsAreFloatTextures) {
  const desc::SceneDesc s =
      scene_of("Texture \"b\" \"float\" \"fbm\" Material \"matte\" \"texture bumpmap\" \"b\"");
  EXPECT_TRUE(std::holds_alternative<desc::FbmTexture>(
      s.textures.at(static_cast<std::size_t>(s.materials[0].bump)).node));
}

TEST(PbrtSpectra, AllSpellingsAreUnderstood) {
  const auto kd = [](const std::string& parameter) {
    const desc::SceneDesc s = scene_of("Material \"matte\" " + parameter);
    return constant(s, std::get<desc::MatteMaterial>(s.materials[0].node).kd);
  };
  expect_rgb(kd("\"rgb Kd\" [.1 .2 .3]"), {0.1F, 0.2F, 0.3F});
  expect_rgb(kd("\"color Kd\" [.1 .2 .3]"), {0.1F, 0.2F, 0.3F});
  expect_rgb(kd("\"xyz Kd\" [.95047 1 1.08883]"), desc::Rgb(1.F), 1e-3F);
  expect_rgb(kd("\"blackbody Kd\" [5500 .5]"), desc::Rgb(blackbody_rgb(5500.0) * 0.5));
  const desc::Rgb flat = kd("\"spectrum Kd\" [400 .4 700 .4]");
  EXPECT_NEAR(luminance({flat.x, flat.y, flat.z}), 0.4F, 1e-4F);
  expect_rgb(flat, kd("\"spectrum Kd\" [500 .4]"));
}

TEST(PbrtTextures, HaveTheDefaultsOfPbrt) {
  const desc::SceneDesc checks = scene_of("Texture \"t\" \"spectrum\" \"checkerboard\"");
  const auto c = named_texture<desc::CheckerboardTexture>(checks);
  EXPECT_EQ(c.dimension, 2);
  expect_rgb(constant(checks, c.a), desc::Rgb(1.F));
  expect_rgb(constant(checks, c.b), desc::Rgb(0.F));
  const auto marble = texture_of<desc::MarbleTexture>("Texture \"t\" \"color\" \"marble\"");
  EXPECT_EQ(marble.octaves, 8);
  EXPECT_EQ(marble.roughness, 0.5F);
  EXPECT_EQ(marble.variation, 0.2F);
  const auto bilerp =
      texture_of<desc::BilerpTexture>("Texture \"t\" \"float\" \"bilerp\" \"float v10\" 7");
  expect_rgb(bilerp.v10, desc::Rgb(7.F));
  expect_rgb(bilerp.v01, desc::Rgb(1.F));
  const desc::SceneDesc mixed = scene_of("Texture \"t\" \"float\" \"mix\"");
  const auto m = named_texture<desc::MixTexture>(mixed);
  expect_rgb(constant(mixed, m.a), desc::Rgb(0.F));
  expect_rgb(constant(mixed, m.amount), desc::Rgb(0.5F));
}

TEST(PbrtTextures, ImagesAreResolvedAndDecoded) {
  const desc::SceneDesc s = scene_of(
      "Texture \"t\" \"float\" \"imagemap\" \"string filename\" \"a/../b.png\" \"string wrap\" "
      "\"clamp\" \"bool gamma\" \"false\" "
      "\"float uscale\" 3 \"float scale\" 2 \"bool trilinear\" true \"float maxanisotropy\" 4",
      {{"b.png", ""}});
  const auto image = named_texture<desc::ImageTexture>(s);
  EXPECT_EQ(image.path, "b.png");
  EXPECT_EQ(image.wrap, desc::Wrap::Clamp);
  EXPECT_FALSE(image.decode_srgb);
  EXPECT_TRUE(image.luminance);
  EXPECT_EQ(image.scale, 2.F);
  EXPECT_EQ(std::get<desc::UvMapping>(image.mapping).su, 3.F);
  const auto colour = texture_of<desc::ImageTexture>(
      "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"x.png\"");
  EXPECT_TRUE(colour.decode_srgb);
  EXPECT_FALSE(colour.luminance);
  EXPECT_EQ(colour.path.front(), '/');
}

TEST(PbrtTextures, MappingsUseTheCurrentTransform) {
  const auto sphere = texture_of<desc::UvTexture>(
      "Translate 1 0 0 Texture \"t\" \"spectrum\" \"uv\" \"string mapping\" \"spherical\"");
  EXPECT_EQ(std::get<desc::SphericalMapping>(sphere.mapping).world_to_texture[3][0], -1.0);
  const auto plane = texture_of<desc::UvTexture>(
      "Texture \"t\" \"spectrum\" \"uv\" \"string mapping\" \"planar\" \"vector v1\" [1 2 3] "
      "\"float vdelta\" 4");
  EXPECT_EQ(std::get<desc::PlanarMapping>(plane.mapping).vs, Vec3(1.F, 2.F, 3.F));
  EXPECT_EQ(std::get<desc::PlanarMapping>(plane.mapping).dt, 4.F);
  // pbrt-v3 applies the transform itself to points of solid textures.
  EXPECT_EQ(texture_of<desc::FbmTexture>("Scale 2 2 2 Texture \"t\" \"float\" \"fbm\"")
                .world_to_texture[0][0],
            2.0);
}

TEST(PbrtTextures, FloatAndSpectrumOnesAreDifferentEvenOfOneName) {
  const desc::SceneDesc s = scene_of(
      "Texture \"t\" \"float\" \"constant\" \"float value\" .25 Texture \"t\" \"spectrum\" "
      "\"constant\" \"rgb value\" [1 0 0] "
      "Material \"matte\" \"texture Kd\" \"t\" \"texture sigma\" \"t\"");
  const auto m = std::get<desc::MatteMaterial>(s.materials[0].node);
  expect_rgb(constant(s, m.kd), {1.F, 0.F, 0.F});
  expect_rgb(constant(s, m.sigma), desc::Rgb(0.25F));
  EXPECT_TRUE(contains(
      warnings_of(
          world("Texture \"f\" \"float\" \"constant\" Material \"matte\" \"texture Kd\" \"f\"")),
      "needs a spectrum texture"));
  EXPECT_TRUE(contains(error_of(world("Material \"matte\" \"texture Kd\" \"none\"")),
                       "2:18: unknown spectrum texture \"none\""));
}

TEST(PbrtTextures, EndWithTheirScope) {
  const std::string inner =
      "AttributeBegin Texture \"t\" \"float\" \"constant\" AttributeEnd Material \"matte\" "
      "\"texture sigma\" \"t\"";
  EXPECT_TRUE(contains(error_of(world(inner)), "unknown float texture"));
  const desc::SceneDesc s =
      scene_of("Texture \"t\" \"float\" \"constant\" \"float value\" 3 " + inner);
  expect_rgb(constant(s, std::get<desc::MatteMaterial>(s.materials[0].node).sigma), desc::Rgb(3.F));
}

TEST(PbrtLights, AreaLightsBelongToShapes) {
  const desc::SceneDesc s = scene_of(
      "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [1 2 3] \"rgb scale\" [2 2 2] \"bool "
      "twosided\" \"true\" \"integer nsamples\" 4 "
      "ReverseOrientation Shape \"disk\" AttributeEnd");
  ASSERT_TRUE(s.shapes[0].light);
  EXPECT_EQ(s.shapes[0].light->radiance, desc::Rgb(2.F, 4.F, 6.F));
  EXPECT_TRUE(s.shapes[0].light->two_sided);
  EXPECT_TRUE(s.shapes[0].reverse_orientation);
  EXPECT_FALSE(s.shapes[1].light);
  EXPECT_FALSE(s.shapes[1].reverse_orientation);
}

TEST(PbrtLights, SpotsPointFromTo) {
  const desc::SceneDesc s = scene_of(
      "Translate 100 0 0 LightSource \"spot\" \"point from\" [0 5 0] \"point to\" [0 0 0] \"float "
      "coneangle\" 40 \"blackbody I\" [5500 125]");
  const desc::Light& light = s.lights[0];
  EXPECT_NEAR(length(transform_point(light.to_world, {0.F, 0.F, 0.F}) - Vec3(100.F, 5.F, 0.F)), 0.F,
              1e-5F);
  EXPECT_NEAR(length(transform_vector(light.to_world, {0.F, 0.F, 1.F}) - Vec3(0.F, -1.F, 0.F)), 0.F,
              1e-6F);
  const auto spot = std::get<desc::SpotLight>(light.node);
  EXPECT_EQ(spot.cone_angle, 40.F);
  EXPECT_EQ(spot.falloff_start, 35.F);
  EXPECT_NEAR(spot.intensity.x, 139.8F, 0.5F);
}

TEST(PbrtLights, DistantOnesPointBackToWhereTheLightComesFrom) {
  const desc::SceneDesc s = scene_of(
      "LightSource \"distant\" \"point from\" [0 10 0] \"point to\" [0 0 0] \"rgb L\" [3 3 3]");
  EXPECT_NEAR(length(transform_vector(s.lights[0].to_world, {0.F, 0.F, 1.F}) - Vec3(0.F, 1.F, 0.F)),
              0.F, 1e-6F);
  EXPECT_EQ(std::get<desc::DistantLight>(s.lights[0].node).irradiance, desc::Rgb(3.F));
}

TEST(PbrtLights, PointsAreMovedInWorldSpaceAsInPbrt) {
  const desc::SceneDesc s = scene_of("Scale 10 10 10 LightSource \"point\" \"point from\" [1 2 3]");
  EXPECT_NEAR(length(transform_point(s.lights[0].to_world, {0.F, 0.F, 0.F}) - Vec3(1.F, 2.F, 3.F)),
              0.F, 1e-5F);
}

TEST(PbrtLights, MapsAreResolved) {
  const desc::SceneDesc s = scene_of(
      "LightSource \"infinite\" \"string mapname\" \"sky.exr\" \"rgb scale\" [1 2 3] \"rgb L\" [2 "
      "2 2] \"integer samples\" 8 "
      "LightSource \"projection\" \"string mapname\" \"sky.exr\" \"float fov\" 20 LightSource "
      "\"goniometric\" \"string mapname\" \"sky.exr\"",
      {{"sky.exr", ""}});
  EXPECT_EQ(std::get<desc::InfiniteLight>(s.lights[0].node).image, "sky.exr");
  EXPECT_EQ(std::get<desc::InfiniteLight>(s.lights[0].node).radiance, desc::Rgb(2.F, 4.F, 6.F));
  EXPECT_EQ(std::get<desc::ProjectionLight>(s.lights[1].node).fov, 20.F);
  EXPECT_EQ(std::get<desc::GoniometricLight>(s.lights[2].node).image, "sky.exr");
  EXPECT_TRUE(contains(error_of(world("LightSource \"sun\"")), "unknown light \"sun\""));
  EXPECT_TRUE(contains(warnings_of(world("LightSource \"point\" \"rgb I\" [1 -1 1]")),
                       "\"I\" is negative"));
}

TEST(PbrtShapes, QuadricsHaveTheDefaultsOfPbrt) {
  const desc::SceneDesc s = scene_of(
      "Shape \"sphere\" \"float radius\" 2 Shape \"sphere\" \"float radius\" 2 \"float zmin\" -9 "
      "\"float zmax\" 1 \"float phimax\" 90 "
      "Shape \"cylinder\" Shape \"disk\" Shape \"cone\" Shape \"paraboloid\" Shape "
      "\"hyperboloid\"");
  const auto full = std::get<desc::Sphere>(s.shapes[0].node);
  EXPECT_EQ(full.z_min, -2.F);
  EXPECT_EQ(full.z_max, 2.F);
  EXPECT_EQ(full.phi_max, 360.F);
  const auto part = std::get<desc::Sphere>(s.shapes[1].node);
  EXPECT_EQ(part.z_min, -2.F);
  EXPECT_EQ(part.z_max, 1.F);
  EXPECT_EQ(std::get<desc::Cylinder>(s.shapes[2].node).z_min, -1.F);
  EXPECT_EQ(std::get<desc::Disk>(s.shapes[3].node).inner_radius, 0.F);
  EXPECT_EQ(std::get<desc::Cone>(s.shapes[4].node).height, 1.F);
  EXPECT_EQ(std::get<desc::Paraboloid>(s.shapes[5].node).z_max, 1.F);
  EXPECT_EQ(std::get<desc::Hyperboloid>(s.shapes[6].node).p2, Vec3(1.F));
}

TEST(PbrtShapes, ImpossibleOnesAreLeftOutWithAWarning) {
  for (const char* shape : {"\"sphere\" \"float radius\" -1", "\"disk\" \"float innerradius\" 3",
                            "\"nurbs\"", "\"curve\""}) {
    Warnings warnings;
    const desc::SceneDesc s = import_with(world("Shape " + std::string(shape)), warnings);
    EXPECT_EQ(s.shapes.size(), 1U) << shape;
    EXPECT_GE(warnings.count(), 1U) << shape;
  }
  EXPECT_TRUE(contains(warnings_of(world("AttributeBegin Scale 1 0 1 Shape \"disk\" AttributeEnd")),
                       "cannot be inverted: shape left out"));
}

TEST(PbrtShapes, TriangleMeshesHaveTheirAttributes) {
  const desc::SceneDesc s = scene_of(
      "Shape \"trianglemesh\" \"integer indices\" [0 1 2] \"point P\" [0 0 0 1 0 0 0 1 0] \"normal "
      "N\" [0 0 1 0 0 1 0 0 1] "
      "\"vector S\" [1 0 0 1 0 0 1 0 0] \"float uv\" [0 0 1 0 0 1]");
  const auto& mesh = *std::get<std::shared_ptr<const desc::Mesh>>(s.shapes[0].node);
  EXPECT_EQ(mesh.positions[1], Vec3(1.F, 0.F, 0.F));
  EXPECT_EQ(mesh.normals.size(), 3U);
  EXPECT_EQ(mesh.tangents.size(), 3U);
  EXPECT_EQ(mesh.uvs[2], Vec2(0.F, 1.F));
  for (const char* uv : {"\"point2 uv\"", "\"point2 st\"", "\"float st\""}) {
    const desc::SceneDesc t = scene_of(
        "Shape \"trianglemesh\" \"integer indices\" [0 1 2] \"point3 P\" [0 0 0 1 0 0 0 1 0] " +
        std::string(uv) + " [0 0 1 0 0 1]");
    EXPECT_EQ(std::get<std::shared_ptr<const desc::Mesh>>(t.shapes[0].node)->uvs.size(), 3U) << uv;
  }
}

TEST(PbrtShapes, WrongMeshesAreLocatedErrors) {
  const std::string p = "\"point P\" [0 0 0 1 0 0 0 1 0 1 1 0]";
  EXPECT_TRUE(
      contains(error_of(world("\n Shape \"trianglemesh\" \"integer indices\" [0 1 4] " + p)),
               "test.pbrt:3:2: mesh triangle 0 refers to vertex 4 of 4"));
  EXPECT_TRUE(contains(error_of(world("Shape \"trianglemesh\" \"integer indices\" [0 1 -1] " + p)),
                       "refers to vertex -1"));
  EXPECT_TRUE(contains(error_of(world("Shape \"trianglemesh\" \"integer indices\" [0 1 2]")),
                       "needs \"point P\""));
  EXPECT_TRUE(
      contains(error_of(world("Shape \"trianglemesh\" " + p)), "needs \"integer indices\""));
  EXPECT_TRUE(contains(
      error_of(
          world("Shape \"loopsubdiv\" \"integer levels\" 100 \"integer indices\" [0 1 2] " + p)),
      "make no sense"));
  const std::string flat =
      warnings_of(world("Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 0 1 1 1 1] " + p));
  EXPECT_EQ(flat, "test.pbrt:2:1: 2 of 3 triangles have no area: dropped\n");
}

const std::string kTriangle =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
    "z\nelement face 1\n"
    "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

TEST(PbrtShapes, MeshFilesAreReadOnceAndShared) {
  const desc::SceneDesc s = scene_of(
      "Shape \"plymesh\" \"string filename\" \"m/tri.ply\" Shape \"plymesh\" \"string filename\" "
      "\"m/tri.ply\"",
      {{"m/tri.ply", kTriangle}});
  const auto a = std::get<std::shared_ptr<const desc::Mesh>>(s.shapes[0].node);
  const auto b = std::get<std::shared_ptr<const desc::Mesh>>(s.shapes[1].node);
  EXPECT_EQ(a, b);
  EXPECT_EQ(a->indices.size(), 1U);
  EXPECT_EQ(s.shapes[0].name, "tri");
}

TEST(PbrtShapes, BadMeshFilesAreErrorsAtTheFirstShapeThatNamesOne) {
  const std::string two = world(
      "Shape \"plymesh\" \"string filename\" \"a.ply\"\nShape \"plymesh\" \"string filename\" "
      "\"b.ply\"");
  EXPECT_TRUE(contains(error_of(two), "test.pbrt:2:1: cannot use this mesh: cannot open"));
  std::string bad = kTriangle;
  bad.replace(bad.find("3 0 1 2"), 7, "3 0 1 7");
  const std::string error = error_of(two, {{"a.ply", kTriangle}, {"b.ply", bad}});
  EXPECT_EQ(error,
            "test.pbrt:3:1: cannot use this mesh: b.ply: mesh triangle 0 refers to vertex 7 of 3");
  const std::string cut =
      error_of(two, {{"a.ply", kTriangle.substr(0, kTriangle.size() - 6)}, {"b.ply", bad}});
  EXPECT_TRUE(contains(cut, "test.pbrt:2:1: cannot use this mesh: a.ply: the file")) << cut;
}

TEST(PbrtShapes, CurvesBecomeBezierSegments) {
  const desc::SceneDesc s = scene_of(
      "Shape \"curve\" \"point P\" [0 0 0 1 0 0 2 0 0 3 0 0 4 0 0 5 0 0 6 0 0] \"float width0\" 1 "
      "\"float width1\" 3 \"string type\" \"cylinder\" "
      "\"integer splitdepth\" 3");
  const auto& curve = *std::get<std::shared_ptr<const desc::Curve>>(s.shapes[0].node);
  EXPECT_EQ(curve.type, desc::Curve::Type::Cylinder);
  ASSERT_EQ(curve.control_points.size(), 8U);
  EXPECT_EQ(curve.control_points[4], Vec3(3.F, 0.F, 0.F));
  EXPECT_EQ(curve.widths.front(), 1.F);
  EXPECT_EQ(curve.widths[3], 2.F);
  EXPECT_EQ(curve.widths.back(), 3.F);
}

TEST(PbrtShapes, SplinesAndQuadraticsAreTheSameCurve) {
  // A straight line with evenly spaced controls: every form gives evenly spaced points on it.
  for (const char* form : {"\"integer degree\" 2 \"point P\" [0 0 0 1.5 0 0 3 0 0]",
                           "\"string basis\" \"bspline\" \"point P\" [-3 0 0 0 0 0 3 0 0 6 0 0]",
                           "\"string basis\" \"bspline\" \"integer degree\" 2 \"point P\" [-1.5 0 "
                           "0 1.5 0 0 4.5 0 0]"}) {
    const desc::SceneDesc s = scene_of("Shape \"curve\" " + std::string(form));
    const auto& curve = *std::get<std::shared_ptr<const desc::Curve>>(s.shapes[0].node);
    ASSERT_EQ(curve.control_points.size(), 4U);
    for (int i = 0; i < 4; ++i)
      EXPECT_NEAR(curve.control_points[static_cast<std::size_t>(i)].x, static_cast<float>(i), 1e-5F)
          << form;
  }
}

TEST(PbrtShapes, RibbonsTurnTheirNormalsEvenly) {
  const desc::SceneDesc s = scene_of(
      "Shape \"curve\" \"string type\" \"ribbon\" \"point P\" [0 0 0 1 0 0 2 0 0 3 0 0] \"normal "
      "N\" [0 1 0 0 0 1]");
  const auto& curve = *std::get<std::shared_ptr<const desc::Curve>>(s.shapes[0].node);
  ASSERT_EQ(curve.normals.size(), 4U);
  EXPECT_NEAR(dot(curve.normals[0], curve.normals[1]), std::cos(kPi / 6.F), 1e-5F);
  EXPECT_NEAR(dot(curve.normals[1], curve.normals[3]), std::cos(kPi / 3.F), 1e-5F);
  EXPECT_TRUE(contains(
      warnings_of(world(
          "Shape \"curve\" \"string type\" \"ribbon\" \"point P\" [0 0 0 1 0 0 2 0 0 3 0 0]")),
      "needs 2 normals"));
}

TEST(PbrtShapes, HeightFieldsAndSubdivisionSurfaces) {
  const desc::SceneDesc s = scene_of(
      "Shape \"heightfield\" \"integer nu\" 3 \"integer nv\" 2 \"float Pz\" [0 1 2 3 4 5] "
      "Shape \"loopsubdiv\" \"integer nlevels\" 2 \"integer indices\" [0 1 2] \"point P\" [0 0 0 1 "
      "0 0 0 1 0]");
  const auto& field = *std::get<std::shared_ptr<const desc::Mesh>>(s.shapes[0].node);
  EXPECT_EQ(field.indices.size(), 4U);
  EXPECT_EQ(field.positions[5], Vec3(1.F, 1.F, 5.F));
  EXPECT_EQ(std::get<std::shared_ptr<const desc::LoopSubdivision>>(s.shapes[1].node)->levels, 2);
  EXPECT_TRUE(contains(
      error_of(world(
          "Shape \"heightfield\" \"integer nu\" 1000000 \"integer nv\" 1000000 \"float Pz\" [1]")),
      "2:1"));
}

TEST(PbrtShapes, AlphaIsATextureOrAConstantZero) {
  const desc::SceneDesc s = scene_of(
      "Texture \"a\" \"float\" \"checkerboard\" Shape \"disk\" \"texture alpha\" \"a\" \"float "
      "shadowalpha\" 0 Shape \"disk\" \"float alpha\" .5");
  EXPECT_TRUE(std::holds_alternative<desc::CheckerboardTexture>(
      s.textures.at(static_cast<std::size_t>(s.shapes[0].alpha)).node));
  expect_rgb(constant(s, s.shapes[0].shadow_alpha), desc::Rgb(0.F));
  EXPECT_EQ(s.shapes[1].alpha, desc::kNone);
}

desc::SceneDesc with_options(const std::string& options) {
  Warnings warnings;
  desc::SceneDesc scene =
      import_with(options + (contains(options, "Camera") ? "" : " Camera \"perspective\"") +
                      " WorldBegin Shape \"sphere\" WorldEnd",
                  warnings);
  for (const std::string& message : warnings.messages())
    ADD_FAILURE() << options << "\n" << message;
  return scene;
}

TEST(PbrtOptions, CamerasHaveTheDefaultsOfPbrt) {
  const auto p =
      std::get<desc::PerspectiveCamera>(with_options("Camera \"perspective\"").camera.node);
  EXPECT_EQ(p.fov, 90.F);
  EXPECT_EQ(p.lens_radius, 0.F);
  EXPECT_EQ(p.focal_distance, 1e6F);
  EXPECT_FALSE(p.window);
  const auto half = std::get<desc::PerspectiveCamera>(
      with_options("Camera \"perspective\" \"float halffov\" 20 \"float frameaspectratio\" 2 "
                   "\"float shutteropen\" 0")
          .camera.node);
  EXPECT_EQ(half.fov, 40.F);
  EXPECT_EQ(*half.aspect, 2.F);
  const auto o = std::get<desc::OrthographicCamera>(
      with_options("Camera \"orthographic\" \"float screenwindow\" [-1 1 -2 2]").camera.node);
  EXPECT_EQ(o.window->y_max, 2.F);
  EXPECT_TRUE(std::holds_alternative<desc::EnvironmentCamera>(
      with_options("Camera \"environment\"").camera.node));
}

TEST(PbrtOptions, TheRealisticCameraSeesAboutTheSame) {
  Warnings warnings;
  const desc::SceneDesc s = import_with(
      "Camera \"realistic\" \"string lensfile\" \"lenses/dgauss.50mm.dat\" \"float focusdistance\" "
      "2 "
      "Film \"image\" \"integer xresolution\" 900 \"integer yresolution\" 600 \"float diagonal\" "
      "43.27 WorldBegin Shape \"sphere\" WorldEnd",
      warnings);
  EXPECT_EQ(warnings.count(), 1U);
  const auto camera = std::get<desc::PerspectiveCamera>(s.camera.node);
  EXPECT_NEAR(camera.fov, 27.F, 0.1F);  // a 36 x 24 mm frame behind 50 mm
  EXPECT_EQ(camera.focal_distance, 2.F);
}

TEST(PbrtOptions, FilmAndFilters) {
  const desc::SceneDesc none = with_options("");
  EXPECT_EQ(none.film.resolution, Vec2i(1280, 720));
  EXPECT_TRUE(std::holds_alternative<desc::BoxFilter>(none.film.filter.node));
  EXPECT_EQ(none.film.filter.radius, Vec2(0.5F, 0.5F));
  const desc::SceneDesc s = with_options(
      "PixelFilter \"gaussian\" \"float xwidth\" 3 Film \"image\" \"float cropwindow\" [.7 .3 .4 "
      "1.5] \"float scale\" 1.5 \"float diagonal\" 20");
  EXPECT_EQ(s.film.crop[0], 0.3F);
  EXPECT_EQ(s.film.crop[3], 1.F);
  EXPECT_EQ(s.film.scale, 1.5F);
  EXPECT_EQ(s.film.filter.radius, Vec2(3.F, 2.F));
  EXPECT_EQ(std::get<desc::GaussianFilter>(s.film.filter.node).alpha, 2.F);
  EXPECT_EQ(with_options("PixelFilter \"sinc\"").film.filter.radius, Vec2(4.F, 4.F));
  EXPECT_EQ(with_options("PixelFilter \"mitchell\" \"float B\" 0").film.filter.radius,
            Vec2(2.F, 2.F));
}

TEST(PbrtOptions, AbsurdOnesAreLocatedErrors) {
  EXPECT_TRUE(contains(error_of("Film \"image\" \"integer xresolution\" -5"),
                       "1:1: the resolution must be 1 to 65536, not -5"));
  EXPECT_TRUE(contains(error_of("Film \"image\" \"integer yresolution\" 70000"), "65536"));
  EXPECT_TRUE(contains(error_of("Film \"image\" \"float cropwindow\" [.5 .5 0 1]"),
                       "1:14: the crop window is empty"));
  EXPECT_TRUE(contains(error_of("Camera \"perspective\" \"float fov\" 180"), "between 0 and 180"));
  EXPECT_TRUE(contains(error_of("PixelFilter \"box\" \"float xwidth\" 1e9"), "at most 64"));
  EXPECT_TRUE(
      contains(error_of("PixelFilter \"bux\""), "unknown filter \"bux\"; did you mean \"box\"?"));
}

TEST(PbrtHints, MapIntegratorsToOurs) {
  EXPECT_EQ(with_options("").hints.integrator, "");
  EXPECT_FALSE(with_options("").hints.max_depth);
  const desc::RenderHints path =
      with_options("Integrator \"path\" \"integer maxdepth\" 65 \"float rrthreshold\" 1").hints;
  EXPECT_EQ(path.integrator, "pt");
  EXPECT_EQ(path.max_depth, 66);
  EXPECT_EQ(with_options("Integrator \"volpath\"").hints.max_depth, 6);
  EXPECT_EQ(with_options("Integrator \"bdpt\"").hints.integrator, "bdpt");
  const desc::RenderHints mlt = with_options(
                                    "Integrator \"mlt\" \"integer mutationsperpixel\" 1024 \"float "
                                    "sigma\" .02 Sampler \"random\" \"integer pixelsamples\" 3")
                                    .hints;
  EXPECT_EQ(mlt.integrator, "mmlt");
  EXPECT_EQ(mlt.samples_per_pixel, 1024);
  EXPECT_EQ(mlt.sampler, "independent");
  const std::vector<std::pair<std::string, std::string>> expected = {{"mutationsperpixel", "1024"},
                                                                     {"sigma", "0.02"}};
  EXPECT_EQ(mlt.parameters, expected);
  EXPECT_EQ(with_options("Integrator \"sppm\" \"integer numiterations\" 77 \"float radius\" .1")
                .hints.samples_per_pixel,
            77);
}

TEST(PbrtHints, MapSamplersToOurs) {
  const desc::RenderHints halton =
      with_options("Sampler \"halton\" \"integer pixelsamples\" 32").hints;
  EXPECT_EQ(halton.sampler, "sobol");
  EXPECT_EQ(halton.samples_per_pixel, 32);
  EXPECT_EQ(with_options("Sampler \"stratified\" \"integer xsamples\" 3 \"integer ysamples\" 5")
                .hints.samples_per_pixel,
            15);
  EXPECT_EQ(with_options("Sampler \"02sequence\"").hints.samples_per_pixel, 16);
  EXPECT_EQ(with_options("Accelerator \"bvh\" \"integer maxnodeprims\" 4").hints.samples_per_pixel,
            std::nullopt);
}

}  // namespace
}  // namespace ajar
