#include "import/obj/obj_import.h"

#include "import/testing/import_checks.h"

namespace ajar {
namespace {

using Triangle = Imath::Vec3<unsigned>;

desc::SceneDesc import_with(const std::string& text, Warnings& warnings, const Files& files = {}) {
  return import_obj_text(text, "test.obj", "/scene", warnings, provider_of(files));
}
desc::SceneDesc scene_of(const std::string& text, const Files& files = {}) {
  Warnings warnings;
  desc::SceneDesc scene = import_with(text, warnings, files);
  expect_none(warnings);
  return scene;
}
std::string error_of(const std::string& text) {
  return error_in([&](Warnings& warnings) { import_with(text, warnings); });
}
std::string warnings_of(const std::string& text, const Files& files = {}) {
  return warnings_in([&](Warnings& warnings) { import_with(text, warnings, files); });
}
const desc::Mesh& mesh_of(const desc::SceneDesc& scene, std::size_t shape = 0) {
  return *scene.shapes.at(shape).node.mesh("mesh");
}

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const std::string kFace = kSquare + "mtllib a.mtl\nusemtl m\nf 1 2 3\n";
const std::string kTexturedFace =
    kSquare + "vt 0 0\nvt 1 0\nvt 1 1\nmtllib a.mtl\nusemtl m\nf 1/1 2/2 3/3\n";

desc::SceneDesc with_material(const std::string& description) {
  return scene_of(kTexturedFace, {{"/scene/a.mtl", "newmtl m\n" + description}});
}
desc::Node material_of(const std::string& description) {
  const desc::SceneDesc scene = with_material(description);
  return scene.materials.at(static_cast<std::size_t>(scene.shapes[0].material)).node;
}
const desc::Node& texture_at(const desc::SceneDesc& scene, desc::TextureId id) {
  return scene.textures.at(static_cast<std::size_t>(id)).node;
}

TEST(Obj, PolygonsAreFannedAndIndicesMayCountBackwards) {
  const desc::SceneDesc scene = scene_of(kSquare + "f 1 2 3 4\nf -4 -2 -1\n");
  EXPECT_EQ(mesh_of(scene).positions.size(), 4U);
  EXPECT_EQ(mesh_of(scene).indices, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 2, 3}}));
}

TEST(Obj, CornersThatDifferAreVerticesOfTheirOwn) {
  const desc::SceneDesc scene = scene_of(
      kSquare + "vt 0 .25\nvt 1 0\nvn 0 0 1\nvn 0 1 0\nf 1/1/1 2/1/1 3/2/1\nf 1/1/1 2/1/2 3/2/1\n");
  EXPECT_EQ(mesh_of(scene).positions.size(), 4U);
  EXPECT_EQ(mesh_of(scene).uvs[0], Vec2(0.F, 0.25F)) << "v points up, as in ours";
  EXPECT_EQ(mesh_of(scene).normals[3], Vec3(0, 1, 0));
}

TEST(Obj, FacesWithAndWithoutNormalsAreDifferentShapes) {
  const desc::SceneDesc scene = scene_of(kSquare + "vn 0 0 1\nf 1 2 3\nf 1//1 3//1 4//1\n");
  EXPECT_TRUE(mesh_of(scene, 0).normals.empty());
  EXPECT_EQ(mesh_of(scene, 1).normals.size(), 3U);
}

TEST(Obj, FacesOfMissingVerticesAreLocatedErrors) {
  EXPECT_EQ(error_of(kSquare + "f 1 2 5\n"), "test.obj:5:7: this face refers to vertex 5 of 4");
  EXPECT_EQ(error_of(kSquare + "f 1 2 -5"), "test.obj:5:7: this face refers to vertex -5 of 4");
  EXPECT_EQ(error_of(kSquare + "f 1 2 x\n"), "test.obj:5:7: this is no corner of a face: \"x\"");
  EXPECT_EQ(error_of(kSquare + "f 1/1 2/1 3/1\n"),
            "test.obj:5:3: this face refers to texture coordinate 1 of 0");
  EXPECT_EQ(error_of(kSquare + "f 1 2\n"), "test.obj: there are no faces in this file");
  EXPECT_EQ(error_of("v 0 0 0\n"), "test.obj: there are no faces in this file");
}

