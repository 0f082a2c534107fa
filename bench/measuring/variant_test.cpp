#include "measuring/variant.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace ajar::bench {
namespace {

TEST(Variant, IsAnIntegratorAlone) {
  const Variant variant = parse_variant("ibpt");
  EXPECT_EQ(variant.integrator->name, "ibpt");
  EXPECT_EQ(variant.parameters.values(), Parameters(variant.integrator->parameters, {}).values());
}

TEST(Variant, HasSettings) {
  const Variant variant = parse_variant("bdpt:heuristic=balance,roulette-start=8");
  EXPECT_EQ(variant.integrator->name, "bdpt");
  EXPECT_EQ(variant.parameters.get_text("heuristic"), "balance");
  EXPECT_EQ(variant.parameters.get_int("roulette-start"), 8);
  EXPECT_EQ(variant.text, "bdpt:heuristic=balance,roulette-start=8");
}

TEST(Variant, ValuesMayHaveCommas) {
  // The value is wrong for this parameter, and the message says how it was read.
  try {
    parse_variant("bdpt:heuristic=implicit,light,roulette-start=8");
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("\"implicit,light\""), std::string::npos)
        << error.what();
  }
}

TEST(Variant, InvalidOnesAreRefused) {
  for (const char* text : {"", "no-such-thing", "pt:", "pt:heuristic", "pt:no-such=1", ":",
                           "pt:heuristic=no-such", "pt:roulette-start=many"}) {
    EXPECT_THROW(parse_variant(text), UsageError) << text;
  }
}

}  // namespace
}  // namespace ajar::bench
