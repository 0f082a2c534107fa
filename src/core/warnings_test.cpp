#include "core/warnings.h"

#include <gtest/gtest.h>

#include <thread>

namespace ajar {
namespace {

TEST(Warnings, CountsAllAndKeepsSome) {
  Warnings warnings;
  std::vector<std::thread> threads;
  threads.reserve(4);
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&warnings] {
      for (int i = 0; i < 100; ++i) warnings.add("same text");
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(warnings.count(), 400U);
  EXPECT_EQ(warnings.messages().size(), Warnings::kMaxKept);
}

TEST(Warnings, KeepsThePlace) {
  Warnings warnings;
  warnings.add({std::make_shared<const std::string>("a.pbrt"), 4, 1}, "unused parameter");
  ASSERT_EQ(warnings.messages().size(), 1U);
  EXPECT_EQ(warnings.messages()[0], "a.pbrt:4:1: unused parameter");
}

}  // namespace
}  // namespace ajar