TEST(Obj, FilesOfMaterialsMayHaveSpacesInTheirNamesOrBeSeveral) {
  const Files files = {{"/scene/my red.mtl", "newmtl m\nKd 1 0 0\n"},
                       {"/scene/b.mtl", "newmtl b\n"},
                       {"/scene/c.mtl", "newmtl m\nKd 0 1 0\n"}};
  const auto color_of = [&](const std::string& line) {
    const desc::SceneDesc scene =
        scene_of(kSquare + "mtllib " + line + "\nusemtl m\nf 1 2 3\n", files);
    return scene.materials.at(static_cast<std::size_t>(scene.shapes[0].material))
        .node.color("reflectance");
  };
  EXPECT_EQ(color_of("my red.mtl"), Vec3(1, 0, 0));
  EXPECT_EQ(color_of("b.mtl c.mtl"), Vec3(0, 1, 0));
}

TEST(Obj, MissingAndForbiddenMaterialsAreWarnings) {
  EXPECT_TRUE(contains(warnings_of(kFace), "test.obj:5: cannot read these materials: "));
  const std::string outside = kSquare + "mtllib ../a.mtl\nf 1 2 3\n";
  EXPECT_TRUE(contains(warnings_of(outside), "outside of the folder of the scene"));
  const std::string warnings = warnings_of(kFace, {{"/scene/a.mtl", "newmtl mm\nKd 1 0 0\n"}});
  EXPECT_TRUE(contains(warnings, "test.obj:7: unknown material \"m\"; did you mean \"mm\"?"))
      << warnings;
}

TEST(Obj, ClassicMaterialsAreDiffuseOrCoated) {
  const desc::Node diffuse = material_of("Kd .1 .2 .3\nKs .5 .5 .5\nillum 1\n");
  EXPECT_TRUE(diffuse.is("diffuse"));
  EXPECT_EQ(diffuse.color("reflectance"), Vec3(0.1F, 0.2F, 0.3F));
  const desc::Node coated = material_of("Kd .1 .2 .3\nKs .5 .5 .5\nNs 198\nillum 2\n");
  EXPECT_TRUE(coated.is("coated_diffuse"));
  EXPECT_NEAR(coated.number("roughness"), 0.1F, 1e-6F);
  const desc::Node mirror = material_of("Kd 0 0 0\nKs .9 .9 .9\nillum 3\n");
  EXPECT_TRUE(mirror.is("mirror"));
}

TEST(Obj, PhysicallyBasedMaterialsArePrincipled) {
  const desc::Node node = material_of("Kd .1 .2 .3\nPr .4\nPm .7\n");
  EXPECT_TRUE(node.is("principled"));
  EXPECT_EQ(node.number("roughness"), 0.4F);
  EXPECT_EQ(node.number("metallic"), 0.7F);
}

TEST(Obj, OneNumberForAColorIsAGrey) {
  EXPECT_EQ(material_of("Kd .25\n").color("reflectance"), Vec3(0.25F));
  EXPECT_EQ(material_of("Kd .25 .5 .75 # three\n").color("reflectance"), Vec3(0.25F, 0.5F, 0.75F));
}

TEST(Obj, ImagesWithoutAFactorHaveOne) {
  for (const char* word : {"map_Kd", "Kd 1 1 1\nmap_Kd"}) {
    const desc::SceneDesc scene = with_material(std::string(word) + " oak.png\n");
    const desc::Node& node =
        scene.materials.at(static_cast<std::size_t>(scene.shapes[0].material)).node;
    EXPECT_TRUE(texture_at(scene, node.texture("reflectance")).is("image")) << word;
  }
  EXPECT_TRUE(material_of("Kd 0 0 0\nKs .5 .5 .5\nNs 10\n").is("coated_diffuse"))
      << "gloss without a model";
}

