#include "import/pbrt/dialect.h"

#include "import/pbrt/import_test_support.h"

namespace ajar::pbrt {
namespace {

DialectChoice told(std::string_view text, const std::map<std::string, std::string>& files = {}) {
  Warnings warnings;
  FileAccess access(
      "",
      [&](const std::string& path) -> std::optional<std::string_view> {
        const auto found = files.find(path);
        if (found == files.end()) return std::nullopt;
        return found->second;
      },
      warnings);
  return tell_dialect(text, "test.pbrt", access);
}

TEST(PbrtDialect, TheFilmDecidesWhateverFollows) {
  EXPECT_EQ(told("Film \"rgb\" WorldBegin Material \"matte\" WorldEnd").dialect, Dialect::V4);
  EXPECT_EQ(told("Film \"spectral\"").dialect, Dialect::V4);
  EXPECT_EQ(told("Film \"image\" WorldBegin Material \"diffuse\"").dialect, Dialect::V3);
  EXPECT_EQ(told("WorldBegin Material \"matte\" Film \"gbuffer\"").dialect, Dialect::V4);
  const DialectChoice choice = told("# a comment\n  Film [ \"rgb\" ]");
  EXPECT_EQ(choice.word, "Film \"rgb\"");
  EXPECT_EQ(choice.where.to_string(), "test.pbrt:2:10");
}

TEST(PbrtDialect, DirectivesDecideWithoutAFilm) {
  EXPECT_EQ(told("WorldBegin Material \"diffuse\" WorldEnd").dialect, Dialect::V3);
  EXPECT_EQ(told("Material \"matte\" Attribute \"shape\"").dialect, Dialect::V4);
  EXPECT_EQ(told("Option \"integer seed\" 1").dialect, Dialect::V4);
  EXPECT_EQ(told("ColorSpace \"rec2020\"").dialect, Dialect::V4);
  EXPECT_EQ(told("Import \"a.pbrt\"").dialect, Dialect::V4);
}

TEST(PbrtDialect, TheFirstNameThatOneVersionHasDecidesWithoutDirectives) {
  EXPECT_EQ(told("WorldBegin Material \"diffuse\"").dialect, Dialect::V4);
  EXPECT_EQ(told("WorldBegin MakeNamedMaterial \"a\" \"string type\" [ \"diffuse\" ]").dialect,
            Dialect::V4);
  EXPECT_EQ(told("WorldBegin MakeNamedMaterial \"a\" \"string type\" \"matte\"").dialect,
            Dialect::V3);
  EXPECT_EQ(told("Sampler \"zsobol\" WorldBegin Material \"matte\"").dialect, Dialect::V4);
  EXPECT_EQ(told("Camera \"environment\" Sampler \"zsobol\"").dialect, Dialect::V3);
  EXPECT_EQ(told("PixelFilter \"box\" \"float xradius\" 1").dialect, Dialect::V4);
  EXPECT_EQ(told("PixelFilter \"box\" \"float xwidth\" 1").dialect, Dialect::V3);
  EXPECT_EQ(told("WorldBegin Shape \"bilinearmesh\"").dialect, Dialect::V4);
  EXPECT_EQ(told("WorldBegin Texture \"a\" \"spectrum\" \"directionmix\"").dialect, Dialect::V4);
  // Both have this one.
  EXPECT_EQ(told("WorldBegin Texture \"a\" \"spectrum\" \"ptex\"").word, "");
}

TEST(PbrtDialect, UserNamesDecideNothing) {
  for (const char* text :
       {"MakeNamedMaterial \"dielectric\" \"string type\" \"mix\"", "NamedMaterial \"conductor\"",
        "Texture \"ptex\" \"float\" \"constant\"", "ObjectBegin \"interface\"",
        "MediumInterface \"cloud\" \"\"", "# Film \"rgb\"", "AreaLightSource \"diffuse\""}) {
    const DialectChoice choice = told(text);
    EXPECT_EQ(choice.dialect, Dialect::V3) << text;
    EXPECT_EQ(choice.word, "") << text;
  }
}

TEST(PbrtDialect, IncludedFilesDecideForAnAmbiguousOne) {
  const std::map<std::string, std::string> files = {{"a.pbrt", "Scale 1 1 1"},
                                                    {"b.pbrt", "Film \"rgb\""}};
  EXPECT_EQ(told("Include \"a.pbrt\" Include \"b.pbrt\"", files).dialect, Dialect::V4);
  EXPECT_EQ(told("Include \"b.pbrt\" WorldBegin WorldEnd", files).dialect, Dialect::V3);
  EXPECT_EQ(told("Include \"missing.pbrt\"", files).dialect, Dialect::V3);
  EXPECT_EQ(told("").dialect, Dialect::V3);
  EXPECT_EQ(told("Film \"rgb").dialect, Dialect::V3) << "a string without an end";
}

TEST(PbrtDialect, MessagesGiveTheReasonForTheVersion) {
  EXPECT_EQ(error_of("Film \"image\" Camera \"perspective\" WorldBegin\nMaterial \"dielectric\""),
            "test.pbrt:2:1: material \"dielectric\" belongs to pbrt-v4, but this file is read as "
            "pbrt-v3: Film \"image\" at test.pbrt:1:6");
  const std::string told_of_v4 = warnings_of(
      "Film \"rgb\" Camera \"perspective\" WorldBegin\nMaterial \"matte\"\n"
      "Shape \"sphere\"");
  EXPECT_TRUE(contains(told_of_v4,
                       "test.pbrt:2:1: material \"matte\" belongs to pbrt-v3, but this file is "
                       "read as pbrt-v4: Film \"rgb\" at test.pbrt:1:6. A matte one stands in"))
      << told_of_v4;
}

}  // namespace
}  // namespace ajar::pbrt
