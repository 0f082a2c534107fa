#include "scene/camera/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/error.h"
#include "scene/light/light.h"
#include "scene/testing/emitters.h"
#include "scene/testing/endpoint_checks.h"
#include "scene/testing/transforms.h"

namespace ajar {
namespace {

using namespace testing;

template <typename Node>
std::unique_ptr<Camera> camera_of(const Node& node, const Mat4& to_world, Vec2i resolution) {
  desc::Camera camera;
  camera.to_world = to_world;
  camera.node = node;
  return make_camera(camera, resolution, Vec3(0.F), 10.F);
}

const desc::PerspectiveCamera kPinhole{50, 0, 1e6F, {}, {}};
const desc::PerspectiveCamera kThinLens{50, 0.3F, 3, {}, {}};
const desc::OrthographicCamera kParallel{0, 1e6F, {}, {}};
const desc::OrthographicCamera kTelecentric{1.2F, 3, {}, {}};  // wide: its cosines matter

struct Case {
  std::string name;
  std::unique_ptr<Camera> camera;
};

bool starts_with(const std::string& text, const std::string& start) {
  return text.rfind(start, 0) == 0;
}

/// All models in rigid, mirrored, scaled and stretched spaces, at (0.3, 0.2, −4) looking at the
/// origin; the one that sees all around is nearer.
std::vector<Case> all_cameras(Vec2i resolution) {
  const Mat4 place = aimed({0.3F, 0.2F, -4.F}, {0, 0, 0});
  const Mat4 inside = aimed({0.3F, 0.2F, -1.5F}, {0, 0, 0});
  std::vector<Case> cases;
  for (const auto& [space, shape] : {std::pair<std::string, Mat4>{"rigid", Mat4()},
                                     {"mirrored", scaling(-1, 1, 1)},
                                     {"scaled", scaling(1.5, 1.5, 1.5)},
                                     {"stretched", scaling(1, 1.4, 0.8)}}) {
    const Mat4 to_world = shape * place;
    cases.push_back({"pinhole " + space, camera_of(kPinhole, to_world, resolution)});
    cases.push_back({"thin lens " + space, camera_of(kThinLens, to_world, resolution)});
    cases.push_back({"orthographic " + space, camera_of(kParallel, to_world, resolution)});
    cases.push_back({"telecentric " + space, camera_of(kTelecentric, to_world, resolution)});
    cases.push_back(
        {"environment " + space, camera_of(desc::EnvironmentCamera{}, shape * inside, resolution)});
  }
  return cases;
}

TEST(Camera, RasterInvertsEmission) {
  for (const auto& [name, camera] : all_cameras({640, 360})) {
    SCOPED_TRACE(name);
    Rng rng(1);
    for (int i = 0; i < 20000; ++i) {
      EmissionUniforms u = emission_uniforms(rng);
      if (i == 0) u.direction = Vec2(0.F, 0.5F);
      if (i == 1) u.direction = Vec2(kOneMinusEpsilon, kOneMinusEpsilon);
      const auto sample = camera->sample_emission(u);
      ASSERT_TRUE(sample);
      EXPECT_EQ(sample->weight, Spectrum(1.F));
      const auto raster = camera->raster(sample->point, sample->w);
      ASSERT_TRUE(raster) << u.direction;
      // The left and right edge of an environment image are the same direction, its top edge is a
      // point.
      const float dx = std::abs(raster->x - u.direction.x * 640.F);
      const float width = starts_with(name, "environment") ? std::sin(kPi * u.direction.y) : 1.F;
      EXPECT_LT(std::min(dx, 640.F - dx) * width, 5e-3F);
      EXPECT_NEAR(raster->y, u.direction.y * 360.F, 5e-3F);
      ASSERT_TRUE(raster->x >= 0.F && raster->x < 640.F && raster->y >= 0.F && raster->y < 360.F);
    }
  }
}

TEST(Camera, WeightsAndDensitiesAgree) {
  for (const auto& [name, camera] : all_cameras({64, 48})) {
    SCOPED_TRACE(name);
    check_emission(*camera);
    check_connection(*camera, {{0, 0, 0}, {0.5F, -0.3F, 1}, {-0.8F, 0.5F, -1}});
  }
}

TEST(Camera, DirectionsFollowTheirDensity) {
  for (const auto& [name, camera] : all_cameras({64, 48})) {
    if (camera->at_infinity()) continue;
    SCOPED_TRACE(name);
    if (starts_with(name, "environment")) {
      // The density has poles in the middle of a cone; the raster has them on its border.
      const auto look = [&seen = *camera](const Vec2& s) {
        return seen.sample_emission({0.F, {0.F, 0.F}, s})->w;
      };
      const auto back = [&seen = *camera](const Vec3& w) {
        const auto raster = seen.raster(EndpointPoint::at({0.3F, 0.2F, -1.5F}), w);
        return *raster / Vec2(64.F, 48.F);
      };
      check_departures(*camera, Chart<Vec3>{look, numeric_measure(look), back}, 16, 16, 12);
    } else {
      check_departures(*camera, cone_chart({0, 0, 1}, 0.5), 12, 12, 100);
    }
  }
}

TEST(Camera, LensPointsAreUniform) {
  const auto camera = camera_of(kThinLens, aimed({0, 0, -4}, {0, 0, 0}), {8, 8});
  Rng rng(2);
  Mean squared;
  Mean x;
  for (int i = 0; i < 200000; ++i) {
    const auto sample = camera->sample_connection({0, 0, 0}, connection_uniforms(rng));
    ASSERT_TRUE(sample);
    const Vec3 lens = sample->point.surface.p - Vec3(0, 0, -4);
    ASSERT_NEAR(lens.z, 0.F, 1e-6F);
    squared.add(length_squared(lens));
    x.add(1.0 + lens.x);
    ASSERT_NEAR(sample->pdf.value(), 1.0 / (M_PI * 0.09), 1e-3);
    ASSERT_NEAR(sample->point.surface.ng.z, 1.F, 1e-6F);
  }
  expect_mean(squared, 0.09 / 2);
  expect_mean(x, 1.0);
}

TEST(Camera, TelecentricDirectionsFollowTheirDensity) {
  const auto camera =
      camera_of(kTelecentric, scaling(1, 1.4, 0.8) * aimed({0, 0, -4}, {0, 0, 0}), {8, 8});
  Rng rng(3);
  // Rays of the lens fill a disk of radius 0.4 at distance one, before the space is stretched.
  const auto lens_uv = [](const Vec3& w) {
    return Vec2(w.x / w.z * 0.8F / 0.4F, w.y / w.z * 0.8F / (0.4F * 1.4F));
  };
  const Chart<Vec3> chart{
      [](const Vec2& s) {
        const float r = 0.4F * std::sqrt(s.x);
        const float phi = 2.F * kPi * s.y;
        return normalize(Vec3(r * std::cos(phi), 1.4F * r * std::sin(phi), 0.8F));
      },
      [](const Vec2& s) {
        // Area at z = 0.8, times cos³ / 0.8².
        const double r = 0.4 * std::sqrt(s.x);
        const double px = r * std::cos(2 * M_PI * s.y) / 0.8;
        const double py = 1.4 * r * std::sin(2 * M_PI * s.y) / 0.8;
        return M_PI * 0.16 * 1.4 / 0.64 / std::pow(1 + px * px + py * py, 1.5);
      },
      [&](const Vec3& w) {
        const Vec2 p = lens_uv(w);
        const float phi = std::atan2(p.y, p.x) / (2.F * kPi);
        return Vec2(p.dot(p), phi < 0.F ? phi + 1.F : phi);
      }};
  check_density<Vec3>(
      chart,
      [&]() -> std::optional<Vec3> { return camera->sample_emission(emission_uniforms(rng))->w; },
      [&](const Vec3& w) {
        return static_cast<double>(
            camera->connection_pdf({0, 0, 0}, EndpointPoint::at_infinity(-w)).value());
      });
}

TEST(PerspectiveCamera, ShorterSideSpansTheFieldOfView) {
  const auto wide = camera_of(desc::PerspectiveCamera{90, 0, 1e6F, {}, {}}, Mat4(), {200, 100});
  const auto corner = wide->sample_emission({0.F, {0.F, 0.F}, {kOneMinusEpsilon, 0.F}});
  EXPECT_LT(length(corner->w - normalize(Vec3(2, 1, 1))), 1e-5F) << "top right is +x, +y";
  const auto tall = camera_of(desc::PerspectiveCamera{90, 0, 1e6F, {}, {}}, Mat4(), {100, 200});
  const auto lower = tall->sample_emission({0.F, {0.F, 0.F}, {0.F, kOneMinusEpsilon}});
  EXPECT_LT(length(lower->w - normalize(Vec3(-1, -2, 1))), 1e-5F) << "bottom left is −x, −y";
}

TEST(PerspectiveCamera, AspectAndScreenWindowOverrideTheResolution) {
  desc::PerspectiveCamera node{90, 0, 1e6F, {}, 4.F};
  const auto aspect = camera_of(node, Mat4(), {100, 100});
  EXPECT_LT(
      length(aspect->sample_emission({0.F, {0.F, 0.F}, {0.F, 0.F}})->w - normalize(Vec3(-4, 1, 1))),
      1e-5F);
  node.window = desc::ScreenWindow{0, 3, -0.5F, 0.25F};
  const auto window = camera_of(node, Mat4(), {100, 100});
  EXPECT_LT(length(window->sample_emission({0.F, {0.F, 0.F}, {0.F, 0.F}})->w -
                   normalize(Vec3(0, 0.25F, 1))),
            1e-5F);
  EXPECT_LT(
      length(window->sample_emission({0.F, {0.F, 0.F}, {kOneMinusEpsilon, kOneMinusEpsilon}})->w -
             normalize(Vec3(3, -0.5F, 1))),
      1e-5F);
}

TEST(PerspectiveCamera, RaysOfAPixelMeetInTheFocalPlane) {
  const auto camera = camera_of(kThinLens, Mat4(), {64, 48});
  Rng rng(4);
  for (int i = 0; i < 1000; ++i) {
    const auto sample = camera->sample_emission({0.F, next_pair(rng), {0.3F, 0.8F}});
    const Vec3 focus = sample->origin + sample->w * (3.F / sample->w.z);
    const float tangent = std::tan(25.F * kPi / 180.F);
    EXPECT_LT(length(focus - Vec3(-0.4F * 4 / 3 * tangent * 3, -0.6F * tangent * 3, 3)), 1e-4F);
  }
}

TEST(OrthographicCamera, FilmIsTheScreenWindow) {
  const auto camera = camera_of(kParallel, Mat4(), {200, 100});
  const auto sample = camera->sample_emission({0.F, {0.F, 0.F}, {0.F, 0.F}});
  EXPECT_LT(length(sample->origin - Vec3(-2, 1, 0)), 1e-5F);
  EXPECT_LT(length(sample->w - Vec3(0, 0, 1)), 1e-6F);
  EXPECT_LT(length(sample->point.toward - Vec3(0, 0, -1)), 1e-6F);
  const auto seen = camera->sample_connection({1, 0.5F, 3}, {0.F, {0.F, 0.F}});
  ASSERT_TRUE(seen);
  EXPECT_FLOAT_EQ(seen->distance, 3.F);
  EXPECT_LT(length(Vec3(camera->raster(seen->point, -seen->w)->x,
                        camera->raster(seen->point, -seen->w)->y, 0) -
                   Vec3(150, 25, 0)),
            1e-3F);
  EXPECT_FALSE(camera->sample_connection({1, 0.5F, -3}, {0.F, {0.F, 0.F}}))
      << "behind the film plane";
  EXPECT_FALSE(camera->sample_connection({2.1F, 0.5F, 3}, {0.F, {0.F, 0.F}})) << "beside the film";
}

TEST(EnvironmentCamera, LooksAroundAsPbrt) {
  const auto camera = camera_of(desc::EnvironmentCamera{}, Mat4(), {200, 100});
  const auto look = [&](float u, float v) {
    return camera->sample_emission({0.F, {0.F, 0.F}, {u, v}})->w;
  };
  EXPECT_LT(length(look(0.F, 0.5F) - Vec3(1, 0, 0)), 1e-5F);
  EXPECT_LT(length(look(0.25F, 0.5F) - Vec3(0, 0, 1)), 1e-5F);
  EXPECT_LT(length(look(0.6F, 0.F) - Vec3(0, 1, 0)), 1e-5F);
  EXPECT_TRUE(std::isfinite(
      camera->sample_emission({0.F, {0.F, 0.F}, {0.6F, 0.F}})->departure_pdf.value()));
}

/// The picture of one emitter by camera rays and by connecting points of the emitter to the lens.
template <typename Surface>
void expect_both_ways_agree(const Camera& camera, const Surface& surface, const Light& light,
                            bool around) {
  const Vec2i size = camera.resolution();
  const auto pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  std::vector<Mean> seen(pixels);
  Rng rng(5);
  // Fewer of the rays that go everywhere meet the emitter.
  const int rays_per_pixel = around ? 15000 : 6000;
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    const std::size_t column = pixel % static_cast<std::size_t>(size.x);
    const std::size_t row = pixel / static_cast<std::size_t>(size.x);
    const Vec2 corner(static_cast<float>(column), static_cast<float>(row));
    for (int i = 0; i < rays_per_pixel; ++i) {
      EmissionUniforms u = emission_uniforms(rng);
      u.direction = (corner + u.direction) / Vec2(size);
      const auto ray = camera.sample_emission(u);
      const auto hit = surface.intersect(ray->origin, ray->w);
      seen[pixel].add(hit ? luminance(light.emitted({*hit, Vec3(0.F)}, -ray->w)) : 0.0);
    }
  }
  std::vector<double> sum(pixels);
  std::vector<double> squares(pixels);
  constexpr int kLightPaths = 600000;
  for (int i = 0; i < kLightPaths; ++i) {
    const auto start = light.sample_emission(emission_uniforms(rng));
    if (!start) continue;
    const SurfacePoint& at = start->point.surface;
    const auto lens = camera.sample_connection(at.p, connection_uniforms(rng));
    if (!lens) continue;
    const auto raster = camera.raster(lens->point, -lens->w);
    ASSERT_TRUE(raster);
    const double value = luminance(light.emitted(start->point, lens->w) * lens->weight) *
                         abs_dot(at.ng, lens->w) / start->position_pdf.value() *
                         static_cast<double>(pixels);
    const auto pixel = static_cast<std::size_t>(raster->y) * static_cast<std::size_t>(size.x) +
                       static_cast<std::size_t>(raster->x);
    sum[pixel] += value;
    squares[pixel] += value * value;
  }
  double total_a = 0.0;
  double total_b = 0.0;
  double total_variance = 0.0;
  int lit = 0;
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    const double traced = sum[pixel] / kLightPaths;
    const double variance = (squares[pixel] / kLightPaths - traced * traced) / kLightPaths;
    const double error = std::sqrt(variance + seen[pixel].error() * seen[pixel].error());
    EXPECT_NEAR(seen[pixel].value(), traced, 5.0 * error + 2e-3) << "pixel " << pixel;
    total_a += seen[pixel].value();
    total_b += traced;
    total_variance += error * error;
    if (seen[pixel].value() > 0.05) {
      ++lit;
      EXPECT_LT(5.0 * error, 0.25 * std::max(seen[pixel].value(), 0.3))
          << "too few samples to tell";
    }
  }
  EXPECT_GE(lit, 2);
  EXPECT_NEAR(total_a, total_b, 5.0 * std::sqrt(total_variance) + 1e-3 * total_a);
  EXPECT_LT(5.0 * std::sqrt(total_variance), 0.07 * total_a) << "too few samples to tell";
}

