#include <gtest/gtest.h>

#include <map>
#include <string>

#include "core/error.h"
#include "support/render.h"
#include "support/small_scenes.h"

/// `erpt` has chains of two kinds, with separate parameters for their moves.
namespace ajar {
namespace {

TEST(ErptParameters, AreThoseOfItsKindOfChain) {
  const auto scene = test::scene_from(test::small_scene("Room").text);
  const std::map<std::string, std::map<std::string, std::string>> cases = {
      {"manifold: only with chain=mlt, not chain=pssmlt",
       {{"chain", "pssmlt"}, {"manifold", "0.5"}}},
      {"sigma: only with chain=pssmlt, not chain=mlt", {{"chain", "mlt"}, {"sigma", "0.02"}}}};
  for (const auto& [message, parameters] : cases) {
    test::RenderOptions options;
    options.integrator = "erpt";
    for (const auto& [name, value] : parameters) options.parameters[name] = value;
    try {
      test::render(*scene, options);
      ADD_FAILURE() << message;
    } catch (const UsageError& error) {
      EXPECT_EQ(std::string(error.what()), message);
    }
  }
}

}  // namespace
}  // namespace ajar