TEST(Obj, InvalidValuesOfMaterialsAreWarnings) {
  const std::string text =
      warnings_of(kTexturedFace,
                  {{"/scene/a.mtl",
                    "\xEF\xBB\xBFnewmtl m\nKd spectral a.rfl\nd -halo .3\nKs 2 0 0\nnewmtl m\n"}});
  for (const char* part :
       {"a.mtl:2:1: the value of \"Kd\" is no number: \"spectral a.rfl\" is ignored",
        "a.mtl:3:1: the value of \"d\" is no number", "a.mtl:4:1: \"Ks\" must be between 0 and 1",
        "a.mtl:5:1: there is a material \"m\" before this one"}) {
    EXPECT_TRUE(contains(text, part)) << part << "\n" << text;
  }
  EXPECT_FALSE(contains(text, "unknown material")) << text;
  EXPECT_TRUE(material_of("Kd 1 1 1\nTr 0\n").is("diffuse"));
}

TEST(Obj, NormalMapsAreVectorsAndBumpsAreWarnings) {
  const Files files = {{"/scene/a.mtl", "newmtl m\nKd 1 1 1\nd .5\nnorm n.png\n"},
                       {"/scene/n.png", ""}};
  const desc::SceneDesc scene = scene_of(kTexturedFace, files);
  const desc::Node& mix =
      scene.materials.at(static_cast<std::size_t>(scene.shapes[0].material)).node;
  ASSERT_TRUE(mix.is("mix"));
  const desc::NormalMap& map =
      scene.materials.at(static_cast<std::size_t>(mix.material("first"))).normal_map;
  ASSERT_NE(map.texture, desc::kNone);
  EXPECT_FALSE(texture_at(scene, map.texture).flag("decode_srgb"));
  EXPECT_TRUE(contains(warnings_of(kTexturedFace, {{"/scene/a.mtl", "newmtl m\nbump b.png\n"}}),
                       "bump maps, whose height has no unit, are ignored"));
}

TEST(Obj, GlassRefracts) {
  const desc::Node glass = material_of("Kd 1 1 1\nNi 1.33\nillum 7\n");
  EXPECT_TRUE(glass.is("dielectric"));
  EXPECT_EQ(glass.number("eta"), 1.33F);
  EXPECT_TRUE(material_of("d .3\nNi 1.5\nillum 4\n").is("dielectric"));
  EXPECT_FALSE(material_of("Kd 1 1 1\nd 1\nillum 4\n").is("dielectric"));
}

TEST(Obj, UnsupportedValuesOfMaterialsAreWarnings) {
  const auto warnings_with = [](const std::string& description) {
    return warnings_of(kTexturedFace,
                       {{"/scene/a.mtl", "newmtl m\n" + description}, {"/scene/a.png", ""}});
  };
  EXPECT_EQ(warnings_with("Kd .1 .5 .1\nmap_Kd a.png\nKs .5 .5 .5\nmap_Ks a.png\nNs 90\n"
                          "map_d a.png\nPr .5\nPm .5\nillum 7\n"),
            "a.mtl:1:1: glass is smooth and has the colour of \"Tf\", without \"Kd\", \"map_Kd\", "
            "\"Ks\", "
            "\"map_Ks\", \"Ns\", \"map_d\", \"Pr\", \"Pm\"\n");
  EXPECT_EQ(warnings_with("Kd 1 1 1\nKs 1 1 1\nTf .2 .3 .4\nNi 1.4\nillum 7\n"), "");
  EXPECT_EQ(warnings_with("Kd 1 1 1\nKs .5 .5 .5\nNs 90\nPr .3\nillum 2\n"),
            "a.mtl:1:1: the gloss is that of \"Pr\" and \"Pm\", without \"Ks\", \"Ns\"\n");
  EXPECT_EQ(warnings_with("Kd 1 1 1\nKs .5 .5 .5\nPr .3\nillum 1\n"), "");
  for (const char* word : {"Tf", "Kt"}) {
    EXPECT_EQ(warnings_with(std::string(word) + " .5 .5 .5\nillum 2\nKd 1 1 1\n"),
              "a.mtl:1:1: \"Tf\" is only supported in glass, of \"illum\" 6 and 7: ignored\n");
    EXPECT_EQ(warnings_with(std::string(word) + " 1 1 1\nillum 2\nKd 1 1 1\n"), "");
  }
}