TEST(Camera, LightTracingGivesTheSamePictureAsCameraRays) {
  const TextureList textures = one_ramp();
  const Quad quad({-0.9F, -0.7F, 0.5F}, {0.2F, 1.5F, 0.4F}, {1.6F, 0, -0.3F});  // faces −z
  const auto quad_light = make_surface_light(area_light({1, 1, 1}, false, 0), quad, textures);
  const Ball ball({0.1F, -0.1F, -0.5F}, 0.7F);
  const auto ball_light = make_surface_light(area_light({1, 1, 1}, false, 0), ball, textures);
  for (const Vec2i& resolution : {Vec2i(7, 4), Vec2i(3, 6)}) {
    for (const auto& [name, camera] : all_cameras(resolution)) {
      const bool rigid = name.find("rigid") != std::string::npos;
      const bool around = starts_with(name, "environment");
      if (resolution.y == 6 && !rigid) continue;
      SCOPED_TRACE(name);
      expect_both_ways_agree(*camera, quad, *quad_light, around);
      if (rigid) expect_both_ways_agree(*camera, ball, *ball_light, around);
    }
  }
}

TEST(Camera, InvisibleReferencesGiveNothing) {
  const auto pinhole = camera_of(kPinhole, Mat4(), {64, 48});
  const auto lens = camera_of(kThinLens, Mat4(), {64, 48});
  const auto around = camera_of(desc::EnvironmentCamera{}, Mat4(), {64, 48});
  const ConnectionUniforms u{0.5F, {0.5F, 0.5F}};
  EXPECT_FALSE(pinhole->sample_connection({0, 0, 0}, u));
  EXPECT_FALSE(pinhole->sample_connection({0, 0, -1}, u));
  EXPECT_FALSE(pinhole->sample_connection({5, 0, 1}, u));
  EXPECT_FALSE(lens->sample_connection({0, 0, -1}, u));
  EXPECT_FALSE(lens->sample_connection({0, 0, 0}, u)) << "on the lens";
  EXPECT_FALSE(around->sample_connection({0, 0, 0}, u));
  const EndpointPoint point = EndpointPoint::at(Vec3(0.F));
  EXPECT_FALSE(pinhole->raster(point, {0, 0, -1}));
  EXPECT_EQ(pinhole->emission_pdf(point, {0, 0, -1}).departure.value(), 0.F);
  EXPECT_TRUE(pinhole->emitted(point, normalize(Vec3(1, 0, 0.1F))).is_black());
}

