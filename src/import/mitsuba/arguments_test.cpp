// No property of a scene is dropped in silence, for any plugin.
#include "import/mitsuba/import_test_support.h"
#include "import/mitsuba/plugin_types.h"

namespace ajar::mitsuba {
namespace {

/// A scene with this content.
std::size_t count_of(const std::string& scene) {
  const Files files = {{"a", "0 0 0 1\n1 0 0 1\n"}};
  Warnings warnings;
  import_with("<scene version='3.0.0'>" + scene + "</scene>", warnings, files);
  return warnings.count();
}

/// A scene in which a plugin of this kind is read. "@" is to become the plugin, which has a name.
std::string around(const std::string& tag, const std::string& type) {
  const std::string shape = "<shape type='sphere'/>";
  const std::string sensor = "<sensor type='perspective'/>";
  if (tag == "bsdf") return sensor + sphere_of("@");
  if (tag == "emitter" && type == "area") return sensor + sphere_of("@");
  if (tag == "film" || tag == "sampler") {
    return "<sensor type='perspective'>@</sensor>" + shape;
  }
  if (tag == "medium") return sensor + "<shape type='cube'>@</shape>";
  if (tag == "phase" || tag == "volume") {
    return sensor + "<shape type='cube'><medium type='heterogeneous' name='interior'>@</medium>" +
           "</shape>";
  }
  if (tag == "rfilter") {
    return "<sensor type='perspective'><film type='hdrfilm'>@</film></sensor>" + shape;
  }
  if (tag == "sensor") return "@" + shape;
  if (type == "instance") {
    return sensor + "<shape type='shapegroup' id='g'>" + shape + "</shape>@";
  }
  if (type == "shapegroup") return sensor + "<shape type='instance'>@</shape>";
  if (tag == "spectrum" || tag == "texture") {
    return sensor + sphere_of("<bsdf type='diffuse'>@</bsdf>");
  }
  return sensor + shape + "@";  // emitters, integrators, shapes
}

/// Properties that a plugin requires; others ignore them, with a warning each.
std::string needs_of(const std::string& tag, const std::string& type) {
  const std::string file = "<string name='filename' value='a'/>";
  if (tag == "bsdf") {
    return "<string name='weights' value='0.5 0.5'/><bsdf type='diffuse'/><bsdf type='diffuse'/>";
  }
  if (tag == "spectrum" || tag == "texture") {
    return file + "<string name='values' value='1 1'/><string name='wavelengths' value='400 700'/>";
  }
  if (type == "instance") return "<ref id='g'/>";
  if (type == "volcache") return "<volume type='constvolume'/>";
  return tag == "shape" || tag == "volume" ? file : "";
}

/// Name that a medium or a material has in it.
std::string name_of(const std::string& tag) {
  if (tag == "medium") return "interior";
  if (tag == "volume") return "sigma_t";
  if (tag == "spectrum" || tag == "texture") return "reflectance";
  return "";
}

class MitsubaPlugins : public ::testing::TestWithParam<const char*> {};

TEST_P(MitsubaPlugins, WarnOnceOfEachUnknownName) {
  const std::string tag = GetParam();
  const std::vector<std::string>& types = plugin_types(tag == "spectrum" ? "texture" : tag);
  ASSERT_FALSE(types.empty());
  for (const std::string& type : types) {
    const auto warnings_with = [&](const std::string& more) {
      std::string scene = around(tag, type);
      const std::string plugin = "<" + tag + " type='" + type + "' name='" + name_of(tag) + "'>" +
                                 needs_of(tag, type) + more + "</" + tag + ">";
      return count_of(scene.replace(scene.find('@'), 1, plugin));
    };
    const std::string child = tag == "film" ? "phase" : "rfilter";
    const std::string bogus_child = "<" + child + " type='box' name='bogus'/>";
    const std::string bogus = "<float name='bogus' value='1'/>";
    const std::size_t before = warnings_with("");
    EXPECT_EQ(warnings_with(bogus), before + 1) << type << ": a property";
    EXPECT_EQ(warnings_with(bogus_child), before + 1) << type << ": an element";
    EXPECT_EQ(warnings_with(bogus + bogus_child + bogus), before + 3) << type;
  }
}

INSTANTIATE_TEST_SUITE_P(Tags, MitsubaPlugins,
                         ::testing::Values("bsdf", "emitter", "film", "integrator", "medium",
                                           "phase", "rfilter", "sampler", "sensor", "shape",
                                           "spectrum", "texture", "volume"));

TEST(MitsubaArguments, OfUnknownPluginsAreNotWarnedOf) {
  for (const std::string tag :
       {"bsdf", "emitter", "film", "integrator", "medium", "phase", "rfilter", "sampler", "sensor",
        "shape", "spectrum", "texture", "volume"}) {
    std::string scene = around(tag, "foo");
    const std::string plugin = "<" + tag + " type='foo' name='" + name_of(tag) +
                               "'><float name='bogus' value='1'/></" + tag + ">";
    Warnings warnings;
    import_with("<scene version='3.0.0'>" + scene.replace(scene.find('@'), 1, plugin) + "</scene>",
                warnings);
    EXPECT_EQ(warnings.count(), 1U) << lines_of(warnings);
    EXPECT_TRUE(contains(lines_of(warnings), "\"foo\"")) << lines_of(warnings);
  }
}

TEST(MitsubaArguments, UnusedElementsAreWarnings) {
  const std::string matt = "<bsdf type='dielectric'/>";
  const std::string grey = "<texture type='checkerboard'/>";
  const auto bsdf = [&](const std::string& type, const std::string& content) {
    return sphere_of("<bsdf type='" + type + "'>" + content + "</bsdf>");
  };
  const auto seen = [](const std::string& content) {
    return "<scene version='3.0.0'><sensor type='perspective'>" + content +
           "</sensor><shape type='sphere'/></scene>";
  };
  for (const std::string& scene :
       {world(bsdf("mask", matt + matt)), world(bsdf("bumpmap", grey + matt + matt)),
        world(bsdf("bumpmap", grey + grey + matt)), world(bsdf("normalmap", grey + matt + matt)),
        world(bsdf("blendbsdf", matt + matt + matt)), world(bsdf("twosided", matt + matt + matt)),
        world(bsdf("diffuse",
                   "<texture type='scale' name='reflectance'>" + grey + grey + "</texture>")),
        world("<shape type='cube'><medium type='homogeneous' name='interior'><phase type='hg'/>"
              "<phase type='isotropic'/></medium></shape>"),
        seen("<film type='hdrfilm'/><film type='hdrfilm'/>"),
        seen("<sampler type='independent'/><sampler type='independent'/>"),
        seen("<film type='hdrfilm'><rfilter type='box'/><rfilter type='tent'/></film>")}) {
    const std::string warnings =
        warnings_in([&](Warnings& remarks) { import_with(scene, remarks); });
    EXPECT_TRUE(contains(warnings, "test.xml:") && contains(warnings, "more of <") &&
                contains(warnings, "than it can use: this is ignored"))
        << scene << warnings;
  }
  EXPECT_TRUE(contains(warnings_of(bsdf("coating", "<bsdf type='diffuse'/>" + matt)),
                       "<bsdf type=\"coating\"> has more of <bsdf> than it can use"));
}

/// The first one counts.
TEST(MitsubaArguments, OfSeveralFilmsAndFiltersTheFirstCounts) {
  Warnings warnings;
  const desc::SceneDesc scene = import_with(
      "<scene version='3.0.0'><sensor type='perspective'><film type='hdrfilm'><integer "
      "name='width' value='7'/><rfilter type='box'/><rfilter type='tent'/></film><film "
      "type='hdrfilm'/></sensor></scene>",
      warnings);
  EXPECT_EQ(scene.film.resolution.x, 7);
  EXPECT_TRUE(std::holds_alternative<desc::BoxFilter>(scene.film.filter.node));
}

TEST(MitsubaArguments, NamesOfAnotherKindAreNoUnknownNames) {
  const std::string wrong = warnings_of(
      "<shape type='cube'><bsdf type='dielectric'/><string name='interior' value='a'/></shape>");
  EXPECT_TRUE(contains(wrong, "\"interior\" of <shape type=\"cube\"> cannot be a property"))
      << wrong;
  const std::string twice = MaterialOf(
                                "<bsdf type='diffuse'><rgb name='reflectance' value='1'/><texture "
                                "name='reflectance' type='checkerboard'/></bsdf>")
                                .warnings;
  EXPECT_TRUE(contains(twice, "has another \"reflectance\", which counts instead of this"))
      << twice;
  const std::string misspelt = warnings_of(
      "<shape type='cube'><bsdf type='dielectric'/><medium name='interor' type='homogeneous'/>"
      "</shape>");
  EXPECT_TRUE(contains(misspelt, "did you mean \"interior\"?")) << misspelt;
}

}  // namespace
}  // namespace ajar::mitsuba
