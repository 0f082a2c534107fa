#include "transport/technique_set.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace ajar {
namespace {

TEST(TechniqueSet, NamesDenoteTheSetsOfTheFamily) {
  for (int s = 0; s <= 5; ++s) {
    for (int t = 0; t <= 5; ++t) {
      EXPECT_EQ(TechniqueSet::parse("pt").count({s, t}), TechniqueSet::pt().count({s, t}));
      EXPECT_EQ(TechniqueSet::parse("implicit,explicit,light").count({s, t}),
                TechniqueSet::ibpt().count({s, t}));
      EXPECT_EQ(TechniqueSet::parse("ibpt, inner").count({s, t}),
                TechniqueSet::bdpt().count({s, t}));
    }
  }
}

TEST(TechniqueSet, DirectVisibilityAlwaysBelongsAndImpossiblePairsNever) {
  for (const char* text : {"pt", "lt", "bdpt", "(2,1)", "(*,1)", "(*,*)"}) {
    const TechniqueSet set = TechniqueSet::parse(text);
    EXPECT_TRUE(set.enabled({0, 2})) << text;
    EXPECT_FALSE(set.enabled({1, 1})) << text;
    EXPECT_FALSE(set.enabled({3, 0})) << text;
    EXPECT_FALSE(set.enabled({0, 1})) << text;
  }
}

TEST(TechniqueSet, PairsAddSingleTechniques) {
  const TechniqueSet set = TechniqueSet::parse("implicit,(2,1),(3,*)");
  EXPECT_TRUE(set.enabled({0, 4}));
  EXPECT_TRUE(set.enabled({2, 1}));
  EXPECT_FALSE(set.enabled({4, 1}));
  EXPECT_FALSE(set.enabled({2, 2}));
  EXPECT_TRUE(set.enabled({3, 1}));
  EXPECT_TRUE(set.enabled({3, 7}));
  EXPECT_FALSE(set.enabled({1, 2}));
  EXPECT_FALSE(set.uniform());
  EXPECT_TRUE(set.any(TechniqueClass::Light));
  EXPECT_TRUE(set.any(TechniqueClass::Inner));
  EXPECT_FALSE(set.any(TechniqueClass::NextEvent));
}

TEST(TechniqueSet, CountsBelongToClassesAndPairs) {
  const TechniqueSet set = TechniqueSet::parse("implicit,explicit*4,inner*0.5,(2,*)*0.25,(2,2)");
  EXPECT_EQ(set.count({1, 3}), 4.0);
  EXPECT_EQ(set.count({3, 3}), 0.5);
  EXPECT_EQ(set.count({2, 3}), 0.25);
  EXPECT_EQ(set.count({2, 2}), 1.0) << "exact pairs come first";
}

TEST(TechniqueSet, ErrorsListAllowedValues) {
  for (const char* text : {"",
                           "explcit",
                           "pt,",
                           "(2,1",
                           "(2;1)",
                           "(2,0)",
                           "(1,1)",
                           "(x,1)",
                           "(2,-1)",
                           "explicit*0",
                           "explicit*-1",
                           "explicit*x",
                           "explicit*100",
                           "light*2",
                           "inner*1.5",
                           "implicit*2",
                           "(0,*)*2",
                           "(*,1)*2",
                           "explicit*nan",
                           "(1.5,2)",
                           "()"}) {
    try {
      TechniqueSet::parse(text);
      ADD_FAILURE() << "accepted \"" << text << '"';
    } catch (const UsageError& error) {
      EXPECT_NE(std::string(error.what()).find("implicit"), std::string::npos) << error.what();
    }
  }
}

TEST(TechniqueSet, ReportsWhetherEachTechniqueIsTriedOnce) {
  for (const char* text : {"pt", "bdpt", "implicit,light", "(0,*),(1,2),(*,1)"}) {
    EXPECT_TRUE(TechniqueSet::parse(text).tries_once()) << text;
  }
  for (const char* text : {"explicit*2", "pt,light*0.5", "bdpt,(2,2)*0.3"}) {
    EXPECT_FALSE(TechniqueSet::parse(text).tries_once()) << text;
  }
}

}  // namespace
}  // namespace ajar
