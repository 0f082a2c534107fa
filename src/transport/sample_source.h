#pragma once
#include <algorithm>
#include <cstdint>
#include <stdexcept>

#include "core/vector.h"

namespace ajar {

/// The part of a path a random number belongs to.
enum class Stream : std::uint8_t { Camera, Light, Connection };

/// The uses of random numbers at one vertex of a path. Each slot is one number; a pair `X, Y` is
/// two, the first of them even.
enum class Slot : std::uint8_t {
  BsdfDirectionX,
  BsdfDirectionY,
  LightPositionX,
  LightPositionY,
  BsdfLobe,
  LightChoice,
  LightPrimitive,
  Roulette,
  MediumLane,  ///< at `kLaneChoice` only
  MediumDistance,
  kCount
};
/// Endpoints (vertex 0) use the same slots under other names.
inline constexpr Slot kEmissionDirection = Slot::BsdfDirectionX;
inline constexpr Slot kEmissionPosition = Slot::LightPositionX;
inline constexpr Slot kEmissionPrimitive = Slot::LightPrimitive;
inline constexpr Slot kEmitterChoice = Slot::LightChoice;
/// Connections (`Stream::Connection`, vertex: see `PathSampler`) decide by these whether they are
/// tried at all, and whether weak ones are traced.
inline constexpr Slot kConnectionTry = Slot::BsdfLobe;
inline constexpr Slot kConnectionCull = Slot::Roulette;

/// Name of one uniform number of the primary vector. Addresses never shift when one end of a path
/// changes. Kept in one integer: small members would be written one by one and read as a whole, for
/// which processors wait.
class SampleAddress {
 public:
  constexpr SampleAddress(Stream stream, int vertex, Slot slot, int repeat = 0)
      : bits_(static_cast<std::uint32_t>(stream) << 30U |
              (static_cast<std::uint32_t>(repeat) & 0x3fU) << 24U |
              (static_cast<std::uint32_t>(vertex) & 0xffffU) << 8U |
              static_cast<std::uint32_t>(slot)) {}
  constexpr Stream stream() const { return static_cast<Stream>(bits_ >> 30U); }
  constexpr int repeat() const { return static_cast<int>(bits_ >> 24U & 0x3fU); }
  constexpr int vertex() const { return static_cast<int>(bits_ >> 8U & 0xffffU); }
  constexpr Slot slot() const { return static_cast<Slot>(bits_ & 0xffU); }
  constexpr bool operator==(const SampleAddress&) const = default;

 private:
  std::uint32_t bits_;
};

/// The lane that a path samples its distances by is one number for all of its edges, from whichever
/// end (docs/methods/bidirectional.md, "Media").
inline constexpr SampleAddress kLaneChoice{Stream::Camera, 0, Slot::MediumLane};
inline int lane_of(float u) { return std::min(static_cast<int>(u * 3.F), 2); }

/// The primary vector (docs/methods/pssmlt.md): all randomness of a path comes from here. Numbers
/// are in [0, 1).
class SampleSource {
 public:
  virtual ~SampleSource() = default;
  virtual float get(SampleAddress address) = 0;
  /// Two numbers that are stratified together: an even slot and the one after it.
  virtual Vec2 get_pair(SampleAddress address) = 0;
  /// Puts others in the place of two numbers: a proposal that chooses them while it is looked at.
  /// `log_density`: of the step back over that of the step. Raises std::logic_error where numbers
  /// are not to be chosen.
  virtual void replace_pair(SampleAddress /*address*/, const Vec2& /*numbers*/,
                            double /*log_density*/) {
    throw std::logic_error("bug: numbers that are given were to be replaced");
  }
};

}  // namespace ajar
