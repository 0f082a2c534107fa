#include "image/identities.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>
#include <vector>

namespace ajar {
namespace {

constexpr int kPictureWidth = 3;
constexpr int kPictureHeight = 2;

/// Not square, and a crop in the middle of a larger picture.
Film make_film(std::initializer_list<const char*> names) {
  std::vector<LayerSpec> specs = {{.name = "direct"}};
  for (const char* name : names) {
    for (LayerSpec& spec : IdentityLayers::specs(name)) specs.push_back(std::move(spec));
  }
  return Film({9, 7}, Box2i({4, 3}, {4 + kPictureWidth - 1, 3 + kPictureHeight - 1}), Filter::box(),
              4, specs);
}

/// Identities that the samples of a pixel saw, in order.
void add(Film& film, const std::string& name, Vec2i pixel, const std::vector<unsigned>& numbers) {
  const IdentityLayers layers(film, name);
  for (std::size_t i = 0; i < numbers.size(); ++i) layers.add(film, pixel, i, numbers[i]);
}

/// The majority among the samples of one pixel.
float majority_of(const std::vector<unsigned>& numbers) {
  Film film = make_film({"object-id"});
  add(film, "object-id", {5, 4}, numbers);
  return majority_numbers(film, "object-id")[kPictureWidth + 1];
}

TEST(MajorityNumbers, AreTheMostFrequentNumbers) {
  EXPECT_EQ(majority_of({7}), 7.F);
  EXPECT_EQ(majority_of({7, 3, 3}), 3.F);
  EXPECT_EQ(majority_of({1, 2, 3, 4, 5, 6, 7, 8, 8}), 8.F);
  EXPECT_EQ(majority_of({1, 1, 1, 2, 2, 2, 2, 3, 3}), 2.F);
}

TEST(MajorityNumbers, AreThoseOfNothingWhereTheFilmHoldsNone) {
  // Numbers that a corrupt checkpoint may have: halves, less than nothing, and beyond any number.
  for (const std::int64_t sum :
       {std::int64_t{1} << 23, -(std::int64_t{1} << 60), std::int64_t{1} << 60}) {
    Film film = make_film({"object-id"});
    std::fill(film.raw().begin(), film.raw().end(), sum);
    EXPECT_EQ(majority_numbers(film, "object-id"),
              std::vector<float>(kPictureWidth * kPictureHeight, 0.F));
  }
}

TEST(MajorityNumbers, CountSamplesThatHitNothing) {
  EXPECT_EQ(majority_of({0, 5, 0, 5, 0}), 0.F);
  EXPECT_EQ(majority_of({0, 5, 5}), 5.F);
}

TEST(MajorityNumbers, DoNotCountSamplesThatWereNotTaken) {
  EXPECT_EQ(majority_of({}), 0.F);
  EXPECT_EQ(majority_of({4, 4}), 4.F) << "seven samples are missing";
}

TEST(MajorityNumbers, AreThoseOfTheEarliestSampleWhereSeveralTie) {
  EXPECT_EQ(majority_of({6, 2}), 6.F);
  EXPECT_EQ(majority_of({9, 2, 6, 6, 2}), 2.F);
  EXPECT_EQ(majority_of({0, 3}), 0.F);
}

TEST(MajorityNumbers, AreOfTheFirstNineSamplesOnly) {
  EXPECT_EQ(majority_of({1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2}), 1.F);
}

TEST(MajorityNumbers, AreExactForLargeNumbers) {
  const unsigned largest = (1U << 24U) - 2U;
  EXPECT_EQ(majority_of({largest - 1, largest, largest}), static_cast<float>(largest));
}

TEST(MajorityNumbers, BelongToTheirPixels) {
  Film film = make_film({"object-id"});
  for (int y = 0; y < kPictureHeight; ++y) {
    for (int x = 0; x < kPictureWidth; ++x) {
      const auto number = static_cast<unsigned>(10 * y + x + 1);
      add(film, "object-id", {4 + x, 3 + y}, {99, number, number});
    }
  }
  EXPECT_EQ(majority_numbers(film, "object-id"), (std::vector<float>{1, 2, 3, 11, 12, 13}));
}

TEST(MajorityNumbers, DoNotDependOnTheOrderOfSamples) {
  std::mt19937 generator(2);
  std::vector<std::size_t> order = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  const std::vector<unsigned> numbers = {3, 1, 1, 3, 0, 2, 2, 0, 5, 1, 1, 1};
  for (int run = 0; run < 20; ++run) {
    std::shuffle(order.begin(), order.end(), generator);
    Film film = make_film({"object-id"});
    const IdentityLayers layers(film, "object-id");
    for (const std::size_t i : order) layers.add(film, {4, 3}, i, numbers[i]);
    EXPECT_EQ(majority_numbers(film, "object-id")[0], 3.F);
  }
}

TEST(MajorityNumbers, NeedTheirLayer) {
  EXPECT_THROW(majority_numbers(make_film({"material-id"}), "object-id"), std::invalid_argument);
  Film film = make_film({});
  const IdentityLayers layers(film, "object-id");
  EXPECT_TRUE(layers.empty());
  layers.add(film, {4, 3}, 0, 1);
  EXPECT_TRUE(std::all_of(film.raw().begin(), film.raw().end(), [](auto sum) { return sum == 0; }));
}

TEST(MajorityIdentities, AreMajoritiesOfPairs) {
  // Most samples see object 1, most see material 2; but most of all pairs is (3, 2).
  Film film = make_film({"object-id", "material-id"});
  add(film, "object-id", {4, 3}, {1, 1, 1, 1, 3, 3, 3});
  add(film, "material-id", {4, 3}, {4, 4, 5, 5, 2, 2, 2});
  EXPECT_EQ(majority_numbers(film, "object-id")[0], 1.F);
  EXPECT_EQ(majority_numbers(film, "material-id")[0], 2.F);
  const std::vector<PixelIdentity> identities = majority_identities(film);
  ASSERT_EQ(identities.size(), 6U);
  EXPECT_EQ(identities[0], (PixelIdentity{3, 2}));
  EXPECT_EQ(identities[1], PixelIdentity());
  EXPECT_THROW(majority_identities(make_film({"object-id"})), std::invalid_argument);
}

}  // namespace
}  // namespace ajar
