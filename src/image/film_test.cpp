#include "image/film.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "core/random.h"

namespace ajar {
namespace {

std::vector<std::pair<std::string, Filter>> filters_by_name() {
  return {{"box", Filter::box()},
          {"box wide", Filter::box({1.3F, 0.7F})},
          {"triangle", Filter::triangle({2.F, 1.5F})},
          {"gaussian", Filter::gaussian({2.F, 1.5F}, 2.F)},
          {"mitchell", Filter::mitchell({2.F, 2.5F}, 1.F / 3, 1.F / 3)},
          {"sinc", Filter::sinc({4.F, 3.F}, 3.F)}};
}

/// Not square, and a crop that touches one border only.
constexpr int kFilmWidth = 12;
constexpr int kFilmHeight = 7;
Film make_film(const Filter& filter, int replicates = 1) {
  return Film({kFilmWidth, kFilmHeight}, Box2i({5, 0}, {10, 3}), filter, replicates,
              {{"direct"}, {"indirect"}});
}

TEST(Film, KeepsItsShape) {
  const Film film({kFilmWidth, kFilmHeight}, Box2i({5, 0}, {10, 3}), Filter::box(), 4,
                  {{"direct"}, {"albedo", false}, {"indirect"}});
  EXPECT_EQ(film.width(), 6);
  EXPECT_EQ(film.height(), 4);
  EXPECT_EQ(film.layer("indirect"), 2);
  EXPECT_EQ(film.layer("depth"), -1);
  EXPECT_EQ(film.raw().size(), (4U + 1U + 4U) * 6U * 4U * 3U)
      << "layers without replicates keep one sum";
  EXPECT_EQ(film.bytes(), film.raw().size() * 8U);
}

TEST(Film, AddReachesOnePixelOfOneLayerAndReplicate) {
  Film film = make_film(Filter::box(), 2);
  ASSERT_TRUE(film.add(1, 1, {7, 2}, {0.5F, 0.25F, 2.F}));
  const std::size_t place = (1U * 2U + 1U) * 72U + (2U * 6U + 2U) * 3U;
  EXPECT_EQ(film.raw()[place], 1 << 23);
  EXPECT_EQ(film.raw()[place + 1], 1 << 22);
  EXPECT_EQ(film.raw()[place + 2], 1 << 25);
  EXPECT_EQ(std::count(film.raw().begin(), film.raw().end(), 0),
            static_cast<std::ptrdiff_t>(film.raw().size()) - 3);
  EXPECT_EQ(film.develop(1, 2.0)[(2 * 6 + 2) * 3], 1.F);
  EXPECT_EQ(film.develop_replicate(1, 1, 2.0)[(2 * 6 + 2) * 3 + 1], 0.5F);
  EXPECT_EQ(film.develop_replicate(1, 0, 2.0)[(2 * 6 + 2) * 3], 0.F);
  std::vector<float> pixels(24, 0.F);
  pixels[2 * 6 + 2] = 4.F;
  EXPECT_EQ(film.develop(1, DevelopScale(pixels))[(2 * 6 + 2) * 3], 2.F);
  pixels.pop_back();
  EXPECT_THROW(film.develop(1, DevelopScale(pixels)), std::invalid_argument);
  film.clear();
  EXPECT_EQ(std::count(film.raw().begin(), film.raw().end(), 0),
            static_cast<std::ptrdiff_t>(film.raw().size()));
}

TEST(Film, SumsAreTheSameBitsInAnyOrderOnAnyThreads) {
  struct Splat {
    int replicate;
    Vec2 raster;
    Spectrum value;
  };
  std::vector<Splat> splats;
  Rng rng(5);
  for (int i = 0; i < 4000; ++i) {
    const float x = 3.F + 9.F * rng.next();
    const float y = 6.F * rng.next() - 1.F;
    const float size = std::exp(12.F * rng.next() - 6.F);
    splats.push_back({i % 3, {x, y}, {size, size * rng.next(), size * rng.next()}});
  }
  const Filter filter = Filter::mitchell({2.F, 2.F}, 1.F / 3, 1.F / 3);
  const auto render = [&](unsigned threads) {
    Film film = make_film(filter, 3);
    std::vector<std::thread> pool;
    for (unsigned t = 0; t < threads; ++t) {
      pool.emplace_back([&, t] {
        for (std::size_t i = t; i < splats.size(); i += threads) {
          film.splat(0, splats[i].replicate, splats[i].raster, splats[i].value);
          film.add(1, splats[i].replicate, {5 + static_cast<int>(splats[i].raster.y + 1.F), 1},
                   splats[i].value);
        }
      });
    }
    for (std::thread& thread : pool) thread.join();
    return std::vector<std::int64_t>(film.raw().begin(), film.raw().end());
  };
  const std::vector<std::int64_t> expected = render(1);
  std::mt19937 shuffler(9);
  for (const unsigned threads : {1U, 2U, 4U, 7U}) {
    std::shuffle(splats.begin(), splats.end(), shuffler);
    EXPECT_EQ(render(threads), expected) << threads << " threads";
  }
}

TEST(Film, ConstantLightGivesAConstantImageThroughEveryFilter) {
  for (const auto& [name, filter] : filters_by_name()) {
    Film film = make_film(filter);
    // Camera samples on a regular grid of uniform numbers. Where h changes its sign, so does the
    // weight, and the grid misplaces this by up to half a step: 1.3 % of the sum for sinc.
    constexpr int kGrid = 256;
    for (int y = 0; y <= 3; y += 3) {
      for (int x = 5; x <= 10; x += 5) {
        for (int i = 0; i < kGrid * kGrid; ++i) {
          const int column = i % kGrid;
          const int row = i / kGrid;
          const FilterSample s = filter.sample({(static_cast<float>(column) + 0.5F) / kGrid,
                                                (static_cast<float>(row) + 0.5F) / kGrid});
          ASSERT_TRUE(film.add(0, 0, {x, y}, Spectrum(2.F) * s.weight));
        }
      }
    }
    const auto camera = film.develop(0, 1.0 / (kGrid * kGrid));
    for (const std::size_t pixel : {0U, 5U, 18U, 23U})
      EXPECT_NEAR(camera[pixel * 3], 2.F, 0.03) << name;

    // A regular grid of splats that reaches over all borders.
    constexpr int kSide = 32;
    for (int j = -6 * kSide; j < 10 * kSide; ++j) {
      for (int i = -2 * kSide; i < 18 * kSide; ++i) {
        ASSERT_TRUE(film.splat(
            1, 0, {(static_cast<float>(i) + 0.5F) / kSide, (static_cast<float>(j) + 0.5F) / kSide},
            Spectrum(2.F)));
      }
    }
    const double tolerance =
        name == "box wide" ? 0.05 : 0.005;  // its edges lie between points of the grid
    for (const float v : film.develop(1, 1.0 / (kSide * kSide)))
      EXPECT_NEAR(v, 2.F, tolerance) << name;
  }
}

TEST(Film, SplatsAndCameraSamplesEstimateTheSameImage) {
  // A picture with structure everywhere, beyond the crop and beyond the image.
  const auto light = [](const Vec2& p) {
    return Spectrum(1.F + std::sin(1.3F * p.x + 0.4F), 1.F + std::cos(0.9F * p.y),
                    p.x > 8.4F ? 2.F : 0.1F);
  };
  constexpr int kReplicates = 16;
  for (const auto& [name, filter] : filters_by_name()) {
    Film film = make_film(filter, kReplicates);
    constexpr int kPerPixel = 250;
    constexpr int kSplats = 20000;
    const Vec2 low(5.F - 5.F, 0.F - 5.F);
    const Vec2 size(16.F, 14.F);
    for (int r = 0; r < kReplicates; ++r) {
      Rng rng(11, static_cast<std::uint64_t>(r));
      for (int y = 0; y <= 3; ++y) {
        for (int x = 5; x <= 10; ++x) {
          for (int i = 0; i < kPerPixel; ++i) {
            const float u = rng.next();
            const FilterSample s = filter.sample({u, rng.next()});
            const Vec2 raster =
                Vec2(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F) + s.offset;
            film.add(0, r, {x, y}, light(raster) * s.weight);
          }
        }
      }
      for (int i = 0; i < kSplats; ++i) {
        const float u = rng.next();
        const Vec2 raster = low + size * Vec2(u, rng.next());
        film.splat(1, r, raster, light(raster));
      }
    }
    double chi_square = 0.0;
    double worst = 0.0;
    const std::size_t values = film.develop(0, 1.0).size();
    std::vector<double> sum(values), squares(values);
    for (int r = 0; r < kReplicates; ++r) {
      const auto camera = film.develop_replicate(0, r, 1.0 / kPerPixel);
      const auto splatted = film.develop_replicate(1, r, double{size.x} * size.y / kSplats);
      for (std::size_t i = 0; i < values; ++i) {
        const double d = double{camera[i]} - splatted[i];
        sum[i] += d;
        squares[i] += d * d;
      }
    }
    for (std::size_t i = 0; i < values; ++i) {
      const double mean = sum[i] / kReplicates;
      const double variance = (squares[i] / kReplicates - mean * mean) / (kReplicates - 1);
      chi_square += mean * mean / variance;
      worst = std::max(worst, std::abs(mean) / std::sqrt(variance));
    }
    // Means of t²(15) values: expectation 15/13 each; values of neighbours and channels are
    // correlated, hence the wide bounds. A bias of 2 % fails.
    EXPECT_LT(chi_square / static_cast<double>(values), 2.2) << name;
    EXPECT_LT(worst, 8.5) << name;
  }
}

TEST(Film, OnePixelBoxSplatsTouchExactlyOnePixel) {
  const auto touched = [](const Vec2& raster) {
    Film film({8, 8}, Box2i({0, 0}, {7, 7}), Filter::box(), 1, {{"direct"}});
    film.splat(0, 0, raster, {1.F, 0.F, 0.F});
    std::vector<int> pixels;
    for (int i = 0; i < 64; ++i) {
      if (film.raw()[static_cast<std::size_t>(i) * 3] != 0) pixels.push_back(i);
    }
    return pixels;
  };
  EXPECT_EQ(touched({3.F, 2.F}), std::vector<int>{2 * 8 + 3})
      << "a corner belongs to the pixel that it starts";
  EXPECT_EQ(touched({0.F, 0.F}), std::vector<int>{0});
  EXPECT_EQ(touched({7.9999995F, 7.9999995F}), std::vector<int>{63});
  EXPECT_EQ(touched({8.F, 4.F}), std::vector<int>{});
  EXPECT_EQ(touched({-1e-9F, 4.F}), std::vector<int>{});
  EXPECT_EQ(touched({1e-9F, 4.F}), std::vector<int>{4 * 8});
  EXPECT_EQ(touched({1e30F, -1e30F}), std::vector<int>{});
  Rng rng(2);
  for (int i = 0; i < 2000; ++i) {
    const Vec2 p(8.F * rng.next(), 8.F * rng.next());
    EXPECT_EQ(touched(p), std::vector<int>{static_cast<int>(p.y) * 8 + static_cast<int>(p.x)});
  }
}

/// With their box layers, splats of any filter are those of a box, whatever the crop and wherever
/// the border is; and the layers themselves are as they were.
TEST(Film, BoxLayersMakeBoxesOfSplats) {
  for (const auto& [name, filter] : filters_by_name()) {
    if (filter.is_box_of_pixel()) continue;
    std::vector<LayerSpec> layers = light_layers(1.0);
    Film plain({12, 9}, Box2i({3, 0}, {11, 6}), filter, 2, layers);
    Film boxes({12, 9}, Box2i({3, 0}, {11, 6}), Filter::box(), 2, layers);
    add_box_layers(layers, filter);
    Film film({12, 9}, Box2i({3, 0}, {11, 6}), filter, 2, layers);
    Rng rng(7);
    for (int i = 0; i < 500; ++i) {
      const Vec2 raster(12.F * rng.next(), 9.F * rng.next());
      for (Film* each : {&plain, &boxes, &film}) {
        each->splat(i % 2, (i / 2) % 2, raster, {1.F + static_cast<float>(i % 7), 2.F, 3.F});
        each->add(i % 2, 0, {5, 3}, {0.F, 1.F, 0.F});
      }
    }
    for (int layer = 0; layer < 2; ++layer) {
      for (int r = 0; r < 2; ++r) {
        const std::vector<float> picture = film.develop_replicate(layer, r, 1.0);
        EXPECT_EQ(picture, plain.develop_replicate(layer, r, 1.0)) << name;
        const std::vector<float> more = film.develop_replicate(2 + layer, r, 1.0);
        const std::vector<float> expected = boxes.develop_replicate(layer, r, 1.0);
        for (std::size_t i = 0; i < picture.size(); ++i) {
          EXPECT_NEAR(picture[i] + more[i], expected[i], 2e-5 * (1.0 + expected[i])) << name;
        }
      }
    }
  }
}

TEST(Film, BoxLayersAreThoseOfLightAlone) {
  std::vector<LayerSpec> layers = light_layers(3.0);
  layers.push_back({.name = "weak", .part_of = "indirect"});
  layers.push_back({.name = "strong", .instead_of = "indirect"});
  layers.push_back({.name = "albedo"});
  const std::size_t before = layers.size();
  add_box_layers(layers, Filter::box());
  EXPECT_EQ(layers.size(), before);
  add_box_layers(layers, Filter::box({1.F, 0.5F}));
  ASSERT_EQ(layers.size(), before + 4);
  EXPECT_EQ(layers[before].box_of, "direct");
  EXPECT_EQ(layers[before].magnitude, 3.0);
  EXPECT_EQ(layers.back().box_of, "strong");
  EXPECT_FALSE(layers.back().is_light());
  const LayerSpec alone{.name = "x.box", .box_of = "x"};
  EXPECT_THROW(Film({2, 2}, Box2i({0, 0}, {1, 1}), Filter::box(), 1, {alone}),
               std::invalid_argument);
}

TEST(Film, RefusesNan) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  Film film = make_film(Filter::triangle({2.F, 2.F}));
  EXPECT_FALSE(film.add(0, 0, {6, 1}, {1.F, nan, 1.F}));
  EXPECT_FALSE(film.add(0, 0, {6, 1}, {1.F, 1.F, -inf}));
  EXPECT_FALSE(film.splat(0, 0, {6.F, 1.F}, {inf, 1.F, 1.F}));
  EXPECT_FALSE(film.splat(0, 0, {nan, 1.F}, Spectrum(1.F)));
  EXPECT_FALSE(film.splat(0, 0, {1.F, inf}, Spectrum(1.F)));
  EXPECT_FALSE(film.add(0, 0, {6, 1}, {1.F, 1.F, 1e30F})) << "beyond 2^30 times the magnitude";
  EXPECT_EQ(std::count(film.raw().begin(), film.raw().end(), 0),
            static_cast<std::ptrdiff_t>(film.raw().size()));
  EXPECT_TRUE(film.add(0, 0, {6, 1}, Spectrum(-1e9F))) << "negative lobes are contributions, too";
}

TEST(Film, SaturatesInsteadOfWrappingAround) {
  Film film({1, 1}, Box2i({0, 0}, {0, 0}), Filter::box(), 1, {{"direct"}});
  const Spectrum huge(static_cast<float>(1 << 30));
  int accepted = 0;
  for (int i = 0; i < 1000; ++i) accepted += film.add(0, 0, {0, 0}, huge) ? 1 : 0;
  EXPECT_EQ(accepted, 256) << "2^38 / 2^30";
  EXPECT_EQ(film.develop(0, 1.0)[0], 0x1p38F);
}

TEST(Film, QuantumFollowsTheMagnitude) {
  Film film({1, 1}, Box2i({0, 0}, {0, 0}), Filter::box(), 1,
            {{"dim", true, 1e-9}, {"bright", true, 1e9}, {"odd", false, 3.0}});
  ASSERT_TRUE(film.add(0, 0, {0, 0}, Spectrum(1.234e-9F)));
  ASSERT_TRUE(film.add(1, 0, {0, 0}, Spectrum(1.234e9F)));
  ASSERT_TRUE(film.add(2, 0, {0, 0}, Spectrum(3.F)));
  EXPECT_NEAR(film.develop(0, 1.0)[0] / 1.234e-9, 1.0, 1e-7);
  EXPECT_NEAR(film.develop(1, 1.0)[0] / 1.234e9, 1.0, 1e-7);
  EXPECT_EQ(film.raw()[6], 3 << 23) << "the quantum is 2^(1 − 24)";
}

TEST(Film, AddsAnotherFilmWhoseMagnitudeDiffers) {
  const Vec2i size(3, 2);
  const Box2i crop(Vec2i(0, 0), Vec2i(2, 1));
  const auto film_of = [&](double magnitude, float value) {
    Film film(size, crop, Filter::box(), 2, {LayerSpec{.name = "a", .magnitude = magnitude}});
    film.add(0, 1, Vec2i(2, 1), Spectrum(value));
    return film;
  };
  Film fine = film_of(0.25, 0.5F);
  fine.add(film_of(64.0, -3.0F));
  EXPECT_EQ(fine.develop_replicate(0, 1, 1.0).back(), -2.5F) << "a coarser one: exactly";
  Film coarse = film_of(64.0, 0.5F);
  coarse.add(film_of(0.25, 0.3F));
  EXPECT_NEAR(coarse.develop_replicate(0, 1, 1.0).back(), 0.8F, 64.0 * 0x1p-24);
  EXPECT_EQ(coarse.develop_replicate(0, 0, 1.0).back(), 0.F);
  Film other(size, crop, Filter::box(), 2, {LayerSpec{.name = "b"}});
  EXPECT_THROW(fine.add(other), std::invalid_argument);
}

TEST(Film, RefusesImpossibleShapes) {
  const auto film = [](const Box2i& crop, int replicates, double magnitude) {
    return Film({4, 4}, crop, Filter::box(), replicates, {{"direct", true, magnitude}});
  };
  EXPECT_THROW(film(Box2i({0, 0}, {4, 3}), 1, 1.0), std::invalid_argument);
  EXPECT_THROW(film(Box2i({-1, 0}, {3, 3}), 1, 1.0), std::invalid_argument);
  EXPECT_THROW(film(Box2i({2, 0}, {1, 3}), 1, 1.0), std::invalid_argument);
  EXPECT_THROW(film(Box2i({0, 0}, {3, 3}), 0, 1.0), std::invalid_argument);
  EXPECT_THROW(film(Box2i({0, 0}, {3, 3}), 1, 0.0), std::invalid_argument);
  EXPECT_THROW(Film({1, 1}, Box2i({0, 0}, {0, 0}), Filter::box(), 2, {{"a", false}})
                   .develop_replicate(0, 0, 1.0),
               std::invalid_argument);
}

TEST(Film, CoverageIsOneInsideAndFallsTowardTheBorder) {
  const Vec2i size(6, 5);
  const Box2i crop(Vec2i(1, 1), Vec2i(4, 4));
  const Film boxes(size, crop, Filter::box(), 1, {{.name = "light"}});
  EXPECT_FLOAT_EQ(boxes.coverage(Vec2(1.F, 1.F)), 1.F);
  EXPECT_FLOAT_EQ(boxes.coverage(Vec2(4.99F, 3.2F)), 1.F);
  EXPECT_FLOAT_EQ(boxes.coverage(Vec2(0.99F, 2.F)), 0.F);
  const Film triangles(size, crop, Filter::triangle(Vec2(1.F, 1.F)), 1, {{.name = "light"}});
  EXPECT_NEAR(triangles.coverage(Vec2(2.7F, 3.1F)), 1.F, 1e-5);
  EXPECT_NEAR(triangles.coverage(Vec2(1.F, 3.F)), 0.5F, 1e-5);
  EXPECT_NEAR(triangles.coverage(Vec2(1.F, 1.F)), 0.25F, 1e-5);
}

}  // namespace
}  // namespace ajar
