#include <cstring>

#include "cli/cli_fixture.h"

namespace ajar {
namespace {

/// A sphere that glows as brightly as `$light`, in all of a picture of `$width` by 8 pixels.
constexpr const char* kGlow = R"(<scene version="3.0.0">
  <default name="light" value="2"/>
  <integrator type="path"/>
  <sensor type="perspective">
    <film type="hdrfilm">
      <integer name="width" value="$width"/><integer name="height" value="8"/>
    </film>
  </sensor>
  <shape type="sphere">
    <float name="radius" value="10"/>
    <boolean name="flip_normals" value="true"/>
    <emitter type="area"><rgb name="radiance" value="$light"/></emitter>
  </shape>
</scene>
)";

class Definitions : public Cli {
 protected:
  Outcome render_glow(std::vector<std::string> more) {
    file("glow.xml", kGlow);
    std::vector<std::string> arguments{"render", "glow.xml", "--spp",    "4",       "--progress",
                                       "none",   "-o",       "glow.pfm", "--stats", "stats.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  /// The first value of the picture.
  float brightness() const {
    const std::string picture = read_text(folder_ / "glow.pfm");
    float value = 0.F;
    if (picture.size() >= sizeof value) {
      std::memcpy(&value, picture.data() + picture.size() - sizeof value, sizeof value);
    }
    return value;
  }
};

TEST_F(Definitions, GiveTheParametersOfASceneTheirValue) {
  ASSERT_EQ(render_glow({"-Dwidth=6"}).exit_code, 0);
  EXPECT_EQ(statistics().at("resolution"), json({6, 8}));
  EXPECT_NEAR(brightness(), 2.F, 1e-4F);
  ASSERT_EQ(render_glow({"-D", "width=5", "--define", "light=3"}).exit_code, 0);
  EXPECT_EQ(statistics().at("resolution"), json({5, 8}));
  EXPECT_NEAR(brightness(), 3.F, 1e-4F);
}

TEST_F(Definitions, AreKeptInCheckpoints) {
  ASSERT_EQ(render_glow({"-Dwidth=6", "-Dlight=3", "--checkpoint", "glow.checkpoint"}).exit_code,
            0);
  const Outcome resumed = run({"resume", "glow.checkpoint", "--spp", "8", "--progress", "none"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_NEAR(brightness(), 3.F, 1e-4F);
  const Outcome other =
      render_glow({"-Dwidth=6", "--checkpoint", "glow.checkpoint", "--resume", "glow.checkpoint"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_TRUE(contains(other.err, "the scene has changed since")) << other.err;
}

TEST_F(Definitions, AreForInfoAndConvertToo) {
  file("glow.xml", kGlow);
  const Outcome info = run({"info", "glow.xml", "--json", "-Dwidth=7"});
  ASSERT_EQ(info.exit_code, 0) << info.err;
  EXPECT_EQ(json::parse(info.out).at("film").at("resolution"), json({7, 8}));
  ASSERT_EQ(run({"convert", "glow.xml", "glow.pbrt", "-Dwidth=7"}).exit_code, 0);
  EXPECT_EQ(json::parse(run({"info", "glow.pbrt", "--json"}).out).at("film").at("resolution"),
            json({7, 8}));
}

TEST_F(Definitions, UnknownOnesAreErrors) {
  const Outcome missing = render_glow({});
  EXPECT_EQ(missing.exit_code, 3);
  EXPECT_TRUE(contains(missing.err, "unknown parameter \"width\"")) << missing.err;
  const Outcome unknown = render_glow({"-Dwidth=6", "-Dlihgt=4"});
  EXPECT_EQ(unknown.exit_code, 3);
  EXPECT_TRUE(contains(unknown.err,
                       "glow.xml:1:1: -Dlihgt: unknown parameter \"lihgt\"; did you "
                       "mean \"light\"?"))
      << unknown.err;
  EXPECT_EQ(render_glow({"-Dwidth"}).exit_code, 2) << "no value";
  const Outcome pbrt = render({"-Dwidth=6"});
  EXPECT_EQ(pbrt.exit_code, 2);
  EXPECT_TRUE(contains(pbrt.err, "-Dwidth: scenes of the format pbrt have no parameters to define"))
      << pbrt.err;
}

}  // namespace
}  // namespace ajar