TEST(Obj, NormalMapsTiltByTheirStrength) {
  const auto strength = [](const std::string& line) {
    const desc::SceneDesc scene = with_material("Kd 1 1 1\nnorm " + line + "\n");
    return scene.materials.at(static_cast<std::size_t>(scene.shapes[0].material))
        .normal_map.strength;
  };
  EXPECT_EQ(strength("a.png"), 1.F);
  EXPECT_EQ(strength("-bm 0.25 a.png"), 0.25F);
}

TEST(Obj, DissolveLetsLightPass) {
  for (const char* line : {"d .25\n", "Tr .75\n"}) {
    const desc::Node node = material_of(std::string("Kd 1 1 1\nillum 2\n") + line);
    ASSERT_TRUE(node.is("mix")) << line;
    EXPECT_NEAR(node.color("amount").x, 0.25F, 1e-6F) << line;
  }
}

TEST(Obj, ImagesAreMultipliedAndPlaced) {
  const desc::SceneDesc scene =
      with_material("Kd 1 .5 1\nmap_Kd -s 2 3 1 -o .1 .2 0 maps/oak.png\n");
  const desc::Node& product =
      texture_at(scene, scene.materials.at(static_cast<std::size_t>(scene.shapes[0].material))
                            .node.texture("reflectance"));
  EXPECT_EQ(product.color("first"), Vec3(1.F, 0.5F, 1.F));
  const desc::Node& image = texture_at(scene, product.texture("second"));
  EXPECT_EQ(image.text("file"), "/scene/maps/oak.png");
  EXPECT_TRUE(image.flag("decode_srgb"));
  EXPECT_EQ(image.number("scale_v"), 3.F);
  EXPECT_EQ(image.number("offset_u"), 0.1F);
}

/// The image of the colour of a material with this line.
desc::Node image_of(const std::string& line) {
  const desc::SceneDesc scene = with_material(line + "\n");
  return texture_at(scene, scene.materials.at(static_cast<std::size_t>(scene.shapes[0].material))
                               .node.texture("reflectance"));
}

TEST(Obj, OptionsOfImagesMayLeaveNumbersOut) {
  for (const char* line :
       {"map_Kd -s 2 2 1 oak.png", "map_Kd -s 2 2 oak.png", "map_Kd  -s\t2 2\toak.png  "}) {
    const desc::Node image = image_of(line);
    EXPECT_EQ(image.text("file"), "/scene/oak.png") << line;
    EXPECT_EQ(image.number("scale_u"), 2.F) << line;
    EXPECT_EQ(image.number("scale_v"), 2.F) << line;
  }
  EXPECT_EQ(image_of("map_Kd -s 2 oak.png").number("scale_v"), 1.F);
  EXPECT_EQ(image_of("map_Kd -o .5 -s 3 oak.png").number("offset_u"), 0.5F);
  EXPECT_EQ(image_of("map_Kd -o .5 -s 3 oak.png").number("offset_v"), 0.F);
  EXPECT_EQ(image_of("map_Kd -t 0 0 oak.png").text("file"), "/scene/oak.png");
  EXPECT_EQ(image_of("map_Kd -s 2 2 2.png").text("file"), "/scene/2.png");
  EXPECT_EQ(image_of("map_Kd -s 2 2").text("file"), "/scene/2") << "a file must be there";
}

