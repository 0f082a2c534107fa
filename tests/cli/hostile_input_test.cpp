// Input that would hang the program, fill the memory, or reach the terminal as it is.
#include <fmt/format.h>
#include <sys/stat.h>

#include "cli/cli_fixture.h"

namespace ajar {
namespace {

class HostileInput : public Cli {
 protected:
  /// Ends the program, with 137, if it takes much longer than it may.
  Outcome run_limited(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"-s", "KILL", "60", AJAR_PROGRAM});
    return finish(start(arguments, "/usr/bin/timeout"));
  }
  std::string pipe(const std::string& name) const {
    EXPECT_EQ(mkfifo(file(name).c_str(), 0600), 0);
    return name;
  }
  /// A picture of 8 x 8 pixels of a sphere, with more statements.
  std::string scene(const std::string& options, const std::string& world) const {
    file("scene.pbrt",
         options +
             "\nFilm \"image\" \"integer xresolution\" 8 \"integer yresolution\" 8\n"
             "LookAt 0 0 -5 0 0 0 0 1 0\nCamera \"perspective\" \"float fov\" 40\nWorldBegin\n" +
             world + "\nShape \"sphere\"\nWorldEnd\n");
    return "scene.pbrt";
  }
  Outcome render_scene(std::vector<std::string> more = {}) const {
    more.insert(more.begin(),
                {"render", "scene.pbrt", "--spp", "4", "--progress", "none", "-o", "a.pfm"});
    return run_limited(more);
  }
};

void expect_refused(const Outcome& outcome, int exit_code, const std::string& part) {
  EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, part)) << outcome.err;
  EXPECT_FALSE(contains(outcome.err, "internal error")) << outcome.err;
}

TEST_F(HostileInput, PipesAndDevicesAreRefusedEverywhere) {
  const std::string picture = pipe("a.exr");
  const std::string float_map = pipe("b.pfm");
  const std::string other = pipe("a.pbrt");
  ASSERT_EQ(render({"--spp", "1", "-o", "ok.pfm"}).exit_code, 0);
  const std::string pipe_text = "it is a named pipe, and only regular files can be read";
  for (const std::string& name : {picture, float_map}) {
    expect_refused(run_limited({"compare", name, "ok.pfm"}), 4, pipe_text);
    expect_refused(run_limited({"compare", "ok.pfm", name}), 4, pipe_text);
    expect_refused(
        run_limited({"render", "builtin:cornell", "--spp", "1", "--set", "importance=" + name}), 4,
        pipe_text);
    expect_refused(
        run_limited({"render", "builtin:cornell", "--spp", "1", "--set", "regions=" + name}), 4,
        pipe_text);
  }
  for (const char* command : {"info", "render"}) {
    expect_refused(run_limited({command, other}), 4, pipe_text);
  }
  expect_refused(run_limited({"convert", other, "b.pbrt"}), 4, pipe_text);
  expect_refused(run_limited({"resume", other}), 4, pipe_text);
  expect_refused(run_limited({"merge", other, "-o", "a.pfm"}), 4, pipe_text);
  expect_refused(run_limited({"study", other}), 4, pipe_text);
  const std::string device_text = "it is a device, and only regular files can be read";
  fs::create_symlink("/dev/zero", file("zero.pfm"));
  fs::create_symlink("/dev/zero", file("zero.pbrt"));
  expect_refused(run_limited({"compare", "zero.pfm", "ok.pfm"}), 4, device_text);
  expect_refused(run_limited({"compare", "/dev/zero", "ok.pfm"}), 4, device_text);
  expect_refused(run_limited({"info", "zero.pbrt"}), 4, device_text);
  expect_refused(run_limited({"study", "/dev/zero"}), 4, device_text);
  expect_refused(
      run_limited({"render", "builtin:cornell", "--spp", "1", "--set", "regions=/dev/zero"}), 4,
      device_text);
}

TEST_F(HostileInput, PipesInScenesAreWarningsOrErrorsWithTheirPlace) {
  const std::string name = pipe("a.png");
  scene("",
        "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"a.png\"\n"
        "Material \"matte\" \"texture Kd\" \"t\"\n"
        "LightSource \"infinite\" \"string mapname\" \"a.png\"\n"
        "LightSource \"goniometric\" \"string mapname\" \"/dev/zero\"\n"
        "LightSource \"projection\" \"string mapname\" \"a.png\"\n"
        "Material \"metal\" \"spectrum eta\" \"a.png\"\n");
  EXPECT_EQ(render_scene().exit_code, 0);
  const Outcome outcome = run_limited({"info", "scene.pbrt"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* place :
       {"scene.pbrt:6:1: cannot read image", "scene.pbrt:8:1: cannot read light map",
        "scene.pbrt:9:1: cannot read light map", "scene.pbrt:10:1: cannot read light map",
        "scene.pbrt:11:18: spectrum"}) {
    EXPECT_TRUE(contains(outcome.err, place)) << place << "\n" << outcome.err;
  }
  scene("", "Shape \"plymesh\" \"string filename\" \"a.png\"");
  const Outcome without = render_scene();
  EXPECT_EQ(without.exit_code, 0) << without.err;
  EXPECT_TRUE(contains(without.err, "scene.pbrt:6:1: cannot use this mesh: cannot read"))
      << without.err;
  scene("Include \"a.png\"", "");
  expect_refused(render_scene(), 3, "scene.pbrt:1:1: cannot read");
}

TEST_F(HostileInput, SmallImagesThatClaimToBeHugeAreReplaced) {
  // 65535 x 65535 pixels in 35 bytes, for which some decoders fail inside.
  const std::string header("\0\0\2\0\0\0\0\0\0\0\0\0\xff\xff\xff\xff\x18\0", 18);
  std::ofstream(file("a.tga"), std::ios::binary) << header << std::string(17, '\0');
  scene("",
        "Texture \"t\" \"spectrum\" \"imagemap\" \"string filename\" \"a.tga\"\n"
        "Material \"matte\" \"texture Kd\" \"t\"\n"
        "LightSource \"infinite\" \"string mapname\" \"a.tga\"\n");
  const Outcome outcome = render_scene();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "it claims 65535x65535 pixels, but has 35 bytes"))
      << outcome.err;
  expect_refused(run_limited({"compare", "a.tga", "a.tga"}), 4, "it claims 65535x65535 pixels");
}

