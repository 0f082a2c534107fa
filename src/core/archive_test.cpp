#include "core/archive.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <map>
#include <optional>

namespace ajar {
namespace {

struct Part {
  std::string name;
  double value = 0.0;
  bool operator==(const Part&) const = default;
};
template <Archive A>
void serialize(A& archive, Part& part) {
  archive(part.name, part.value);
}

struct Whole {
  std::vector<Part> parts;
  std::vector<float> numbers;
  std::vector<std::vector<std::uint8_t>> nested;
  std::map<std::string, std::string> names;
  std::optional<double> perhaps;
  std::array<std::uint64_t, 2> pair{};
  bool yes = false;
  bool operator==(const Whole&) const = default;
};
template <Archive A>
void serialize(A& archive, Whole& whole) {
  archive(whole.parts, whole.numbers, whole.nested, whole.names, whole.perhaps, whole.pair,
          whole.yes);
}

const Whole kWhole{{{"a", 1.5}, {"", -0.0}},
                   {1.F, 2.F},
                   {{}, {1, 2}},
                   {{"k", "v"}, {"l", ""}},
                   0.25,
                   {7, 8},
                   true};

std::string bytes_of(const Whole& whole) {
  return archived([&](OutputArchive& archive) { archive(whole); });
}

Whole read(const std::string& bytes) {
  Whole whole;
  unarchive(bytes, [&](InputArchive& archive) { archive(whole); });
  return whole;
}

/// Expects an error from an archive that ends after `write`.
template <typename Value, typename Write>
void expect_refused(const Write& write) {
  const std::string bytes = archived(write);
  Value value;
  EXPECT_THROW(unarchive(bytes, [&](InputArchive& archive) { archive(value); }),
               std::runtime_error);
}

TEST(Archive, GivesBackWhatWasWritten) { EXPECT_EQ(read(bytes_of(kWhole)), kWhole); }

TEST(Archive, IsRefusedWhereverItIsCutShortAndIfSomethingIsAdded) {
  const std::string whole = bytes_of(kWhole);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_THROW(read(whole.substr(0, size)), std::runtime_error) << size;
  }
  EXPECT_THROW(read(whole + '\0'), std::runtime_error);
}

TEST(Archive, ClaimsOfSizeAreNotBelieved) {
  // Lengths beyond the elements that follow; memory for them would be up to 2^64 times as much.
  for (const std::uint64_t claim :
       {std::uint64_t{3}, std::uint64_t{1} << 32, std::uint64_t{1} << 61,
        std::numeric_limits<std::uint64_t>::max()}) {
    const auto write = [&](OutputArchive& archive) { archive(claim, 1.0, 2.0); };
    expect_refused<std::vector<double>>(write);
    expect_refused<std::vector<float>>([&](OutputArchive& archive) { archive(claim, 1.F, 2.F); });
    expect_refused<std::vector<std::vector<double>>>(
        [&](OutputArchive& archive) { archive(claim, std::vector<double>{1.0}); });
    expect_refused<std::vector<Part>>(
        [&](OutputArchive& archive) { archive(claim, kWhole.parts[0]); });
    expect_refused<std::string>([&](OutputArchive& archive) { archive(claim, 'a', 'b'); });
    expect_refused<std::map<std::string, std::string>>(
        [&](OutputArchive& archive) { archive(claim, std::string("k"), std::string("v")); });
  }
}

TEST(Archive, OnlyBoolsAreBools) {
  expect_refused<bool>([](OutputArchive& archive) { archive(std::uint8_t{2}); });
  expect_refused<std::optional<double>>(
      [](OutputArchive& archive) { archive(std::uint8_t{255}, 1.0); });
}

}  // namespace
}  // namespace ajar