TEST(Obj, NamesOfImagesMayHaveSpacesAndOptionsBehindThem) {
  EXPECT_EQ(image_of("map_Kd -s 2 2 my old oak.png").text("file"), "/scene/my old oak.png");
  EXPECT_EQ(image_of("map_Kd my  oak -s.png").text("file"), "/scene/my  oak -s.png");
  EXPECT_EQ(image_of("map_Kd a -s oak.png").text("file"), "/scene/a -s oak.png");
  const desc::Node behind = image_of("map_Kd my oak.png -s 2 3 -clamp on");
  EXPECT_EQ(behind.text("file"), "/scene/my oak.png");
  EXPECT_EQ(behind.number("scale_v"), 3.F);
  EXPECT_EQ(behind.text("wrap"), "clamp");
}

TEST(Obj, OptionsOfImagesAreRead) {
  EXPECT_EQ(image_of("map_Kd -clamp on oak.png").text("wrap"), "clamp");
  EXPECT_EQ(image_of("map_Kd -clamp off -blendu off -blendv on -cc off -texres 512 -boost 2 "
                     "oak.png")
                .text("wrap"),
            "repeat");
  const desc::Node stretched = image_of("map_Kd -mm .25 .5 oak.png");
  EXPECT_EQ(stretched.number("offset"), 0.25F);
  EXPECT_EQ(stretched.number("scale"), 0.5F);
  EXPECT_TRUE(stretched.flag("clamp"));
  EXPECT_EQ(image_of("map_Kd -mm .25 oak.png").number("scale"), 1.F);
  EXPECT_FALSE(image_of("map_Kd -colorspace linear oak.png").flag("decode_srgb"));
  for (const auto& [letter, channel] :
       {std::pair("r", "red"), {"g", "green"}, {"b", "blue"}, {"m", "alpha"}, {"l", "luminance"}}) {
    const desc::SceneDesc scene =
        with_material("Kd 1 1 1\nPr 1\nmap_Pr -imfchan " + std::string(letter) + " rough.png\n");
    const desc::Node& node =
        scene.materials.at(static_cast<std::size_t>(scene.shapes[0].material)).node;
    EXPECT_EQ(texture_at(scene, node.texture("roughness")).text("channel"), channel);
  }
  EXPECT_TRUE(contains(
      warnings_of(kTexturedFace, {{"/scene/a.mtl", "newmtl m\nmap_Kd -imfchan z a.png\n"}}),
      "the option \"-imfchan\""));
  EXPECT_TRUE(contains(warnings_of(kTexturedFace, {{"/scene/a.mtl", "newmtl m\nmap_Kd\n"}}),
                       "a.mtl:2:1: \"map_Kd\" names no file"));
}

TEST(Obj, FilesMayBeInUtf16) {
  const auto wide = [](const std::string& text) {
    std::string bytes = "\xFF\xFE";
    for (const char c : text) bytes += std::string{c, '\0'};
    return bytes;
  };
  const desc::SceneDesc scene =
      scene_of(wide(kFace), {{"/scene/a.mtl", wide("newmtl m\r\nKd .1 .2 .3\r\n")}});
  EXPECT_EQ(mesh_of(scene).positions.size(), 3U);
  EXPECT_EQ(scene.materials.at(static_cast<std::size_t>(scene.shapes[0].material))
                .node.color("reflectance"),
            Vec3(0.1F, 0.2F, 0.3F));
}

TEST(Obj, OpacityMapsCutAndMix) {
  const desc::SceneDesc scene = with_material("map_Kd leaf.png\nmap_d leaf.png\n");
  const desc::Node& alpha = texture_at(scene, scene.shapes[0].alpha);
  EXPECT_EQ(alpha.text("channel"), "alpha");
  EXPECT_FALSE(alpha.flag("decode_srgb"));
}

TEST(Obj, EmissionShines) {
  const desc::SceneDesc scene = with_material("Ke 5 4 0\n");
  ASSERT_TRUE(scene.shapes[0].emission);
  EXPECT_EQ(scene.shapes[0].emission->node.color("scale"), Vec3(5, 4, 0));
}

