#include "cli/cli_fixture.h"
#include "imageio/image_file.h"

namespace ajar {
namespace {

/// Scenes with coordinates that rays cannot have. With any method, the program ends with a finite
/// picture, or with 3 and the place of the distant part.
struct FarScene {
  std::string name;
  int line = 0;  ///< line of the fault; 0: it renders
  std::string text;
  bool loses_rays = false;  ///< rays start where they cannot be traced
};

struct Parts {
  std::string camera = "LookAt 0 0 -4  0 0 0  0 1 0 Camera \"perspective\" \"float fov\" [45]";
  std::string medium = "";
  std::string light = "LightSource \"point\" \"rgb I\" [9 9 9] \"point from\" [0 2 -3]";
  std::string shape = "Shape \"sphere\"";
};

/// Camera, medium, light and shape are lines 2, 3, 5 and 6.
std::string scene(const Parts& parts) {
  return "Film \"image\" \"integer xresolution\" [8] \"integer yresolution\" [8]\n" +  //
         parts.camera + "\n" + parts.medium + "\nWorldBegin\n" + parts.light + "\n" + parts.shape +
         "\nShape \"disk\" \"float radius\" [5] \"float height\" [2]\nWorldEnd\n";
}

FarScene far_camera(const std::string& name, const std::string& camera) {
  return {name, 2, scene({.camera = camera})};
}
FarScene far_light(const std::string& name, const std::string& light) {
  return {name, 5, scene({.light = light})};
}
FarScene far_shape(const std::string& name, const std::string& shape) {
  return {name, 6, scene({.shape = shape})};
}
FarScene instance(const std::string& name, const std::string& scale) {
  return far_shape(name, "ObjectBegin \"a\" Shape \"sphere\" ObjectEnd " + scale +
                             " ObjectInstance \"a\" Identity");
}
/// Everything is in fog, which light can cross to any distance.
FarScene fog(const std::string& name, const std::string& coefficients, const std::string& more,
             bool loses_rays) {
  Parts parts;
  parts.camera = "MakeNamedMedium \"fog\" \"string type\" [\"homogeneous\"] " + coefficients +
                 " MediumInterface \"fog\" \"fog\" " + parts.camera;
  parts.light += more;
  return {name, 0, scene(parts), loses_rays};
}

std::vector<FarScene> far_scenes() {
  const std::string sky = " LightSource \"infinite\" \"rgb L\" [1 1 1]";
  const std::string look = "LookAt 0 0 -4  0 0 0  0 1 0 Camera ";
  const std::string away = "LookAt 0 0 -1e19  0 0 0  0 1 0 Camera ";
  const std::string thin = "\"rgb sigma_a\" [0 0 0] \"rgb sigma_s\" [1e-30 1e-30 1e-30]";
  const std::string interface =
      " Material \"\" MediumInterface \"\" \"fog\" Shape \"sphere\" "
      "\"float radius\" [2] Material \"matte\"";
  return {
      far_camera("far perspective", away + "\"perspective\""),
      far_camera("far orthographic", away + "\"orthographic\""),
      far_camera("far environment", away + "\"environment\""),
      far_camera("wide lens", look + "\"perspective\" \"float lensradius\" [1e30]"),
      far_camera("wide telecentric lens", look + "\"orthographic\" \"float lensradius\" [1e30]"),
      far_camera("near focus", look + "\"perspective\" \"float lensradius\" [1] "
                                      "\"float focaldistance\" [1e-44]"),
      {"far focus", 0,
       scene({.camera = look + "\"perspective\" \"float lensradius\" [1] "
                               "\"float focaldistance\" [1e30]"})},
      far_camera("wide window",
                 look + "\"orthographic\" \"float screenwindow\" [-1e30 1e30 -1e-30 1e-30]"),
      far_camera("camera in a tiny space", "Scale 1e30 1e30 1e30 " + look + "\"perspective\""),
      far_light("far point", "LightSource \"point\" \"point from\" [0 1e19 0]"),
      far_light("far spot", "LightSource \"spot\" \"point from\" [0 1e38 0]"),
      far_light("far projection", "Translate 1e19 0 0 LightSource \"projection\" Identity"),
      far_light("far area",
                "Translate 1e19 0 0 AreaLightSource \"diffuse\" Shape \"sphere\" "
                "Identity"),
      {"light in a tiny space", 0,
       scene({.light = "Scale 1e-30 1e-30 1e-30 LightSource \"spot\" LightSource \"distant\" "
                       "Identity"})},
      far_shape("large sphere", "Shape \"sphere\" \"float radius\" [1e19]"),
      far_shape("large cone", "Shape \"cone\" \"float height\" [1e38]"),
      far_shape("far mesh",
                "Shape \"trianglemesh\" \"integer indices\" [0 1 2] \"point P\" "
                "[1e19 0 0 1e19 1 0 1e19 0 1]"),
      far_shape("large triangle",
                "Shape \"trianglemesh\" \"integer indices\" [0 1 2] \"point P\" "
                "[-1e15 -1e15 5 1e15 -1e15 5 0 1e15 5]"),
      far_shape("long curve", "Shape \"curve\" \"point P\" [-1e38 0 0 0 1 0 0 0 0 1e38 0 0]"),
      instance("small instance", "Scale 1e-30 1e-30 1e-30"),
      instance("thin instance", "Scale 1e-19 1 1"),
      instance("large instance", "Scale 1e30 1e30 1e30"),
      instance("far instance", "Translate 1e19 0 0"),
      {"sky over the largest scene", 0,
       scene({.light = sky + " LightSource \"distant\"",
              .shape = "Translate 1e17 0 0 Shape \"sphere\" \"float radius\" [4e17] Identity"})},
      fog("thin fog", thin, sky, true),
      fog("thin fog with interfaces", thin, interface, true),
      fog("thin fog in one lane", "\"rgb sigma_a\" [0 0 0] \"rgb sigma_s\" [1e-30 0 1]", sky, true),
      fog("dense fog", "\"rgb sigma_a\" [1e38 0 0] \"rgb sigma_s\" [1e38 1e38 1e38]", sky, false),
  };
}

class FarScenes : public Cli {
 protected:
  Outcome render_with(const std::string& scene, const std::string& integrator) const {
    return run({"render", scene, "--integrator", integrator, "--spp", "2", "--threads", "1",
                "--depth", "1:4", "--denoise", "none", "--progress", "none", "--stats",
                "stats.json", "-o", "a.pfm"});
  }
};

TEST_F(FarScenes, EndWithAFinitePictureOrAPlace) {
  const std::vector<std::string> all = integrators();
  ASSERT_GE(all.size(), 7U);
  for (const FarScene& far : far_scenes()) {
    SCOPED_TRACE(far.name);
    const std::string scene = file("far.pbrt", far.text).string();
    if (far.line > 0) {
      // No integrator is asked before the scene is built.
      const Outcome outcome = render_with(scene, "pt");
      EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
      EXPECT_TRUE(contains(outcome.err, "far.pbrt:" + std::to_string(far.line) + ":"))
          << outcome.err;
      continue;
    }
    for (const std::string& integrator : all) {
      SCOPED_TRACE(integrator);
      const Outcome outcome = render_with(scene, integrator);
      ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
      const Image image = read_image((folder_ / "a.pfm").string());
      for (const float value : image.data) ASSERT_TRUE(std::isfinite(value));
      const auto lost = statistics().at("discarded").at("rays_out_of_range").get<int>();
      EXPECT_EQ(lost > 0, far.loses_rays) << lost;
      EXPECT_EQ(contains(outcome.err, "rays could not be traced"), far.loses_rays) << outcome.err;
      const std::string kept = statistics().at("warning_messages").dump();
      EXPECT_EQ(contains(kept, "rays could not be traced"), far.loses_rays) << kept;
    }
  }
}

}  // namespace
}  // namespace ajar
