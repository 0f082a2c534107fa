#include "transport/efficiency_cells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>
#include <vector>

#include "core/archive.h"
#include "transport/heuristics.h"

namespace ajar {
namespace {

const Box3 kScene(Vec3(-1.F, -1.F, -1.F), Vec3(1.F, 1.F, 1.F));

/// A vertex in a medium.
PathVertex vertex_at(const Vec3& p) {
  PathVertex vertex;
  vertex.p = p;
  vertex.wo = {0.F, 0.F, 1.F};
  vertex.in_medium = true;
  return vertex;
}

/// Samples that bring 1 or 3, with 2 rays each.
void tell(EfficiencyCells& cells, const Vec3& p, int samples, double scale = 1.0) {
  const std::uint32_t cell = cells.find(vertex_at(p));
  for (int i = 0; i < samples; ++i) {
    const double light = scale * (i % 2 == 0 ? 1.0 : 3.0);
    cells.add(cell, false, light, 2);
  }
}

EfficiencyCells::Worth worth_at(const EfficiencyCells& cells, const Vec3& p) {
  return cells.worth(cells.find(vertex_at(p)));
}

std::string saved(const EfficiencyCells& cells) {
  std::ostringstream stream;
  OutputArchive archive(stream);
  cells.save_state(archive);
  return stream.str();
}

std::string delta_of(EfficiencyCells& cells) {
  std::ostringstream stream;
  OutputArchive archive(stream);
  cells.export_delta(archive);
  return stream.str();
}

void take(EfficiencyCells& cells, const std::string& delta) {
  InputArchive archive(delta);
  cells.import_delta(archive);
}

TEST(EfficiencyCells, KnowRootsOfMomentsOverRays) {
  // Lamps and units of all strengths: moments follow them.
  for (const double scale : {1e-3, 1.0, 1e5}) {
    EfficiencyCells cells(kScene, scale);
    tell(cells, {0.F, 0.F, 0.F}, 100, scale);
    EXPECT_EQ(worth_at(cells, {0.F, 0.F, 0.F})[0], 0.F) << "it is frozen";
    cells.end_round();
    const EfficiencyCells::Worth worth = worth_at(cells, {0.F, 0.F, 0.F});
    EXPECT_NEAR(worth[0] / scale, std::sqrt(5.0 / 2.0), 1e-4);
    EXPECT_EQ(worth[1], 0.F) << "no specular lobe was seen";
  }
}

TEST(EfficiencyCells, SayNothingOfFewSamples) {
  EfficiencyCells cells(kScene, 1.0);
  tell(cells, {0.F, 0.F, 0.F}, TransportHeuristics::kFewestSamplesOfCell - 1);
  cells.end_round();
  EXPECT_EQ(worth_at(cells, {0.F, 0.F, 0.F})[0], 0.F);
}

/// Black is known to be black, which is not the same as not to be known.
TEST(EfficiencyCells, KnowThatNothingComes) {
  EfficiencyCells cells(kScene, 1.0);
  const std::uint32_t cell = cells.find(vertex_at({0.F, 0.F, 0.F}));
  for (int i = 0; i < 1000; ++i) cells.add(cell, false, 0.0, 3);
  cells.end_round();
  EXPECT_GT(worth_at(cells, {0.F, 0.F, 0.F})[0], 0.F);
  EXPECT_LT(worth_at(cells, {0.F, 0.F, 0.F})[0], 1e-3F);
}

TEST(EfficiencyCells, BoundFireflies) {
  EfficiencyCells cells(kScene, 1.0);
  tell(cells, {0.F, 0.F, 0.F}, 1000);
  cells.add(cells.find(vertex_at({0.F, 0.F, 0.F})), false, 1e30, 2);
  cells.add(cells.find(vertex_at({0.F, 0.F, 0.F})), false, std::nan(""), 2);
  cells.end_round();
  EXPECT_GT(worth_at(cells, {0.F, 0.F, 0.F})[0], std::sqrt(5.F / 2.F));
  EXPECT_LT(worth_at(cells, {0.F, 0.F, 0.F})[0], 7.F);
}

TEST(EfficiencyCells, TellPlacesApartThatManySamplesVisit) {
  EfficiencyCells cells(kScene, 1.0);
  const Vec3 bright(0.9F, 0.9F, 0.9F);
  const Vec3 dark(-0.9F, 0.9F, 0.9F);
  const int many = static_cast<int>(TransportHeuristics::kMostSamplesOfLeaf);
  for (int round = 0; round < 6; ++round) {
    tell(cells, bright, many);
    tell(cells, dark, many, 0.1);
    cells.end_round();
  }
  EXPECT_GT(cells.cells(), 8U);
  EXPECT_NE(cells.find(vertex_at(bright)), cells.find(vertex_at(dark)));
  EXPECT_NEAR(worth_at(cells, bright)[0], std::sqrt(5.0 / 2.0), 0.02);
  EXPECT_NEAR(worth_at(cells, dark)[0], 0.1 * std::sqrt(5.0 / 2.0), 0.02);
  // Places beyond the scene are those at its border.
  EXPECT_EQ(cells.find(vertex_at({9.F, 9.F, 9.F})), cells.find(vertex_at({1.F, 1.F, 1.F})));
}

/// One place only, until no leaf can be divided any more.
TEST(EfficiencyCells, DivideNoFurtherThanPlacesGo) {
  EfficiencyCells cells(kScene, 1.0);
  const std::uint32_t before = cells.find(vertex_at({1.F, 1.F, 1.F}));
  for (int round = 0; round < 40; ++round) {
    tell(cells, {1.F, 1.F, 1.F}, 9 * static_cast<int>(TransportHeuristics::kMostSamplesOfLeaf));
    cells.end_round();
  }
  EXPECT_NE(cells.find(vertex_at({1.F, 1.F, 1.F})), before);
  EXPECT_NEAR(worth_at(cells, {1.F, 1.F, 1.F})[0], std::sqrt(5.0 / 2.0), 0.02);
}

TEST(EfficiencyCells, GoOnFromACheckpoint) {
  EfficiencyCells cells(kScene, 1.0);
  const int many = 2 * static_cast<int>(TransportHeuristics::kMostSamplesOfLeaf);
  tell(cells, {0.5F, 0.5F, 0.5F}, many);
  cells.end_round();
  tell(cells, {-0.5F, 0.5F, 0.5F}, 1000);
  const std::string state = saved(cells);
  EfficiencyCells loaded(kScene, 1.0);
  InputArchive archive(state);
  loaded.load_state(archive);
  for (EfficiencyCells* each : {&cells, &loaded}) {
    tell(*each, {0.5F, -0.5F, 0.5F}, many);
    each->end_round();
  }
  EXPECT_EQ(saved(loaded), saved(cells));
}

/// No bytes crash it: whatever is accepted can be asked for any place.
TEST(EfficiencyCells, RefuseTreesThatCannotBe) {
  EfficiencyCells cells(kScene, 1.0);
  tell(cells, {0.5F, 0.5F, 0.5F}, 2 * static_cast<int>(TransportHeuristics::kMostSamplesOfLeaf));
  cells.end_round();
  const std::string state = saved(cells);
  std::mt19937 random(5);
  int refused = 0;
  for (int i = 0; i < 2000; ++i) {
    std::string bytes = state;
    bytes[random() % std::min<std::size_t>(bytes.size(), 140)] ^=
        static_cast<char>(1U << random() % 8);
    EfficiencyCells loaded(kScene, 1.0);
    try {
      InputArchive archive(bytes);
      loaded.load_state(archive);
    } catch (const std::exception&) {
      ++refused;
      continue;
    }
    for (const float x : {-1.F, -0.1F, 0.1F, 1.F}) {
      EXPECT_LT(loaded.find(vertex_at({x, 0.3F, -0.7F})), loaded.cells());
    }
    tell(loaded, {0.5F, 0.5F, 0.5F}, 10);
    loaded.end_round();
  }
  EXPECT_GT(refused, 500);
}

TEST(EfficiencyCells, SumOverProcesses) {
  EfficiencyCells alone(kScene, 1.0);
  EfficiencyCells first(kScene, 1.0);
  EfficiencyCells second(kScene, 1.0);
  const int many = static_cast<int>(TransportHeuristics::kMostSamplesOfLeaf);
  for (int round = 0; round < 3; ++round) {
    for (int pass = 0; pass < 2; ++pass) {
      tell(alone, {0.5F, 0.5F, 0.5F}, many);
      tell(alone, {0.5F, -0.5F, 0.5F}, many + pass);
      tell(first, {0.5F, 0.5F, 0.5F}, many);
      tell(second, {0.5F, -0.5F, 0.5F}, many + pass);
      const std::vector<std::string> deltas = {delta_of(first), delta_of(second)};
      for (const std::string& delta : deltas) {
        take(first, delta);
        take(second, delta);
      }
    }
    for (EfficiencyCells* each : {&alone, &first, &second}) each->end_round();
    EXPECT_EQ(saved(first), saved(alone));
    EXPECT_EQ(saved(second), saved(alone));
  }
}

/// A sample of a pixel has a part without choices, of variance `v0` and `c0` rays, and with
/// probability q another of second moment `m` and mean `mean`, weighted by 1/q, of `c` rays.
struct ToyPixel {
  double v0, c0, m, mean, c;
  double variance(double q) const { return v0 + m / q - mean * mean; }
  double rays(double q) const { return c0 + q * c; }
  double inefficiency(double q) const { return variance(q) * rays(q); }
};

/// The fixed point of the rounds is where variance · rays is smallest.
TEST(EfficiencyCells, LeadToTheLeastVarianceTimesRays) {
  for (const ToyPixel& pixel :
       {ToyPixel{10.0, 1.0, 0.5, 0.6, 4.0}, ToyPixel{1.0, 2.0, 0.2, 0.3, 9.0},
        ToyPixel{2.0, 4.0, 2.0, 0.8, 20.0}}) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    EfficiencyCells cells(kScene, 8.0);
    const std::uint32_t cell = cells.find(vertex_at({0.F, 0.F, 0.F}));
    double q = 1.0;
    for (int round = 0; round < 12; ++round) {
      for (int i = 0; i < 4000; ++i) {
        const double spread = std::sqrt(pixel.m - pixel.mean * pixel.mean);
        cells.add(cell, false, std::abs(pixel.mean + spread * normal(random)),
                  static_cast<std::uint64_t>(pixel.c));
      }
      cells.end_round();
      const double price = std::sqrt(pixel.variance(q) / pixel.rays(q));
      q = std::min(1.0, static_cast<double>(worth_at(cells, {0.F, 0.F, 0.F})[0]) / price);
    }
    double least = pixel.inefficiency(1.0);
    for (double other = 0.05; other < 1.0; other *= 1.01) {
      least = std::min(least, pixel.inefficiency(other));
    }
    EXPECT_LT(pixel.inefficiency(q), 1.05 * least);
    EXPECT_LT(least, 0.98 * pixel.inefficiency(1.0)) << "nothing to be found";
  }
}

}  // namespace
}  // namespace ajar
