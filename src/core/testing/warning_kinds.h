#pragma once
#include <memory>
#include <string>

#include "core/warnings.h"

/// Warnings of every effect, for tests.
namespace ajar::testing {

inline constexpr WarningKind kLamp{Effect::Light, "lamps are out"};
inline constexpr WarningKind kImage{Effect::Surface, "textures cannot be read, shown as magenta"};
inline constexpr WarningKind kParameter{Effect::Slight, "parameters are ignored"};
inline constexpr WarningKind kTriangle{Effect::None, "triangles have no area", "meshes"};

/// A line of "a.pbrt".
inline SourceLocation line(int number) {
  static const auto file = std::make_shared<const std::string>("a.pbrt");
  return {file, number, 1};
}

}  // namespace ajar::testing