TEST(Camera, UnusableDescriptionsAreErrors) {
  EXPECT_THROW(camera_of(desc::PerspectiveCamera{180, 0, 1, {}, {}}, Mat4(), {4, 4}), SceneError);
  EXPECT_THROW(camera_of(desc::PerspectiveCamera{0, 0, 1, {}, {}}, Mat4(), {4, 4}), SceneError);
  EXPECT_THROW(camera_of(desc::PerspectiveCamera{50, 1, 0, {}, {}}, Mat4(), {4, 4}), SceneError);
  EXPECT_THROW(camera_of(desc::PerspectiveCamera{50, -1, 1, {}, {}}, Mat4(), {4, 4}), SceneError);
  EXPECT_THROW(camera_of(desc::PerspectiveCamera{50, 0, 1, desc::ScreenWindow{0, 0, -1, 1}, {}},
                         Mat4(), {4, 4}),
               SceneError);
  EXPECT_THROW(camera_of(desc::PerspectiveCamera{50, 0, 1, {}, -1.F}, Mat4(), {4, 4}), SceneError);
  EXPECT_THROW(camera_of(kParallel, scaling(1, 0, 1), {4, 4}), SceneError);
  EXPECT_THROW(camera_of(kParallel, Mat4(), {0, 4}), SceneError);
}