TEST(Obj, MaterialsKnowTheirLine) {
  const desc::SceneDesc scene =
      scene_of(kFace, {{"/scene/a.mtl", "# one\nnewmtl other\n\nnewmtl m\nKd 1 1 1\n"}});
  const desc::Material& material =
      scene.materials.at(static_cast<std::size_t>(scene.shapes[0].material));
  EXPECT_EQ(material.where.to_string(), "a.mtl:4:1");
}

TEST(Obj, UnreadKeywordsAreWarnings) {
  const std::string lines =
      warnings_of(kSquare +
                  "v 1 1 1 0.5\nv 0 0 1 1 0\nv 0 0 1 1 0 red\ng a\ns off\nl 1 2\n"
                  "l 2 3\nfase 1 2 3\nf 1 2 3\n");
  EXPECT_TRUE(contains(lines,
                       "test.obj:6:1: a vertex has a weight, a colour or both behind its "
                       "position: \"1 0\" is not read"))
      << lines;
  EXPECT_TRUE(contains(lines, "test.obj:10:1: \"l\": points, lines")) << lines;
  EXPECT_TRUE(contains(lines, "test.obj:12:1: \"fase\" is no word of OBJ files")) << lines;
  EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 3) << lines;
}

TEST(Obj, ColorsOfVerticesAreUsedWithoutAMaterial) {
  const std::string colored = "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\n";
  const desc::SceneDesc scene = scene_of(colored + "f 1 2 3\n");
  const desc::Node& material =
      scene.materials.at(static_cast<std::size_t>(scene.shapes[0].material)).node;
  const desc::Node& image = texture_at(scene, material.texture("base_color"));
  EXPECT_EQ(scene.embedded_files.count(image.text("file")), 1U);

  const Files files = {{"/scene/a.mtl", "newmtl m\nKd 1 0 0\n"}};
  const std::string with_material = "mtllib a.mtl\nusemtl m\nf 1 2 3\n";
  EXPECT_TRUE(contains(warnings_of(colored + with_material, files),
                       "test.obj:6: the material \"m\" counts: the colours of the vertices are "
                       "not shown"));
  EXPECT_TRUE(contains(warnings_of(colored + "usemtl n\nf 1 2 3\n"), "unknown material \"n\""));
  scene_of("v 0 0 0 1 1 1\nv 1 0 0 1 1 1\nv 1 1 0 1 1 1\n" + with_material, files);
}

TEST(Obj, UnreadKeywordsOfMaterialsAreWarnings) {
  const std::string text = warnings_of(
      kTexturedFace,
      {{"/scene/a.mtl",
        "newmtl m\nKa 1 1 1\nPs 0.0\nPc 0.5\naniso 0\nmap_Ns a.png\nkd 1 1 1\n"
        "map_Kd -s 2 2 2 -t 1 -bm 1 -boost 2 a.png\nillum 12\nrefl -type sphere a.png\n"},
       {"/scene/a.png", ""}});
  for (const char* part :
       {"a.mtl:4:1: \"Pc\" is not supported", "a.mtl:6:1: \"map_Ns\" is not supported",
        "a.mtl:7:1: \"kd\" is no word of material files; did you mean \"Kd\"?",
        "a.mtl:8:1: the option \"-t\"", "a.mtl:10:1: \"refl\" is not supported",
        "\"illum\" is from 0 to 10, not 12"}) {
    EXPECT_TRUE(contains(text, part)) << part << "\n" << text;
  }
  EXPECT_FALSE(contains(text, "\"Ps\"") || contains(text, "aniso") || contains(text, "-bm") ||
               contains(text, "-boost"))
      << text;
}

TEST(Obj, CommentsThatEndWithABackslashEndThere) {
  EXPECT_EQ(mesh_of(scene_of("# C:\\models\\\n" + kSquare + "f 1 2 3 4\n")).indices.size(), 2U);
  EXPECT_EQ(material_of(" # C:\\models\\\nKd .2 .4 .6\n").color("reflectance"),
            Vec3(0.2F, 0.4F, 0.6F));
}

