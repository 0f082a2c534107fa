#pragma once
#include <cstdint>

namespace ajar {

/// Uses of random numbers beside those of the paths themselves: hashed together with the seed of
/// its owner (`hash_numbers`), so that no two uses share their numbers. A picture's bits depend on
/// these values.
enum class RandomUse : std::uint64_t {
  // Ordinary Monte Carlo.
  LightSubpaths = 0x11987,  ///< light subpaths of a replicate
  LightScramble = 0x1e45,   ///< their points
  PictureScale = 0x9170,    ///< samples for the brightness of the picture
  StrongCameraPath = 0x57706,
  StrongLightPath = 0x57707,
  // Markov chains.
  Bootstrap = 0xb0075,
  Seeds = 0x5eed,       ///< systematic resampling
  Chain = 0xc4a15,      ///< a chain's own seed
  StepLength = 0x1e46,  ///< length of small steps; beyond the keys of tries
  RasterMove = 0x7a57e7,
  RasterLength = 0x1e467,
  PathMutation = 0x9a7b1,  ///< choice among the mutations of paths
  PathNumbers = 0x9a7b2,   ///< by which it makes another
  EnergySamples = 0xe59,
  PathSeed = 0x9a7b3,  ///< choice of a path of a bootstrap sample
  ManifoldSeed = 0x3a9f01d,
  SpecularPhotons = 0x9405,
  // The preparation of divided light.
  BrightnessPilot = 0x91107,
  DarkPilot = 0x91a17,
  DivisionPilot = 0x9e9107,
  SurfacePilot = 0x50fa3,
  RouletteScramble = 1,  ///< their points
  TechniqueTrial = 0x11997,
  TechniqueLight = 0x711e5,  ///< light subpaths of a place
  // The seed reservoir.
  SeedRoulette = 0x6a1e,
  PilotRoulette = 0xf09d,
  SeedReplicate = 0x5ca77,
  SeedResampling = 0x10e5,
  // After the render.
  Features = 0xfea7,
};

}  // namespace ajar
