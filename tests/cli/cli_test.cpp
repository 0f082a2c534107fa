// The program as a user runs it.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "cli/cli_fixture.h"
#include "imageio/image_file.h"

namespace ajar {
namespace {

using namespace std::chrono_literals;

TEST_F(Cli, HelpAndVersionSucceed) {
  EXPECT_EQ(run({"--help"}).exit_code, 0);
  EXPECT_TRUE(contains(run({"--help"}).out, "render"));
  EXPECT_EQ(run({"--version"}).out.substr(0, 5), "ajar ");
  const Outcome help = run({"render", "--help"});
  EXPECT_EQ(help.exit_code, 0);
  for (const char* option : {"--output",
                             "--integrator",
                             "--set",
                             "--time",
                             "--spp",
                             "--target-error",
                             "--resolution",
                             "--scale",
                             "--crop",
                             "--depth",
                             "--aov",
                             "--threads",
                             "--seed",
                             "--stats",
                             "--progress",
                             "--tone-map",
                             "--exposure",
                             "--checkpoint",
                             "--checkpoint-every",
                             "--resume",
                             "--output-every",
                             "--share"}) {
    EXPECT_TRUE(contains(help.out, option)) << option;
  }
}

TEST_F(Cli, HelpIsACommandToo) {
  EXPECT_EQ(run({"help"}).out, run({"--help"}).out);
  EXPECT_EQ(run({"help", "render"}).out, run({"render", "--help"}).out);
  const Outcome unknown = run({"help", "rendr"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_TRUE(contains(unknown.err, "did you mean \"render\"")) << unknown.err;
}

TEST_F(Cli, HelpDocumentsUnitsAndUseWithoutAViewer) {
  const Outcome help = run({"render", "--help"});
  const std::size_t preview = help.out.find("--preview HOST:PORT");
  ASSERT_NE(preview, std::string::npos) << help.out;
  EXPECT_TRUE(contains(help.out.substr(preview, 250), "--output-every")) << help.out;
  EXPECT_TRUE(contains(run({"list", "aovs"}).out, "Student's t with 3 degrees of freedom"));
}

TEST_F(Cli, WrongUsageEndsWithTwoAndHelp) {
  struct Case {
    std::vector<std::string> arguments;
    const char* message;
  };
  const std::vector<Case> cases{
      {{}, "--help"},
      {{"rendr", "x"}, "did you mean \"render\""},
      {{"render"}, "SCENE"},
      {{"render", "builtin:cornel"}, "did you mean \"cornell\""},
      {{"render", "builtin:cornell", "--integratr", "pt"}, "did you mean \"--integrator\""},
      {{"render", "builtin:cornell", "--chekpoint", "x"}, "did you mean \"--checkpoint\""},
      {{"render", "builtin:cornell", "--integrator", "ptt"}, "did you mean \"pt\""},
      {{"render", "builtin:cornell", "--set", "no-such=1"}, "unknown parameter"},
      {{"render", "builtin:pool", "--integrator", "pt", "--set", "edges=antialias"},
       "integrator pt: unknown parameter"},
      {{"render", "builtin:cornell", "--set", "alone"}, "KEY=VALUE"},
      {{"render", "builtin:cornell", "--time", "soon"}, "--time"},
      {{"render", "builtin:cornell", "--spp", "0"}, "--spp"},
      {{"render", "builtin:cornell", "--spp", "many"}, "--spp expects a whole number from 1"},
      {{"render", "builtin:cornell", "--spp", "1.5"},
       "whole number from 1 to 2147483648, not \"1.5"},
      {{"render", "builtin:cornell", "--samples", "4"}, "did you mean \"--spp\"?"},
      {{"render", "builtin:cornell", "--sampels", "4"}, "did you mean \"--spp\"?"},
      {{"render", "builtin:cornell", "--exposre", "1"}, "did you mean \"--exposure\"?"},
      {{"render", "builtin:cornell", "--exposure", "lots"},
       "a number of stops from -64 to 64, or auto"},
      {{"render", "builtin:cornell", "--target-error", "5"}, "did you mean 0.05, or 5%?"},
      {{"merge", "a", "--exposure", "lots", "-o", "x.pfm"}, "from -64 to 64, or auto"},
      {{"render", "builtin:cornell", "--target-error", "-1"}, "--target-error"},
      {{"render", "builtin:cornell", "--resolution", "0x5"}, "--resolution"},
      {{"render", "builtin:cornell", "--scale", "-1"}, "--scale"},
      {{"render", "builtin:cornell", "--crop", "0,0,0,0"}, "--crop"},
      {{"render", "builtin:cornell", "--depth", "5:2"}, "--depth"},
      {{"render", "builtin:cornell", "--aov", "albdo"}, "did you mean \"albedo\""},
      {{"render", "builtin:cornell", "--threads", "-1"}, "--threads"},
      {{"render", "builtin:cornell", "--progress", "loud"}, "progress"},
      {{"render", "builtin:cornell", "--tone-map", "film"}, "filmic"},
      {{"render", "builtin:cornell", "-o", "a.bmp2"}, ".exr"},
      {{"render", "builtin:cornell", "another"}, "another"},
      {{"list", "integratos"}, "did you mean \"integrators\""},
      {{"list", "integrators", "selectiv"}, "did you mean \"selective\""},
      {{"list", "materials", "dielectri"},
       "unknown material \"dielectri\"; did you mean \"dielectric\""},
      {{"list", "aovs", "albedo"}, "its entries have no parameters"},
  };
  for (const Case& c : cases) {
    const Outcome outcome = run(c.arguments);
    std::string line;
    for (const std::string& argument : c.arguments) line += argument + " ";
    EXPECT_EQ(outcome.exit_code, 2) << line << outcome.err;
    EXPECT_TRUE(contains(outcome.err, c.message)) << line << "says: " << outcome.err;
    EXPECT_EQ(outcome.out, "") << line;
  }
}

TEST_F(Cli, UnusableScenesEndWithThreeAndTheirPlace) {
  const fs::path nonsense = file("nonsense.pbrt", "this is not a scene\n");
  const fs::path broken =
      file("broken.pbrt", "Camera \"perspective\"\nWorldBegin\n  Shape \"sphere\n");
  for (const fs::path& scene : {nonsense, broken}) {
    const Outcome outcome = run({"render", scene.string(), "--spp", "1"});
    EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, scene.filename().string() + ":")) << outcome.err;
  }
  EXPECT_EQ(run({"info", nonsense.string()}).exit_code, 3);
  EXPECT_EQ(run({"convert", nonsense.string(), "out.pbrt"}).exit_code, 3);
}

TEST_F(Cli, FilesThatCannotBeReadOrWrittenEndWithFour) {
  EXPECT_EQ(run({"render", "absent.pbrt"}).exit_code, 4);
  EXPECT_EQ(run({"render", folder_.string()}).exit_code, 4);
  EXPECT_EQ(run({"info", "absent.pbrt"}).exit_code, 4);
  EXPECT_EQ(render({"-o", "no/such/folder/a.exr"}).exit_code, 4);
  EXPECT_EQ(render({"--stats", "no/such/folder/s.json"}).exit_code, 4);
  EXPECT_EQ(run({"convert", "builtin:cornell", "no/such/folder/a.pbrt"}).exit_code, 4);
}

TEST_F(Cli, ImpossibleOutputIsNoticedBeforeRendering) {
  const auto before = std::chrono::steady_clock::now();
  EXPECT_EQ(run({"render", "builtin:cornell", "--time", "60s", "-o", "no/such/a.exr"}).exit_code,
            4);
  EXPECT_LT(std::chrono::steady_clock::now() - before, 50s);
}

TEST_F(Cli, WritesAnExrAndAPngByDefault) {
  const Outcome outcome = render({"--spp", "4"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "cornell.exr\ncornell.png\n");
  const Image exr = read_image(file("cornell.exr").string());
  EXPECT_EQ(exr.width, 24);
  EXPECT_EQ(exr.height, 16);
  const std::vector<float> pixels = exr.rgb();
  double sum = 0.0;
  for (const float value : pixels) {
    ASSERT_TRUE(std::isfinite(value));
    ASSERT_GE(value, 0.F);
    sum += value;
  }
  EXPECT_GT(sum / static_cast<double>(pixels.size()), 0.01);
  EXPECT_EQ(read_image(file("cornell.png").string()).width, 24);
}

TEST_F(Cli, WritesEveryFormatAndAllLayers) {
  const Outcome outcome = render({"--spp", "4", "-o", "a.exr", "-o", "a.png", "-o", "a.pfm", "-o",
                                  "a.hdr", "-o", "a.jpg", "--aov", "all"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* name : {"a.exr", "a.png", "a.pfm", "a.hdr", "a.jpg"}) {
    EXPECT_EQ(read_image(file(name).string()).width, 24) << name;
  }
  const Image exr = read_image(file("a.exr").string());
  const json list = json::parse(run({"list", "aovs", "--json"}).out);
  for (const json& aov : list.at("aovs")) {
    if (aov.at("summary").get<std::string>().ends_with("not part of \"all\"")) continue;
    EXPECT_FALSE(exr.rgb(aov.at("name").get<std::string>()).empty()) << aov;
  }
  const std::vector<float> direct = exr.rgb("direct");
  const std::vector<float> indirect = exr.rgb("indirect");
  const std::vector<float> whole = exr.rgb();
  ASSERT_EQ(direct.size(), whole.size());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    EXPECT_EQ(whole[i], direct[i] + indirect[i]);
  }
}

TEST_F(Cli, RendersAnySetOfTechniquesAndShowsEach) {
  const Outcome outcome =
      render({"--spp", "4", "-o", "a.exr", "--aov", "techniques", "--integrator", "bdpt", "--set",
              "techniques=implicit,(1,2)*2,(2,1)", "--stats", "s.json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Image exr = read_image(file("a.exr").string());
  EXPECT_FALSE(exr.rgb("techniques.weighted.s1t2").empty());
  EXPECT_FALSE(exr.rgb("techniques.unweighted.s2t1").empty());
  EXPECT_TRUE(exr.rgb("techniques.weighted.s1t3").empty()) << "not in the set";
  const json written = statistics("s.json");
  double light = 0.0;
  double variance = 0.0;
  for (const json& technique : written.at("techniques")) {
    light += technique.at("light_share").get<double>();
    variance += technique.at("variance_share").get<double>();
  }
  EXPECT_NEAR(light, 1.0, 1e-9);
  EXPECT_NEAR(variance, 1.0, 1e-9);
  const Outcome wrong = render({"--set", "techniques=implict"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.err.find("did you mean \"implicit\"?"), std::string::npos) << wrong.err;
}

TEST_F(Cli, AllLayersAreThoseThatTheMethodCanMake) {
  const std::vector<std::string> chains = {"--spp",        "4",    "-o",    "a.exr",
                                           "--integrator", "mmlt", "--set", "bootstrap=2000"};
  std::vector<std::string> all = chains;
  all.insert(all.end(), {"--aov", "all"});
  EXPECT_EQ(render(all).exit_code, 0);
  std::vector<std::string> albedo = chains;
  albedo.insert(albedo.end(), {"--aov", "albedo"});
  EXPECT_EQ(render(albedo).exit_code, 2) << "chains alone do not see surfaces";
}

TEST_F(Cli, CropIsAPartOfTheWholePicture) {
  ASSERT_EQ(render({"--spp", "4", "-o", "whole.pfm"}).exit_code, 0);
  ASSERT_EQ(render({"--spp", "4", "-o", "part.pfm", "--crop", "4,2,20,10"}).exit_code, 0);
  const Image whole = read_image(file("whole.pfm").string());
  const Image part = read_image(file("part.pfm").string());
  EXPECT_EQ(part.width, 16);
  EXPECT_EQ(part.height, 8);
  // Other random numbers perhaps, but the same place: the means agree roughly.
  double a = 0.0;
  double b = 0.0;
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 16; ++x) {
      a += whole.at(x + 4, y + 2, 0);
      b += part.at(x, y, 0);
    }
  }
  EXPECT_NEAR(a, b, 0.25 * a);
}

TEST_F(Cli, SameSeedGivesTheSameBitsOnAnyNumberOfThreads) {
  ASSERT_EQ(render({"--spp", "8", "--threads", "1", "-o", "one.pfm"}).exit_code, 0);
  ASSERT_EQ(render({"--spp", "8", "--threads", "2", "-o", "two.pfm"}).exit_code, 0);
  ASSERT_EQ(render({"--spp", "8", "--threads", "5", "-o", "five.pfm"}).exit_code, 0);
  ASSERT_EQ(render({"--spp", "8", "--seed", "1", "-o", "other.pfm"}).exit_code, 0);
  EXPECT_EQ(read_text(file("one.pfm")), read_text(file("two.pfm")));
  EXPECT_EQ(read_text(file("one.pfm")), read_text(file("five.pfm")));
  EXPECT_NE(read_text(file("one.pfm")), read_text(file("other.pfm")));
}

TEST_F(Cli, StatisticsHaveTheKeysOfTheManual) {
  ASSERT_EQ(render({"--integrator", "pt", "--spp", "8", "--seed", "3", "--stats", "stats.json",
                    "--threads", "2"})
                .exit_code,
            0);
  const json stats = statistics();
  for (const char* key : {"integrator", "parameters", "seed", "threads", "resolution", "seconds",
                          "cpu_seconds", "rays", "rays_per_second", "samples", "mutations",
                          "mutations_per_second", "chain_cpu_seconds", "estimated_relative_error",
                          "peak_memory_bytes", "warnings", "discarded", "interrupted"}) {
    EXPECT_TRUE(stats.contains(key)) << key;
  }
  EXPECT_EQ(stats.at("integrator"), "pt");
  EXPECT_EQ(stats.at("seed"), 3);
  EXPECT_EQ(stats.at("threads"), 2);
  EXPECT_EQ(stats.at("samples"), 8 * 24 * 16);
  EXPECT_EQ(stats.at("resolution"), (json{24, 16}));
  EXPECT_EQ(stats.at("interrupted"), false);
  EXPECT_EQ(stats.at("warnings"), 0);
  EXPECT_GT(stats.at("rays").get<double>(), 8 * 24 * 16);
  EXPECT_GT(stats.at("estimated_relative_error").get<double>(), 0.0);
  EXPECT_GT(stats.at("peak_memory_bytes").get<double>(), 1e6);
}

TEST_F(Cli, OneSamplePerPixelWorks) {
  ASSERT_EQ(render({"--spp", "1", "--stats", "stats.json"}).exit_code, 0);
  EXPECT_EQ(statistics().at("samples"), 24 * 16);
  EXPECT_TRUE(statistics().at("estimated_relative_error").is_null());
}

TEST_F(Cli, TimeBudgetIsKept) {
  ASSERT_EQ(render({"--time", "1s", "--stats", "stats.json"}).exit_code, 0);
  EXPECT_EQ(statistics().at("stopped_by"), "time");
  EXPECT_LT(statistics().at("seconds").at("render").get<double>(), 30.0);
}

TEST_F(Cli, TargetErrorEndsTheRender) {
  ASSERT_EQ(render({"--target-error", "0.2", "--time", "60s", "--stats", "stats.json"}).exit_code,
            0);
  EXPECT_EQ(statistics().at("stopped_by"), "target error");
  EXPECT_LE(statistics().at("estimated_relative_error").get<double>(), 0.2);
}

TEST_F(Cli, DepthRangesAddUp) {
  ASSERT_EQ(render({"--spp", "16", "--depth", "1:2", "-o", "direct.exr"}).exit_code, 0);
  const Image image = read_image(file("direct.exr").string());
  for (const float value : image.rgb("indirect")) EXPECT_EQ(value, 0.F);
}

TEST_F(Cli, ControlCWritesAWholePictureAndEndsWith130) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const pid_t child = start({"render", "builtin:cornell", "--resolution", "64x48", "--time", "1h",
                               "--progress", "json", "--stats", "stats.json", "-o", "stopped.exr"});
    if (!wait_for(folder_ / ".stderr", "\"progress\",\"phase\":\"render\"")) {
      kill(child, SIGKILL);
      FAIL() << "no progress: " << finish(child).err;
    }
    const auto before = std::chrono::steady_clock::now();
    kill(child, signal);
    const Outcome outcome = finish(child);
    EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
    EXPECT_LT(std::chrono::steady_clock::now() - before, 50s);
    EXPECT_EQ(statistics().at("interrupted"), true);
    EXPECT_EQ(statistics().at("complete"), true);
    const Image image = read_image(file("stopped.exr").string());
    EXPECT_EQ(image.width, 64);
    double sum = 0.0;
    for (const float value : image.rgb()) sum += value;
    EXPECT_GT(sum, 0.0);
    // The next round must not take this one's messages for its own.
    fs::remove(folder_ / "stopped.exr");
    fs::remove(folder_ / ".stderr");
  }
}

TEST_F(Cli, ProgressComesInLinesOfJson) {
  const Outcome outcome =
      run({"render", "builtin:cornell", "--resolution", "8x8", "--spp", "4", "--progress", "json"});
  ASSERT_EQ(outcome.exit_code, 0);
  std::istringstream lines(outcome.err);
  std::string line;
  std::vector<std::string> events;
  while (std::getline(lines, line)) {
    if (line.starts_with('{')) events.push_back(json::parse(line).at("event"));
  }
  EXPECT_EQ(events.front(), "phase");
  EXPECT_EQ(std::count(events.begin(), events.end(), "done"), 1);
}

TEST_F(Cli, RefusesOptionsThatWouldChangeOrLoseAPicture) {
  for (const char* seed : {"18446744073709551616", "-1", "0x10", "", "7 "}) {
    EXPECT_EQ(render({"--seed", seed}).exit_code, 2) << seed;
  }
  for (const char* stops : {"nan", "inf", "-1e30"}) {
    EXPECT_EQ(render({"--exposure", stops}).exit_code, 2) << stops;
  }
  EXPECT_EQ(render({"--spp", "1", "-o", "a.exr", "--stats", "a.exr"}).exit_code, 2);
  EXPECT_EQ(render({"--spp", "1", "-o", "a.exr", "-o", "./a.exr"}).exit_code, 2);
  file("huge.pbrt",
       "Film \"image\" \"integer xresolution\" 65536 \"integer yresolution\" 65536\nCamera "
       "\"perspective\"\nWorldBegin\nShape \"sphere\"\nWorldEnd\n");
  EXPECT_EQ(run({"render", "huge.pbrt"}).exit_code, 3);
  EXPECT_EQ(render({"--time", ""}).exit_code, 2);
  ASSERT_EQ(run({"convert", "builtin:cornell", "own.pbrt"}).exit_code, 0);
  const std::string before = read_text(file("own.pbrt"));
  EXPECT_EQ(run({"convert", "own.pbrt", "own.pbrt"}).exit_code, 2);
  EXPECT_EQ(read_text(file("own.pbrt")), before);
}

TEST_F(Cli, NothingButResultsGoesToStdout) {
  EXPECT_EQ(run({"render", "builtin:cornell", "--resolution", "24x16", "--spp", "1", "-o", "a.pfm",
                 "--progress", "plain"})
                .out,
            "a.pfm\n");
}

TEST_F(Cli, InfoListsTheContentOfAScene) {
  const Outcome text = run({"info", "builtin:cornell"});
  ASSERT_EQ(text.exit_code, 0) << text.err;
  EXPECT_TRUE(contains(text.out, "triangles"));
  const Outcome outcome = run({"info", "builtin:cornell", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json info = json::parse(outcome.out);
  for (const char* key : {"scene", "counts", "lights", "materials", "media", "camera", "film",
                          "bounds", "memory", "warnings", "seconds"}) {
    EXPECT_TRUE(info.contains(key)) << key;
  }
  EXPECT_GT(info.at("counts").at("triangles").get<int>(), 10);
  file("patterns.pbrt",
       "WorldBegin\nTexture \"a\" \"color\" \"constant\" \"rgb value\" [1 0 0]\n"
       "Texture \"b\" \"color\" \"checkerboard\"\n"
       "Texture \"c\" \"color\" \"imagemap\" \"string filename\" \"absent.png\"\n"
       "Material \"matte\" \"rgb Kd\" [0.5 0.5 0.5]\nShape \"sphere\"\nWorldEnd\n");
  EXPECT_TRUE(contains(run({"info", "patterns.pbrt"}).out, "1 images, 1 patterns"));
  const json& memory = info.at("memory");
  EXPECT_GT(memory.at("available_bytes").get<double>(), 1e6);
  EXPECT_EQ(memory.at("needed_bytes").get<std::uint64_t>(),
            memory.at("scene_bytes").get<std::uint64_t>() +
                memory.at("film_bytes").get<std::uint64_t>() +
                memory.at("picture_bytes").get<std::uint64_t>());
  EXPECT_GE(info.at("lights").at("area").get<int>(), 1);
  EXPECT_EQ(info.at("camera").at("type"), "perspective");
  EXPECT_EQ(info.at("warnings"), 0);
}

TEST_F(Cli, ListNamesAllKinds) {
  const Outcome outcome = run({"list", "--json"});
  ASSERT_EQ(outcome.exit_code, 0);
  const json list = json::parse(outcome.out);
  const auto has = [&](const char* kind, const char* name) {
    return std::any_of(list.at(kind).begin(), list.at(kind).end(),
                       [&](const json& entry) { return entry.at("name") == name; });
  };
  EXPECT_TRUE(has("integrators", "pt"));
  EXPECT_TRUE(has("scenes", "builtin:cornell"));
  EXPECT_TRUE(has("materials", "dielectric"));
  EXPECT_TRUE(has("aovs", "albedo"));
  for (const json& integrator : list.at("integrators")) {
    for (const json& parameter : integrator.at("parameters")) {
      EXPECT_TRUE(parameter.contains("default") && parameter.contains("help")) << parameter;
      EXPECT_TRUE(parameter.at("expert").is_boolean()) << parameter;
    }
  }
}

TEST_F(Cli, ListShowsParametersOfOneMaterial) {
  const std::string text = run({"list", "materials", "dielectric"}).out;
  EXPECT_TRUE(contains(text, "  eta=1.5  [number|texture, between 0 and 20]")) << text;
  const json material =
      json::parse(run({"list", "materials", "dielectric", "--json"}).out).at("materials").at(0);
  const json& parameters = material.at("parameters");
  const auto eta = std::find_if(parameters.begin(), parameters.end(),
                                [](const json& spec) { return spec.at("name") == "eta"; });
  ASSERT_NE(eta, parameters.end()) << material;
  EXPECT_EQ(eta->at("maximum"), 20.0);
  EXPECT_EQ(eta->at("textured"), true);
}

TEST_F(Cli, ListAcceptsUniqueNames) {
  EXPECT_EQ(run({"list", "mlt"}).out, run({"list", "integrators", "mlt"}).out);
  EXPECT_EQ(run({"list", "dielectric", "--json"}).out,
            run({"list", "materials", "dielectric", "--json"}).out);
  const Outcome several = run({"list", "mix"});
  EXPECT_EQ(several.exit_code, 2);
  EXPECT_TRUE(contains(several.err, "ajar list materials mix")) << several.err;
  EXPECT_TRUE(contains(run({"list", "mtl"}).err, "did you mean \"mlt\""));
  EXPECT_EQ(run({"help", "list", "mlt"}).exit_code, 2);
}

TEST_F(Cli, ListShowsBoundsInFull) {
  const std::string text = run({"list", "integrators", "mlt"}).out;
  EXPECT_TRUE(
      contains(text, "bootstrap=100000 samples  [whole number, between 1000 and 100000000]"))
      << text;
}

TEST_F(Cli, ListShowsConditionsOfTextureParameters) {
  const std::string text = run({"list", "textures", "image"}).out;
  EXPECT_TRUE(contains(text, "  scale_u=1  [number]  with mapping=uv\n")) << text;
}

TEST_F(Cli, ListNamesIntegratorsWithALineEach) {
  const std::string text = run({"list", "integrators"}).out;
  const json list = json::parse(run({"list", "integrators", "--json"}).out).at("integrators");
  for (const json& integrator : list) {
    EXPECT_TRUE(contains(text, "  " + integrator.at("name").get<std::string>() + " ")) << text;
  }
  // A heading, and how to see parameters after an empty line.
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'),
            static_cast<std::ptrdiff_t>(list.size() + 3))
      << text;
  EXPECT_TRUE(contains(text, "ajar list integrators NAME")) << text;
}

TEST_F(Cli, ListShowsParametersOfOneIntegratorBasicOnesFirst) {
  const json list = json::parse(run({"list", "integrators", "--json"}).out).at("integrators");
  for (const json& integrator : list) {
    const std::string name = integrator.at("name");
    const std::string text = run({"list", "integrators", name}).out;
    const std::size_t heading = text.find("\nexpert parameters:\n");
    ASSERT_NE(heading, std::string::npos) << text;
    int basic = 0;
    for (const json& parameter : integrator.at("parameters")) {
      const bool expert = parameter.at("expert");
      basic += expert ? 0 : 1;
      const std::size_t at = text.find("  " + parameter.at("name").get<std::string>() + "=");
      EXPECT_NE(at, std::string::npos) << parameter << text;
      EXPECT_EQ(at > heading, expert) << parameter << text;
    }
    EXPECT_TRUE(basic >= 3 && basic <= 12) << name << " has " << basic;
    const json alone = json::parse(run({"list", "integrators", name, "--json"}).out);
    EXPECT_EQ(alone.at("integrators"), json::array({integrator}));
  }
}

TEST_F(Cli, EveryBuiltInSceneRendersWithoutAWarning) {
  const json list = json::parse(run({"list", "scenes", "--json"}).out);
  ASSERT_FALSE(list.at("scenes").empty());
  for (const json& scene : list.at("scenes")) {
    EXPECT_NE(scene.at("summary"), "") << scene;
    const Outcome outcome = run({"render", scene.at("name"), "--resolution", "16x12", "--spp", "4",
                                 "--stats", "stats.json", "-o", "a.pfm"});
    EXPECT_EQ(outcome.exit_code, 0) << scene << outcome.err;
    EXPECT_EQ(statistics().at("warnings"), 0) << scene << outcome.err;
  }
}

TEST_F(Cli, AConvertedSceneRendersToTheSamePicture) {
  const Outcome converted = run({"convert", "builtin:cornell", "copy.pbrt"});
  ASSERT_EQ(converted.exit_code, 0) << converted.err;
  ASSERT_EQ(render({"--integrator", "pt", "--spp", "16", "-o", "original.pfm"}).exit_code, 0);
  const Outcome outcome = run({"render", "copy.pbrt", "--resolution", "24x16", "--spp", "16",
                               "--integrator", "pt", "--progress", "none", "-o", "copy.pfm"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::vector<float> original = read_image(file("original.pfm").string()).rgb();
  const std::vector<float> copy = read_image(file("copy.pfm").string()).rgb();
  ASSERT_EQ(original.size(), copy.size());
  double difference = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < copy.size(); ++i) {
    difference += std::abs(original[i] - copy[i]);
    sum += original[i];
  }
  EXPECT_LT(difference, 0.01 * sum);
}

TEST_F(Cli, WarningsAreCountedAndRenderingGoesOn) {
  const fs::path scene = file("odd.pbrt",
                              "Camera \"perspective\" \"float fov\" [40] \"float no_such\" [1]\n"
                              "WorldBegin\n"
                              "LightSource \"point\" \"point from\" [0 1 0]\n"
                              "Shape \"sphere\" \"float radius\" [1]\n"
                              "WorldEnd\n");
  const Outcome outcome = run({"render", scene.string(), "--resolution", "8x8", "--spp", "1",
                               "--stats", "stats.json", "-o", "a.pfm"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_GE(statistics().at("warnings").get<int>(), 1);
  EXPECT_TRUE(contains(outcome.err, "odd.pbrt:1:")) << outcome.err;
}

TEST_F(Cli, APictureLargerThanTheMemoryIsRefused) {
  const Outcome outcome = run(
      {"render", "builtin:cornell", "--resolution", "65536x65536", "--spp", "4", "-o", "a.exr"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(contains(outcome.err, "memory")) << outcome.err;
}

TEST_F(Cli, APictureLargerThanItsMemoryLimitIsRefusedBeforeTheSceneIsBuilt) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers need more address space than the limit leaves";
#endif
  rlimit before{};
  getrlimit(RLIMIT_AS, &before);
  rlimit small = before;
  small.rlim_cur = 1'500'000'000;
  setrlimit(RLIMIT_AS, &small);
  const pid_t child = start({"render", "builtin:cornell", "--resolution", "3000x3000", "--spp", "4",
                             "--progress", "json", "-o", "a.exr"});
  setrlimit(RLIMIT_AS, &before);
  const Outcome outcome = finish(child);
  EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "film 1.7 GB, writing pictures ")) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "free here")) << outcome.err;
  EXPECT_FALSE(contains(outcome.err, "prepare")) << outcome.err;
}

}  // namespace
}  // namespace ajar
