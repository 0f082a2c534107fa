#include "path/path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <vector>

#include "core/archive.h"
#include "path/inversion.h"
#include "path/measure.h"
#include "path/path_archive.h"
#include "path/recorder.h"
#include "path/replay.h"
#include "path/verify.h"
#include "scene/testing/inverse_checks.h"
#include "support/render.h"
#include "support/small_scenes.h"
#include "transport/sources.h"

/// Explicit paths against the sampler that found them, on all small scenes: glass and mirrors,
/// rough glass, fog, lenses, every kind of light.
namespace ajar {
namespace {

struct Found {
  Path path;
  Contribution contribution;
};

/// Everything that a sampler finds.
class Collector final : public PathRecorder {
 public:
  using PathRecorder::PathRecorder;
  void record(const Path& path, const Contribution& contribution) override {
    found.push_back({path, contribution});
    found.back().contribution.light_point = nullptr;  // dangling later
    found.back().contribution.camera_point = nullptr;
  }
  std::vector<Found> found;
};

PathSamplerSettings settings_of(const char* techniques) {
  PathSamplerSettings settings;
  settings.techniques = TechniqueSet::parse(techniques);
  settings.max_depth = 6;
  settings.roulette_start = 3;
  settings.light_subpaths = 0.75;
  settings.light_paths_per_pixel = 0.5;
  return settings;
}

std::vector<Found> collect(const Scene& scene, const PathSamplerSettings& settings,
                           std::uint32_t samples) {
  PathSampler sampler(scene, settings);
  Collector collector(scene, settings);
  const Vec2 size(scene.camera().resolution());
  for (std::uint32_t i = 0; i < samples; ++i) {
    IndependentSource source({1, i, 2, i});
    const Vec2 raster = source.get_pair({Stream::Camera, 0, kEmissionDirection}) * size;
    collector.begin(raster);
    if (!settings.techniques.any(TechniqueClass::Inner)) sampler.sample_light(source, collector);
    sampler.sample(source, raster, collector);
  }
  EXPECT_EQ(collector.lost(), 0U);
  EXPECT_GT(collector.found.size(), samples / 4);
  return std::move(collector.found);
}

double relative_difference(const Spectrum& a, const Spectrum& b) {
  double largest = 0.0;
  for (int lane = 0; lane < 3; ++lane) {
    const double size = std::max(std::abs(double{a[lane]}), std::abs(double{b[lane]}));
    if (size > 0.0) largest = std::max(largest, std::abs(double{a[lane]} - double{b[lane]}) / size);
  }
  return largest;
}

class Paths : public ::testing::TestWithParam<test::SmallScene> {};

TEST_P(Paths, HaveTheContributionOfTheSampler) {
  const auto scene = test::scene_from(GetParam().text);
  for (const char* techniques : {"ibpt", "bdpt", "implicit,explicit*3,light*0.5,inner*0.25"}) {
    SCOPED_TRACE(techniques);
    const PathSamplerSettings settings = settings_of(techniques);
    std::vector<double> errors;
    std::map<std::pair<int, int>, int> by_technique;
    for (const auto& [path, contribution] : collect(*scene, settings, 1500)) {
      ASSERT_NO_THROW(verify(*scene, settings, path, contribution));
      const auto factor =
          static_cast<float>(tries(settings, contribution.technique) /
                             (contribution.mis_weight * double{contribution.roulette_weight}));
      errors.push_back(relative_difference(contribution.value * factor,
                                           throughput(*scene, path, contribution.technique)));
      ++by_technique[{contribution.technique.s, contribution.technique.t}];
    }
    std::sort(errors.begin(), errors.end());
    EXPECT_LT(errors[errors.size() * 999 / 1000], 1e-3);
    EXPECT_GT(by_technique.size(), 6U) << "too few techniques to tell";
  }
}

/// Steps of chains: one half moves and the other stays, and rejected halves are restored. Against
/// paths that are sampled as a whole by the same numbers.
TEST_P(Paths, AreRecordedHalfByHalf) {
  const auto scene = test::scene_from(GetParam().text);
  PathSamplerSettings settings;
  settings.techniques = TechniqueSet::bdpt();
  settings.min_depth = settings.max_depth = 4;
  const Vec2 size(scene->camera().resolution());
  int found = 0;
  for (int s = 0; s <= 4; ++s) {
    const Technique technique{s, 5 - s};
    SCOPED_TRACE(s);
    PathSampler sampler(*scene, settings);
    Collector recorder(*scene, settings);
    struct Half {
      std::uint32_t number;  ///< light or camera number
      bool complete;
      PathVertex end;
      PathRecorder::Subpath recorded;
    };
    const auto source_of = [](std::uint32_t camera, std::uint32_t light) {
      return IndependentSource({1, camera, 2, light});
    };
    const auto raster_of = [&](std::uint32_t camera) {
      return source_of(camera, 0).get_pair({Stream::Camera, 0, kEmissionDirection}) * size;
    };
    const auto lane_of_half = [&](const Half& camera) {
      return lane_of(source_of(camera.number, 0).get(kLaneChoice));
    };
    const auto trace_camera = [&](std::uint32_t number) {
      Half half{number, true, {}, {}};
      IndependentSource source = source_of(number, 0);
      recorder.begin(raster_of(number));
      if (s > 0 && technique.t >= 2) {
        half.complete =
            sampler.trace_camera_half(source, raster_of(number), technique.t, half.end, &recorder);
      }
      half.recorded = recorder.camera_half();
      return half;
    };
    const auto trace_light = [&](std::uint32_t number, const Half& camera) {
      Half half{number, true, {}, {}};
      IndependentSource source = source_of(camera.number, number);
      recorder.begin(raster_of(camera.number));
      if (s >= 2) half.complete = sampler.trace_light_half(source, s, half.end, &recorder);
      half.recorded = recorder.light_half();
      return half;
    };
    Half camera = trace_camera(0);
    Half light = trace_light(0, camera);
    for (std::uint32_t step = 1; step < 5000; ++step) {
      const Half camera_before = camera;
      const Half light_before = light;
      if (step % 2 == 0) {
        camera = trace_camera(step);
        // Halves of a path have one lane.
        if (lane_of_half(camera) != lane_of_half(camera_before)) {
          light = trace_light(light.number, camera);
        }
      } else {
        light = trace_light(step, camera);
      }
      IndependentSource source = source_of(camera.number, light.number);
      const Vec2 raster = raster_of(camera.number);
      recorder.found.clear();
      if (s == 0) {
        sampler.sample_implicit(source, raster, technique.t, recorder, &recorder);
      } else if (camera.complete && light.complete) {
        sampler.connect_halves(technique, light.end, camera.end, source, recorder);
      }
      const auto expected = replay(*scene, settings, source, raster, technique);
      ASSERT_EQ(recorder.found.size(), expected ? 1U : 0U);
      if (expected) {
        ++found;
        const auto& [path, contribution] = recorder.found.front();
        ASSERT_NO_THROW(verify(*scene, settings, path, contribution));
        const auto bytes = [&](const Path& of) {
          return archived([&](OutputArchive& to) { save_path(to, *scene, of); });
        };
        EXPECT_EQ(bytes(path), bytes(*expected));
      }
      if (step % 3 == 0) continue;
      camera = camera_before;
      light = light_before;
      recorder.camera_half() = camera.recorded;
      recorder.light_half() = light.recorded;
    }
    EXPECT_EQ(recorder.lost(), 0U);
  }
  EXPECT_GT(found, 300);
}

/// Light that goes into glass and stays there: its contribution depends on the end from which the
/// boundary is passed. (Through a whole ball these factors cancel.)
TEST(PathMeasure, BoundariesAreCountedFromTheEndThatPassesThem) {
  const auto scene =
      test::scene_from(test::pbrt_scene("Camera \"perspective\" \"float fov\" [60]", 16, 16, R"(
AttributeBegin
  AreaLightSource "diffuse" "rgb L" [8 7 6]
  Translate 1 0.5 -2
  Shape "disk" "float radius" [1.5]
AttributeEnd
AttributeBegin
  Material "glass"
  Translate 0.1 0.2 0
  Shape "sphere" "float radius" [1]
AttributeEnd
Material "matte" "rgb Kd" [0.7 0.6 0.5]
Translate 0 0 0.5
Shape "disk" "float radius" [0.6]
)"));
  const PathSamplerSettings settings = settings_of("bdpt");
  int from_light = 0;
  for (const auto& [path, contribution] : collect(*scene, settings, 12000)) {
    ASSERT_NO_THROW(verify(*scene, settings, path, contribution));
    if (contribution.technique != Technique{3, 1}) continue;
    ++from_light;
    EXPECT_GT(std::abs(std::log(specular_spread(*scene, path, 1))), 0.3);
  }
  EXPECT_GT(from_light, 100);
}

/// By every technique that can make it, not only its own. In three of a hundred thousand a rounding
/// carries a ray over the border of a lamp or a triangle; one in a thousand may fail. Errors grow
/// from vertex to vertex, most on small balls: the room is four units wide.
TEST_P(Paths, AreReplayedFromTheirNumbers) {
  const auto scene = test::scene_from(GetParam().text);
  for (const char* techniques : {"bdpt", "implicit,explicit*0.5,light*0.5,inner*0.25"}) {
    SCOPED_TRACE(techniques);
    const PathSamplerSettings settings = settings_of(techniques);
    int tried = 0;
    int failed = 0;
    std::vector<double> distances;
    std::vector<double> errors;
    std::uint64_t seed = 0;
    const std::vector<Found> found = collect(*scene, settings, 1200);
    for (std::size_t i = 0; i < found.size() && tried < 3000; ++i) {
      const Path& path = found[i].path;
      for (int s = 0; s <= path.depth(); ++s) {
        const Technique technique{s, path.depth() + 1 - s};
        if (!settings.techniques.enabled(technique)) continue;
        const double pdf = technique_pdf(*scene, path, technique);
        if (!(pdf > 0.0)) continue;
        ++tried;
        IndependentSource fresh({++seed, 1, seed, 2});
        auto inversion = invert(*scene, settings, path, technique, fresh);
        const auto again =
            inversion ? replay(*scene, settings, inversion->numbers, path.raster, technique)
                      : std::nullopt;
        if (!again) {
          ++failed;
          continue;
        }
        EXPECT_LE(inversion->log_density, std::log(pdf) + 1e-9);
        double distance = 0.0;
        for (int x = 1; x < path.depth(); ++x) {
          EXPECT_EQ(again->vertex(x).event, path.vertex(x).event);
          distance = std::max(distance, double{length(again->vertex(x).p() - path.vertex(x).p())});
        }
        distances.push_back(distance);
        errors.push_back(relative_difference(throughput(*scene, path, technique),
                                             throughput(*scene, *again, technique)));
      }
    }
    EXPECT_GT(tried, 1000);
    EXPECT_LE(failed, 1 + tried / 1000) << "of " << tried;
    std::sort(distances.begin(), distances.end());
    std::sort(errors.begin(), errors.end());
    EXPECT_LT(distances[distances.size() * 99 / 100], 1e-3);
    EXPECT_LT(distances[distances.size() * 998 / 1000], 1e-2);
    EXPECT_LT(errors[errors.size() / 2], 1e-3);
    EXPECT_LT(errors[errors.size() * 98 / 100], 2e-2);
  }
}

TEST_P(Paths, SurviveAnArchive) {
  const auto scene = test::scene_from(GetParam().text);
  const PathSamplerSettings settings = settings_of("bdpt");
  const std::vector<Found> found = collect(*scene, settings, 300);
  for (const auto& [path, contribution] : found) {
    const auto save = [&, &saved = path](OutputArchive& to) { save_path(to, *scene, saved); };
    const std::string bytes = archived(save);
    Path read;
    unarchive(bytes, [&](InputArchive& from) { read = load_path(from, *scene); });
    EXPECT_EQ(archived([&](OutputArchive& to) { save_path(to, *scene, read); }), bytes);
    EXPECT_EQ(technique_pdf(*scene, read, contribution.technique),
              technique_pdf(*scene, path, contribution.technique));
    EXPECT_EQ(throughput(*scene, read, contribution.technique),
              throughput(*scene, path, contribution.technique));
  }
  // Corrupt archives: cut short anywhere, or with any byte another.
  const Path& longest =
      std::max_element(found.begin(), found.end(), [](const Found& a, const Found& b) {
        return a.path.depth() < b.path.depth();
      })->path;
  const std::string bytes = archived([&](OutputArchive& to) { save_path(to, *scene, longest); });
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    EXPECT_THROW(unarchive(std::string_view(bytes).substr(0, i),
                           [&](InputArchive& from) { load_path(from, *scene); }),
                 std::exception);
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ 0x7f);
    try {
      unarchive(changed, [&](InputArchive& from) {
        const Path path = load_path(from, *scene);
        for (int s = 0; s <= path.depth(); ++s) {
          technique_pdf(*scene, path, {s, path.depth() + 1 - s});
        }
      });
    } catch (const std::exception&) {
      // Accepted archives must do no harm.
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Paths, ::testing::ValuesIn(test::small_scenes()),
                         [](const auto& test) { return test.param.name; });

/// Queries of the sampler: directions and positions in pairs.
float number_at(SampleSource& numbers, SampleAddress address) {
  if (address.slot() > Slot::LightPositionY) return numbers.get(address);
  const auto slot = static_cast<unsigned>(address.slot());
  const Vec2 pair = numbers.get_pair(
      {address.stream(), address.vertex(), static_cast<Slot>(slot & ~1U), address.repeat()});
  return slot % 2 == 0 ? pair.x : pair.y;
}

/// Numbers of whole paths: inverses of samples from uniform numbers are distributed as those
/// numbers are, given that they find a path; roulette, tries and distances included. Every address
/// is counted in 8 bins, against the numbers of other samples. Power: with about 5000 paths of
/// either kind a number whose density is wrong by 15 % everywhere is found at p < 10⁻⁶.
TEST(PathInversion, NumbersAreDistributedAsThoseThatWereSampled) {
  for (const auto& [name, technique] :
       std::vector<std::pair<std::string, Technique>>{{"Environment", {0, 4}},
                                                      {"RoughGlass", {2, 2}},
                                                      {"ManyLamps", {1, 3}},
                                                      {"GlassAndMetal", {3, 2}},
                                                      {"ThinLens", {3, 1}},
                                                      {"ManyLampsInFog", {1, 4}},
                                                      {"ManyLampsInFog", {3, 2}},
                                                      {"MilkBall", {1, 4}}}) {
    SCOPED_TRACE(name + " (" + std::to_string(technique.s) + "," + std::to_string(technique.t) +
                 ")");
    const auto scene = test::scene_from(test::small_scene(name).text);
    PathSamplerSettings settings = settings_of("implicit,explicit*0.5,light*0.5,inner*0.5");
    settings.roulette_start = 1;
    settings.min_depth = settings.max_depth = technique.depth();
    const Vec2 size(scene->camera().resolution());
    constexpr int kBins = 8;
    constexpr int kPaths = 5000;
    std::vector<std::vector<double>> counts[2];
    int paths[2] = {0, 0};
    std::vector<SampleAddress> addresses;
    const auto add_addresses = [&](Stream stream, int vertices) {
      for (int vertex = 0; vertex < vertices; ++vertex) {
        for (int slot = 0; slot < static_cast<int>(Slot::kCount); ++slot) {
          addresses.emplace_back(stream, vertex, static_cast<Slot>(slot));
        }
      }
    };
    add_addresses(Stream::Camera, technique.t);
    add_addresses(Stream::Light, technique.s);
    if (technique.s > 0) {
      addresses.emplace_back(Stream::Connection, (technique.s - 1) * 256 + technique.t - 1,
                             kConnectionTry);
    }
    for (auto& kind : counts) kind.assign(addresses.size(), std::vector<double>(kBins));
    for (std::uint64_t i = 0; i < 8000000 && (paths[0] < kPaths || paths[1] < kPaths); ++i) {
      // Odd samples are inverted, even ones are the reference.
      const int kind = static_cast<int>(i % 2);
      if (paths[kind] == kPaths) continue;
      IndependentSource source({i, 1, i, 2});
      const Vec2 raster = source.get_pair({Stream::Camera, 0, kEmissionDirection}) * size;
      const auto path = replay(*scene, settings, source, raster, technique);
      if (!path) continue;
      SampleSource* numbers = &source;
      IndependentSource fresh({i, 3, i, 4});
      std::optional<Inversion> inversion;
      if (kind == 1) {
        inversion = invert(*scene, settings, *path, technique, fresh);
        ASSERT_TRUE(inversion);
        numbers = &inversion->numbers;
      }
      ++paths[kind];
      for (std::size_t k = 0; k < addresses.size(); ++k) {
        const float number = number_at(*numbers, addresses[k]);
        const int bin = std::min(static_cast<int>(number * kBins), kBins - 1);
        counts[kind][k][static_cast<std::size_t>(bin)] += 1.0;
      }
    }
    ASSERT_EQ(paths[0], kPaths);
    ASSERT_EQ(paths[1], kPaths);
    for (std::size_t k = 0; k < addresses.size(); ++k) {
      EXPECT_GT(testing::same_counts(counts[0][k], counts[1][k]), 1e-6)
          << "stream " << static_cast<int>(addresses[k].stream()) << ", vertex "
          << addresses[k].vertex() << ", slot " << static_cast<int>(addresses[k].slot());
    }
  }
}

TEST(PathVerify, NamesMismatches) {
  const auto scene = test::scene_from(test::small_scene("GlassAndMetal").text);
  const PathSamplerSettings settings = settings_of("bdpt");
  const auto complaint = [&](const Path& path, const Contribution& contribution) {
    try {
      verify(*scene, settings, path, contribution);
      return std::string();
    } catch (const std::logic_error& error) {
      return std::string(error.what());
    }
  };
  int refracted = 0;
  for (const auto& [path, contribution] : collect(*scene, settings, 500)) {
    ASSERT_EQ(complaint(path, contribution), "");
    Contribution brighter = contribution;
    brighter.value *= 1.05F;
    EXPECT_NE(complaint(path, brighter).find("is worth"), std::string::npos);
    for (int x = 1; x < path.depth(); ++x) {
      if (!path.vertex(x).event.specular()) continue;
      ++refracted;
      Path moved = path;
      moved.vertices[static_cast<std::size_t>(x - 1)].hit.point.p += Vec3(0.1F, 0.2F, 0.1F);
      EXPECT_NE(complaint(moved, contribution).find("specular"), std::string::npos);
    }
    Path longer = path;
    longer.segments.emplace_back();
    EXPECT_NE(complaint(longer, contribution).find("segment"), std::string::npos);
  }
  EXPECT_GT(refracted, 20);
}

}  // namespace
}  // namespace ajar
