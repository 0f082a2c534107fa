#include "core/random_use.h"

#include <gtest/gtest.h>

#pragma GCC diagnostic error "-Wswitch"

namespace ajar {
namespace {

/// Two uses of one number would be the same label twice, and one that is missing here would be no
/// label: neither compiles.
bool is_named(RandomUse use) {
  switch (use) {
    case RandomUse::LightSubpaths:
    case RandomUse::LightScramble:
    case RandomUse::PictureScale:
    case RandomUse::StrongCameraPath:
    case RandomUse::StrongLightPath:
    case RandomUse::Bootstrap:
    case RandomUse::Seeds:
    case RandomUse::Chain:
    case RandomUse::DarkPilot:
    case RandomUse::StepLength:
    case RandomUse::RasterMove:
    case RandomUse::RasterLength:
    case RandomUse::PathMutation:
    case RandomUse::PathNumbers:
    case RandomUse::EnergySamples:
    case RandomUse::PathSeed:
    case RandomUse::ManifoldSeed:
    case RandomUse::SpecularPhotons:
    case RandomUse::BrightnessPilot:
    case RandomUse::DivisionPilot:
    case RandomUse::SurfacePilot:
    case RandomUse::RouletteScramble:
    case RandomUse::TechniqueTrial:
    case RandomUse::TechniqueLight:
    case RandomUse::SeedRoulette:
    case RandomUse::PilotRoulette:
    case RandomUse::SeedReplicate:
    case RandomUse::SeedResampling:
    case RandomUse::Features:
      return true;
  }
  return false;
}

TEST(RandomUse, EachHasANumberOfItsOwn) { EXPECT_TRUE(is_named(RandomUse::Bootstrap)); }

}  // namespace
}  // namespace ajar
