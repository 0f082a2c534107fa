#include "scene/light/light.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/light/light_test_support.h"
#include "scene/light/spot_falloff.h"

/// Claims that hold for all kinds of lights, and closed forms for each.
namespace ajar {
namespace {

using namespace testing;

const std::vector<Vec3> kReferences{{0.3F, -0.2F, -1.F}, {-0.7F, 0.4F, 0.5F}, {0.F, 0.F, -2.F}};

TEST(AreaLight, WeightsAndDensitiesAgree) {
  const Quad quad({-1, -1, 1}, {0, 2, 0}, {2, 0, 0});  // emits toward −z
  const TextureList textures = one_ramp();
  for (const bool two_sided : {false, true}) {
    const auto light = make_surface_light(area_light({2, 3, 4}, two_sided, 0), quad, textures);
    check_emission(*light);
    check_connection(*light, {{0.3F, -0.2F, -1.F}, {-0.7F, 0.4F, 0.5F}, {0.2F, 0.1F, 2.F}});
  }
}

TEST(AreaLight, EmitsOnTheNormalSideOnly) {
  const Quad quad({-1, -1, 1}, {0, 2, 0}, {2, 0, 0});
  const auto one = make_surface_light(area_light({1, 1, 1}), quad, {});
  const auto two = make_surface_light(area_light({1, 1, 1}, true), quad, {});
  const EndpointPoint point{quad.at({0.5F, 0.5F}), Vec3(0.F)};
  EXPECT_TRUE(one->emitted(point, {0, 0, 1}).is_black());
  EXPECT_EQ(one->emitted(point, {0, 0, -1}), Spectrum(1.F));
  EXPECT_EQ(two->emitted(point, {0, 0, 1}), Spectrum(1.F));
  EXPECT_EQ(one->emission_pdf(point, {0, 0, 1}).departure.value(), 0.F);
  EXPECT_FALSE(one->sample_connection({0, 0, 2}, {0.5F, {0.5F, 0.5F}}));
  EXPECT_TRUE(two->sample_connection({0, 0, 2}, {0.5F, {0.5F, 0.5F}}));
}

TEST(AreaLight, DeparturesFollowTheirDensity) {
  const Quad quad({-1, -1, 1}, {0, 2, 0.5F}, {2, 0, 0});
  for (const bool two_sided : {false, true}) {
    const auto light = make_surface_light(area_light({1, 1, 1}, two_sided), quad, {});
    check_departures(*light, cone_chart(quad.normal()));
  }
}

TEST(AreaLight, PositionsFollowTheirDensity) {
  const Quad quad({-1, -1, 1}, {0, 2, 0}, {2, 0, 0});
  const auto light = make_surface_light(area_light({1, 1, 1}), quad, {});
  Rng rng(3);
  const Chart<SurfacePoint> chart{[&](const Vec2& s) { return quad.at(s); },
                                  [&](const Vec2&) { return static_cast<double>(quad.area()); },
                                  [](const SurfacePoint& p) { return p.uv; }};
  check_density<SurfacePoint>(
      chart,
      [&]() -> std::optional<SurfacePoint> {
        const auto sample = light->sample_emission(emission_uniforms(rng));
        if (!sample) return std::nullopt;
        return sample->point.surface;
      },
      [&](const SurfacePoint& p) {
        return static_cast<double>(
            light->emission_pdf({p, Vec3(0.F)}, {0, 0, -1}).position.value());
      });
  check_density<SurfacePoint>(
      chart,
      [&]() -> std::optional<SurfacePoint> {
        const auto sample = light->sample_connection({0, 0, 0}, connection_uniforms(rng));
        if (!sample) return std::nullopt;
        return sample->point.surface;
      },
      [&](const SurfacePoint& p) {
        return static_cast<double>(light->connection_pdf({0, 0, 0}, {p, Vec3(0.F)}).value());
      });
}

TEST(AreaLight, IrradianceUnderARectangleIsTheClosedForm) {
  // Rectangle of 2 × 1 at height 1 above the origin, corner above the origin.
  const Quad quad({0, 0, 1}, {0, 1, 0}, {2, 0, 0});
  const auto light = make_surface_light(area_light({3, 3, 3}), quad, {});
  const double a = 2.0;
  const double b = 1.0;
  const double factor = (a / std::sqrt(1 + a * a) * std::atan(b / std::sqrt(1 + a * a)) +
                         b / std::sqrt(1 + b * b) * std::atan(a / std::sqrt(1 + b * b))) /
                        (2.0 * M_PI);
  expect_mean(connected_irradiance(*light, {0, 0, 0}, {0, 0, 1}), 3.0 * M_PI * factor);
}

TEST(AreaLight, IrradianceFromASphereIsTheClosedForm) {
  const Ball ball({0.5F, 0, 3}, 0.8F);
  const auto light = make_surface_light(area_light({2, 2, 2}), ball, {});
  const Vec3 normal = normalize(Vec3(0.5F, 0, 3));
  const double expected = M_PI * 2.0 * 0.64 / 9.25;
  expect_mean(connected_irradiance(*light, {0, 0, 0}, normal), expected);
  expect_mean(emitted_irradiance(*light, small_patch({0, 0, 0}, normal, 0.5F), 4000000), expected,
              0.1, 0.005);
}

TEST(AreaLight, PowerIsTheEmittedFlux) {
  const Quad quad({-1, -1, 1}, {0, 2, 0}, {2, 0, 0});
  const TextureList textures = one_ramp();
  for (const bool two_sided : {false, true}) {
    const auto plain = make_surface_light(area_light({2, 3, 4}, two_sided), quad, textures);
    expect_mean(emitted_power(*plain), M_PI * 4.0 * 3.0 * (two_sided ? 2.0 : 1.0), 0.02, 1e-3);
    EXPECT_NEAR(plain->power().average(), M_PI * 4.0 * 3.0 * (two_sided ? 2.0 : 1.0), 1e-3);
    const auto textured = make_surface_light(area_light({2, 3, 4}, two_sided, 0), quad, textures);
    expect_mean(emitted_power(*textured), textured->power().average(), 0.02, 0.02);
  }
}

/// Bright in a spot that no regular pattern of points is sure to meet.
class SpeckTexture final : public Texture {
 public:
  Spectrum eval(const SurfacePoint& at) const override {
    return Spectrum(length(Vec3(at.uv.x - 0.123F, at.uv.y - 0.456F, 0.F)) < 1e-3F ? 1.F : 0.F);
  }
};
TEST(AreaLight, PowerIsPositiveIfAnyTexelEmits) {
  const Quad quad({-1, -1, 1}, {0, 2, 0}, {2, 0, 0});
  TextureList textures;
  textures.push_back(std::make_unique<SpeckTexture>());
  EXPECT_GT(make_surface_light(area_light({1, 1, 1}, false, 0), quad, textures)->power().min(),
            0.F);
}

TEST(AreaLight, ReferencesOnTheLightGiveNothingAndNoNan) {
  const Quad quad({-1, -1, 1}, {0, 2, 0}, {2, 0, 0});
  const auto light = make_surface_light(area_light({1, 1, 1}, true), quad, {});
  Rng rng(4);
  for (int i = 0; i < 1000; ++i) {
    const ConnectionUniforms u = connection_uniforms(rng);
    const auto sample = light->sample_connection(quad.at(u.position).p, u);
    EXPECT_FALSE(sample);
    const auto other = light->sample_connection({0.1F, 0.2F, 1.F}, u);
    if (other) {
      EXPECT_TRUE(other->weight.is_finite());
    }
  }
}

TEST(PointLight, WeightsDensitiesAndClosedForms) {
  const auto light = light_of(point_node({4, 4, 4}), translation({0, 0, 2}));
  check_emission(*light);
  check_connection(*light, kReferences);
  check_departures(*light, cone_chart({1, 2, 3}));
  expect_mean(emitted_power(*light), 16.0 * M_PI, 0.02, 1e-3);
  EXPECT_NEAR(light->power().average(), 16.0 * M_PI, 1e-4);
  expect_mean(connected_irradiance(*light, {0, 0, 0}, {0, 0, 1}), 1.0);
  expect_mean(emitted_irradiance(*light, small_patch({0, 0, 0}, {0, 0, 1}, 0.2F), 4000000), 1.0,
              0.1, 0.01);
  EXPECT_FALSE(light->sample_connection({0, 0, 2}, {0.5F, {0.5F, 0.5F}}));
  EXPECT_TRUE(light->discrete_position());
  EXPECT_FALSE(light->at_infinity());
}

TEST(SpotLight, WeightsDensitiesAndClosedForms) {
  const desc::Node spot = spot_node({2, 3, 4}, 40, 15);
  const auto light = light_of(spot, translation({0, 0, -2}));
  check_emission(*light);
  check_connection(*light, {{0, 0, 1}, {0.5F, 0.5F, 0.F}, {-1.F, 0.3F, 0.F}});
  check_departures(*light, cone_chart({0, 0, 1}, 1.0 - std::cos(M_PI * 45 / 180)), 24, 8);
  const double inner = 1.0 - std::cos(M_PI * 15 / 180);
  const double edge = 1.0 - std::cos(M_PI * 40 / 180);
  const double power = 2.0 * M_PI * 3.0 * (inner + (edge - inner) / 5.0);
  expect_mean(emitted_power(*light), power, 0.02, 1e-3);
  EXPECT_NEAR(light->power().average(), power, 1e-4 * power);
  // On the axis, E = I / d².
  expect_mean(connected_irradiance(*light, {0, 0, 0}, {0, 0, -1}), 0.75);
  expect_mean(emitted_irradiance(*light, small_patch({0, 0, 0}, {0, 0, -1}, 0.2F), 1000000), 0.75,
              0.1, 0.01);
}

TEST(SpotLight, FadesWithTheFourthPowerOfTheCosineDifference) {
  const auto light = light_of(spot_node({1, 1, 1}, 40, 15), Mat4());
  const EndpointPoint point = EndpointPoint::at(Vec3(0.F));
  const auto at = [&](double degrees) {
    const double a = degrees * M_PI / 180;
    return light->emitted(
        point, {static_cast<float>(std::sin(a)), 0.F, static_cast<float>(std::cos(a))})[0];
  };
  const auto cosine = [](double degrees) { return std::cos(degrees * M_PI / 180); };
  EXPECT_EQ(at(10), 1.F);
  EXPECT_NEAR(at(30), std::pow((cosine(30) - cosine(40)) / (cosine(15) - cosine(40)), 4.0), 1e-5);
  EXPECT_EQ(at(41), 0.F);
  EXPECT_EQ(at(179), 0.F);
}

/// A cone of 40 degrees that fades from 15 on, by a curve with this value at δ and this integral.
void check_fading(const std::string& name, double (*at)(double), double integral) {
  desc::Node spot = spot_node({2, 2, 2}, 40, 15);
  spot.set("falloff", name);
  const auto light = light_of(spot, Mat4());
  check_emission(*light);
  check_departures(*light, cone_chart({0, 0, 1}, 1.0 - std::cos(M_PI * 45 / 180)), 24, 8);
  const auto cosine = [](double degrees) { return std::cos(degrees * M_PI / 180); };
  const double power =
      2.0 * M_PI * 2.0 * ((1.0 - cosine(15)) + integral * (cosine(15) - cosine(40)));
  expect_mean(emitted_power(*light), power, 0.02, 1e-3);
  EXPECT_NEAR(light->power().average(), power, 1e-4 * power);
  const double delta = (cosine(30) - cosine(40)) / (cosine(15) - cosine(40));
  const double a = M_PI * 30 / 180;
  const Spectrum emitted =
      light->emitted(EndpointPoint::at(Vec3(0.F)),
                     {static_cast<float>(std::sin(a)), 0.F, static_cast<float>(std::cos(a))});
  EXPECT_NEAR(emitted[0], 2.0 * at(delta), 1e-5);
}

TEST(SpotLight, MayFadeByASmoothStep) {
  check_fading(
      "smoothstep", [](double delta) { return delta * delta * (3.0 - 2.0 * delta); }, 0.5);
}

TEST(SpotLight, MayFadeByASquare) {
  check_fading(
      "quadratic", [](double delta) { return delta * delta; }, 1.0 / 3.0);
}

TEST(SpotLight, MayFadeWithTheAngle) {
  desc::Node spot = spot_node({2, 2, 2}, 40, 15);
  spot.set("falloff", "angle");
  const auto light = light_of(spot, Mat4());
  check_emission(*light);
  check_departures(*light, cone_chart({0, 0, 1}, 1.0 - std::cos(M_PI * 45 / 180)), 24, 8);
  const auto radians = [](double degrees) { return degrees * M_PI / 180; };
  // ∫ (θe − θ) sin θ dθ / (θe − θi), from θi to θe.
  const double width = radians(25);
  const double fading =
      std::cos(radians(15)) - (std::sin(radians(40)) - std::sin(radians(15))) / width;
  const double power = 2.0 * M_PI * 2.0 * (1.0 - std::cos(radians(15)) + fading);
  expect_mean(emitted_power(*light), power, 0.02, 1e-3);
  EXPECT_NEAR(light->power().average(), power, 1e-4 * power);
  const Spectrum emitted = light->emitted(
      EndpointPoint::at(Vec3(0.F)),
      {static_cast<float>(std::sin(radians(30))), 0.F, static_cast<float>(std::cos(radians(30)))});
  EXPECT_NEAR(emitted[0], 2.0 * 10.0 / 25.0, 1e-5);
}

TEST(SpotFalloff, SharesAreInverted) {
  for (const char* name : {"quartic", "smoothstep", "quadratic", "angle"}) {
    for (const float edge : {1e-6F, 0.2F, 2.F}) {
      const SpotFalloff falloff(name, 0.3F * edge, edge);
      EXPECT_NEAR(falloff.at(0.3F * edge), 1.F, 1e-5F) << name;
      EXPECT_NEAR(falloff.at(edge), 0.F, 1e-5F) << name;
      for (const float share : {0.1F, 0.5F, 0.9F}) {
        EXPECT_NEAR(falloff.share(falloff.with_share(share)), share, 1e-4F) << name << " " << edge;
      }
      // By the midpoint rule.
      double sum = 0.0;
      constexpr int kSteps = 4000;
      for (int i = 0; i < kSteps; ++i) {
        const float a = edge * (0.3F + 0.7F * (static_cast<float>(i) + 0.5F) / kSteps);
        sum += static_cast<double>(falloff.at(a)) * 0.7 * static_cast<double>(edge) / kSteps;
      }
      EXPECT_NEAR(static_cast<double>(falloff.integral()) / sum, 1.0, 1e-3) << name << " " << edge;
    }
  }
}

TEST(SpotLight, ExtremeConesStayFinite) {
  for (const auto& [cone, start] : {std::pair{0.F, 0.F},
                                    {1e-3F, 0.F},
                                    {0.01F, 0.01F},
                                    {30.F, 30.F},
                                    {180.F, 0.F},
                                    {30.F, 60.F}}) {
    for (const char* falloff : {"quartic", "angle"}) {
      desc::Node spot = spot_node({1, 1, 1}, cone, start);
      spot.set("falloff", falloff);
      const auto light = light_of(spot, Mat4());
      if (cone == 0.F) {
        EXPECT_FALSE(light->sample_emission({0.5F, {0.5F, 0.5F}, {0.5F, 0.5F}}));
        continue;
      }
      // Directions in float cannot resolve the rim of the narrowest cones.
      check_emission(*light, 5000, 50);
      expect_mean(emitted_power(*light, 20000), light->power().average(), 0.1, 0.01);
    }
  }
}

TEST(SpotLight, StretchedAndMirroredSpacesKeepTheirFlux) {
  Mat4 to_world;
  to_world.setScale(Vec3d(-1.0, 1.7, 0.6));
  to_world = to_world * rotation({1, 2, 0.5F}, 1.1);
  const auto light = light_of(spot_node({1, 1, 1}, 40, 15), to_world);
  check_emission(*light);
  check_departures(*light, cone_chart(transform_vector(to_world, {0, 0, 1})), 48, 12);
}

TEST(DistantLight, ShinesAlongMinusZWithTheGivenIrradiance) {
  const Mat4 to_world = rotation({1, 0.3F, 0}, 0.7);
  const auto light = light_of(distant_node({5, 5, 5}), to_world);
  const Vec3 toward = transform_vector(to_world, {0, 0, 1});
  check_emission(*light);
  check_connection(*light, kReferences);
  const auto seen = light->sample_connection({0, 0, 0}, {0.5F, {0.5F, 0.5F}});
  ASSERT_TRUE(seen);
  EXPECT_LT(length(seen->w - toward), 1e-5F);
  EXPECT_TRUE(std::isinf(seen->distance));
  const auto ray = light->sample_emission({0.5F, {0.2F, 0.9F}, {0.5F, 0.5F}});
  EXPECT_LT(length(ray->w + toward), 1e-5F);
  EXPECT_GT(length(ray->origin - kBounds.center), kBounds.radius);
  expect_mean(connected_irradiance(*light, {0, 0, 0}, toward), 5.0);
  expect_mean(emitted_irradiance(*light, small_patch({0.3F, 0, 0}, toward, 1.F), 1000000), 5.0,
              0.1);
  EXPECT_NEAR(light->power().average(), 5.0 * M_PI * 16.0, 1e-2);
  expect_disk_is_uniform(*light);
}

TEST(ConstantEnvironment, WeightsDensitiesAndClosedForms) {
  const auto light = light_of(environment_node({2, 2, 2}), Mat4());
  check_emission(*light);
  check_connection(*light, kReferences);
  expect_mean(connected_irradiance(*light, {0, 0, 0}, {0, 0.6F, 0.8F}), 2.0 * M_PI);
  expect_mean(emitted_irradiance(*light, small_patch({0.3F, 0, 0}, {0, 0.6F, 0.8F}, 1.F), 2000000),
              2.0 * M_PI, 0.1);
  expect_disk_is_uniform(*light);
  EXPECT_NEAR(light->power().average(), 2.0 * 4.0 * M_PI * M_PI * 16.0, 0.1);
  expect_mean(emitted_power(*light), light->power().average());
  Rng rng(5);
  check_density<Vec3>(
      cone_chart({0, 0, 1}),
      [&]() -> std::optional<Vec3> {
        return light->sample_connection({0, 0, 0}, connection_uniforms(rng))->w;
      },
      [&](const Vec3& w) {
        return static_cast<double>(
            light->connection_pdf({0, 0, 0}, light->at_direction(w)).value());
      });
  EXPECT_TRUE(light->at_infinity());
  EXPECT_FALSE(light->discrete_position());
}

TEST(Lights, BlackOnesEmitNothing) {
  const Quad quad({-1, -1, 1}, {0, 2, 0}, {2, 0, 0});
  LightList lights;
  lights.push_back(make_surface_light(area_light({0, 0, 0}), quad, {}));
  lights.push_back(light_of(point_node({0, 0, 0}), Mat4()));
  lights.push_back(light_of(spot_node({0, 0, 0}, 30, 20), Mat4()));
  lights.push_back(light_of(distant_node({0, 0, 0}), Mat4()));
  lights.push_back(light_of(environment_node({0, 0, 0}), Mat4()));
  for (const auto& light : lights) {
    EXPECT_TRUE(light->power().is_black());
    EXPECT_FALSE(light->sample_emission({0.5F, {0.5F, 0.4F}, {0.3F, 0.6F}}));
    EXPECT_FALSE(light->sample_connection({0.1F, 0.2F, 0.3F}, {0.5F, {0.5F, 0.4F}}));
  }
}

TEST(Lights, EmissionAndConnectionGiveTheSameIrradiance) {
  const Quad quad({-1, -1, 1.5F}, {0, 2, 0}, {2, 0, 0});
  const TextureList textures = one_ramp();
  LightList lights;
  lights.push_back(make_surface_light(area_light({2, 3, 4}, false, 0), quad, textures));
  lights.push_back(light_of(spot_node({1, 1, 1}, 50, 5), aimed({0.5F, 0, 2}, {0, 0, 0})));
  lights.push_back(light_of(point_node({1, 1, 1}), translation({0, 0.5F, 1})));
  const Quad patch({-0.6F, -0.5F, 0}, {1.2F, 0, 0.1F}, {0, 1, 0});
  for (const auto& light : lights) expect_patch_agrees(*light, patch);
}

TEST(Lights, SingularTransformsAreWarnedOf) {
  Mat4 flat;
  flat.setScale(Vec3d(1, 1, 0));
  Warnings warnings;
  desc::Light node;
  node.to_world = flat;
  node.node = desc::light_node("spot");
  const auto light = make_light(node, kBounds, warnings);
  EXPECT_EQ(warnings.count(), 1U);
  check_emission(*light, 1000);
}

TEST(Lights, ThoseTooFarAwayAreErrorsUnlessTheyAreAtInfinity) {
  Mat4 far_away;
  far_away[3][2] = 1e18;
  const auto fails = [&](const auto& node) {
    Warnings warnings;
    desc::Light light;
    light.to_world = far_away;
    light.node = node;
    try {
      make_light(light, kBounds, warnings);
      return false;
    } catch (const SceneError&) {
      return true;
    }
  };
  EXPECT_TRUE(fails(desc::light_node("point")));
  EXPECT_TRUE(fails(desc::light_node("spot")));
  EXPECT_TRUE(fails(desc::light_node("goniometric")));
  EXPECT_TRUE(fails(desc::light_node("projection")));
  EXPECT_FALSE(fails(desc::light_node("distant")));
  EXPECT_FALSE(fails(desc::light_node("environment")));
}

/// Directions are worked out in single precision, whose third powers end at 10¹².
TEST(Lights, ExtremeScalesAreWarnedOfAndStayFinite) {
  for (const double size : {1e-30, 1e-13, 1e13, 1e30}) {
    Mat4 scale;
    scale.setScale(size);
    Warnings warnings;
    desc::Light node;
    node.to_world = scale;
    node.node = desc::light_node("spot");
    const auto light = make_light(node, kBounds, warnings);
    EXPECT_EQ(warnings.count(), 1U) << size;
    check_emission(*light, 1000);
  }
}

TEST(Lights, WithoutAModelAreLocatedErrors) {
  Warnings warnings;
  desc::Light light;
  light.where = {std::make_shared<const std::string>("a.pbrt"), 7, 2};
  try {
    make_light(light, kBounds, warnings);
    FAIL();
  } catch (const SceneError& error) {
    EXPECT_STREQ(error.what(), "a.pbrt:7:2: this light has no model");
  }
}

}  // namespace
}  // namespace ajar