TEST_F(HostileInput, NestedMixesTakeNoLongerThanTheirFile) {
  std::string world =
      "LightSource \"infinite\"\nMakeNamedMaterial \"m0\" \"string type\" \"matte\"\n"
      "Texture \"t0\" \"spectrum\" \"uv\"\n";
  for (int i = 1; i <= 60; ++i) {
    world += fmt::format(
        "MakeNamedMaterial \"m{0}\" \"string type\" \"mix\" \"string namedmaterial1\" \"m{1}\" "
        "\"string namedmaterial2\" \"m{1}\"\n",
        i, i - 1);
  }
  scene("", world + "NamedMaterial \"m60\"");
  for (const Outcome& outcome : {run_limited({"info", "scene.pbrt"}), render_scene(),
                                 run_limited({"convert", "scene.pbrt", "b.pbrt"})}) {
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  EXPECT_TRUE(contains(run_limited({"info", "scene.pbrt"}).err, "at most 8 are possible"));
  for (int i = 1; i <= 60; ++i) {
    world += fmt::format(
        "Texture \"t{0}\" \"spectrum\" \"scale\" \"texture tex1\" \"t{1}\" \"texture tex2\" "
        "\"t{1}\"\n",
        i, i - 1);
  }
  scene("", world + "Material \"matte\" \"texture Kd\" \"t60\"");
  expect_refused(render_scene(), 3, "scene.pbrt:80:1: this texture of textures looks up");
  EXPECT_EQ(run_limited({"convert", "scene.pbrt", "b.pbrt"}).exit_code, 0);
}

TEST_F(HostileInput, FilterErrorsAreLocatedWithoutAFilm) {
  file("scene.pbrt",
       "PixelFilter \"gaussian\" \"float alpha\" -1\nCamera \"perspective\"\nWorldBegin\n"
       "Shape \"sphere\"\nWorldEnd\n");
  expect_refused(render_scene({"--resolution", "8x8"}), 3, "scene.pbrt:1:1: filter with these");
}

TEST_F(HostileInput, LightThatUnderflowsIsRenderedByEveryMethod) {
  scene("",
        "AttributeBegin\nAreaLightSource \"diffuse\" \"rgb L\" [1e-38 1e-38 1e-38]\n"
        "Translate 0 2 0\nShape \"sphere\" \"float radius\" 0.4\nAttributeEnd");
  for (const char* method :
       {"pt", "lt", "ibpt", "bdpt", "pssmlt", "mmlt", "mlt", "erpt", "masked", "selective"}) {
    const Outcome outcome = render_scene({"--integrator", method});
    EXPECT_EQ(outcome.exit_code, 0) << method << ": " << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "so dim that floats lose its digits"))
        << method << outcome.err;
  }
}

TEST_F(HostileInput, StudyNumbersThatAreTooLargeAreNoInternalErrors) {
  file("study.json", "{\"scenes\": [\"builtin:cornell\"],\n \"budgets\": [{\"time\": 1e309}]}");
  expect_refused(run_limited({"study", "study.json"}), 2,
                 "study.json:2:23: the number 1e309 is too large");
}

TEST_F(HostileInput, FileNamesOfAnyBytesAreReportedSafely) {
  const std::string odd = "caf\xe9\x1b[31m.pfm";
  ASSERT_EQ(render({"--spp", "1", "-o", odd}).exit_code, 0);
  const Outcome as_json = run_limited({"compare", odd, odd, "--json", "--metrics", "mse"});
  ASSERT_EQ(as_json.exit_code, 0) << as_json.err;
  EXPECT_TRUE(
      contains(json::parse(as_json.out).at("reference").get<std::string>(), "caf\xef\xbf\xbd"));
  const Outcome as_text = run_limited({"compare", odd, odd, "--metrics", "mse"});
  EXPECT_FALSE(contains(as_text.out, "\x1b")) << as_text.out;
  EXPECT_TRUE(contains(as_text.out, "caf\\xe9\\x1b[31m.pfm")) << as_text.out;
}

}  // namespace
}  // namespace ajar