TEST(Obj, LinesGoOnAfterABackslashThatSpacesFollow) {
  EXPECT_EQ(mesh_of(scene_of(kSquare + "f 1 2\\ \t\n 3\\\n4\n")).indices.size(), 2U);
}

/// Warnings of a face with texture coordinates, and its diffuse material.
struct Told {
  std::string warnings;
  desc::Node material;
};
Told told_of(const std::string& description) {
  const Files files = {{"/scene/a.mtl", "newmtl m\n" + description}};
  Warnings warnings;
  const desc::SceneDesc scene = import_with(kTexturedFace, warnings, files);
  return {lines_of(warnings),
          scene.materials.at(static_cast<std::size_t>(scene.shapes[0].material)).node};
}

TEST(Obj, ImagesWithABlackFactorAreShownWithoutIt) {
  const Told hidden = told_of("illum 1\nKd 0.00 0.00 0.00\nmap_Kd a.png\n");
  EXPECT_TRUE(contains(hidden.warnings, "a.mtl:1:1: \"Kd\" is black, which would hide the image"));
  EXPECT_TRUE(std::holds_alternative<desc::TextureRef>(hidden.material.get("reflectance")));
  const Told dark = told_of("illum 1\nKd 0.1 0 0\nmap_Kd a.png\n");
  EXPECT_FALSE(contains(dark.warnings, "is black"));
  const Told plain = told_of("illum 1\nKd 0 0 0\n");
  EXPECT_EQ(plain.warnings, "") << "black is a colour";
  EXPECT_EQ(plain.material.color("reflectance"), Vec3(0.F));
  EXPECT_FALSE(contains(told_of("Kd 0 0 0\nmap_Kd \n").warnings, "is black")) << "no image";
}

TEST(Obj, MaterialsWithoutAnyColorAreGrey) {
  const Told empty = told_of("Ns 10\nKs 0 0 0\n");
  EXPECT_EQ(empty.warnings, "a.mtl:1:1: this material has no colour: a light grey stands in\n");
  EXPECT_EQ(empty.material.color("reflectance"), Vec3(0.6F));
  for (const char* colored :
       {"Kd 0 0 0\n", "Ks 1 1 1\n", "Ke 2 2 2\n", "illum 7\n", "illum 4\nd .5\n"}) {
    EXPECT_EQ(told_of(colored).warnings, "") << colored;
  }
}

TEST(Obj, OddMaterialsAreWarnings) {
  EXPECT_TRUE(contains(told_of("Kd .2 .4\n").warnings, "a.mtl:2:1: \"Kd\" has two numbers"));
  for (const char* clear : {"Kd 1 1 1\nTr 1.0\n", "Kd 1 1 1\nd 0\n"}) {
    EXPECT_TRUE(
        contains(told_of(clear).warnings,
                 "a.mtl:1:1: nothing of this material is seen, as \"d\" is 0 or \"Tr\" is 1"))
        << clear;
  }
}

TEST(Obj, ImagesOnFacesWithoutCoordinatesAreWarnings) {
  const Files files = {{"/scene/a.mtl", "newmtl m\nKd 1 1 1\nmap_Kd a.png\n"}};
  EXPECT_EQ(warnings_of(kFace, files),
            "test.obj:7: faces from here on have no texture coordinates, which the images of "
            "\"m\" use: each triangle shows half of an image\n");
  EXPECT_EQ(warnings_of(kTexturedFace, files), "");
  EXPECT_EQ(warnings_of(kTexturedFace + "f 1 2 4\n", files).substr(0, 11), "test.obj:11");
}

TEST(Obj, NegativeIndicesCountFromTheLastVertexSoFar) {
  const desc::SceneDesc scene =
      scene_of("v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0\nf -4 -2 -1\n");
  EXPECT_EQ(mesh_of(scene).positions.size(), 4U);
  EXPECT_EQ(mesh_of(scene).indices, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(error_of(kSquare + "f 0/0/0 1/1/1 2/2/2\n"),
            "test.obj:5:3: this face refers to vertex 0 of 4");
}

}  // namespace
}  // namespace ajar