/// Their rays start, or go, where no ray can be traced.
TEST(Camera, ThoseTooLargeOrTooFarAwayAreErrors) {
  const auto fails = [](const auto& node, const Mat4& to_world = Mat4()) {
    try {
      camera_of(node, to_world, {4, 4});
      return false;
    } catch (const SceneError&) {
      return true;
    }
  };
  Mat4 far_away;
  far_away[3][1] = -1e18;
  const desc::ScreenWindow wide{-1e19F, 1e19F, -1e-10F, 1e-10F};
  EXPECT_TRUE(fails(kPinhole, far_away));
  EXPECT_TRUE(fails(kParallel, far_away));
  EXPECT_TRUE(fails(desc::EnvironmentCamera{}, far_away));
  EXPECT_TRUE(fails(desc::PerspectiveCamera{50, 1e30F, 1e30F, {}, {}}));
  EXPECT_TRUE(fails(desc::PerspectiveCamera{50, 1, 1e-38F, {}, {}}));
  EXPECT_TRUE(fails(desc::PerspectiveCamera{50, 0, 1, wide, {}}));
  EXPECT_TRUE(fails(desc::OrthographicCamera{1e30F, 1e30F, {}, {}}));
  EXPECT_TRUE(fails(desc::OrthographicCamera{0, 1, wide, {}}));
  for (const double size : {1e-19, 1e-30, 1e19, 1e38}) {
    EXPECT_TRUE(fails(kThinLens, scaling(size, size, size))) << size;
  }
  far_away[3][1] = -5e17;
  EXPECT_FALSE(fails(kPinhole, far_away));
  EXPECT_FALSE(fails(kThinLens, scaling(1e-9, 1e-9, 1e-9)));
  EXPECT_FALSE(fails(desc::PerspectiveCamera{50, 1, 1e30F, {}, {}})) << "sharp at infinity";
}

TEST(Camera, RaysStartWithinTheirBounds) {
  for (const auto& [name, camera] : all_cameras({8, 6})) {
    SCOPED_TRACE(name);
    Box3 box = camera->bounds();
    box.min -= Vec3(1e-4F);
    box.max += Vec3(1e-4F);
    Rng rng(6);
    for (int i = 0; i < 1000; ++i) {
      ASSERT_TRUE(box.intersects(camera->sample_emission(emission_uniforms(rng))->origin));
    }
  }
}

}  // namespace
}  // namespace ajar
