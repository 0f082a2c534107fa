#include "integrator/technique_shares.h"

#include <gtest/gtest.h>

namespace ajar {
namespace {

TEST(TechniqueShares, AreSummable) {
  TechniqueShares a;
  TechniqueShares b;
  a.add(TechniqueShares::slot({0, 2}), 1.0, 3.0);
  b.add(TechniqueShares::slot({0, 2}), 1.0, 0.0);
  b.add(TechniqueShares::slot({1, 2}), 2.0, 1.0);
  a += b;
  a += TechniqueShares();
  const auto shares = a.list();
  ASSERT_EQ(shares.size(), 2U);
  EXPECT_EQ(shares[0].light, 0.5);
  EXPECT_EQ(shares[0].variance, 0.75);
}

}  // namespace
}  // namespace ajar
