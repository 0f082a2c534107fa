#pragma once
#include <string>
#include <string_view>

namespace ajar {

/// How a path is built: s vertices from the light, t from the camera (METHODS, section 2).
struct Technique {
  int s;
  int t;
  /// Edges of the path.
  constexpr int depth() const { return s + t - 1; }
  constexpr bool operator==(const Technique&) const = default;
};

/// The techniques an integrator uses. MIS weights are over exactly this set, so any set that covers
/// the light paths of a scene is unbiased. What the lens sees directly, technique (0, 2), always
/// belongs to it; (1, 1) never does.
class TechniqueSet {
 public:
  struct Classes {
    bool implicit = false;    ///< (0, k+1): camera path runs into an emitter
    bool next_event = false;  ///< (1, k), called "explicit" by users
    bool light = false;       ///< (k, 1): light path connected to the lens
    bool inner = false;       ///< (s ≥ 2, t ≥ 2)
  };
  constexpr explicit TechniqueSet(Classes classes) : classes_(classes) {}

  static constexpr TechniqueSet pt() { return TechniqueSet({true, true, false, false}); }
  static constexpr TechniqueSet lt() { return TechniqueSet({false, false, true, false}); }
  static constexpr TechniqueSet ibpt() { return TechniqueSet({true, true, true, false}); }
  static constexpr TechniqueSet bdpt() { return TechniqueSet({true, true, true, true}); }

  constexpr bool enabled(Technique technique) const {
    const auto [s, t] = technique;
    if (s == 0) return t == 2 || (t > 2 && classes_.implicit);
    if (t == 1) return s > 1 && classes_.light;
    if (t == 0) return false;
    return s == 1 ? classes_.next_event : classes_.inner;
  }
  constexpr const Classes& classes() const { return classes_; }
  constexpr bool needs_light_subpath() const { return classes_.light || classes_.inner; }

 private:
  Classes classes_;
};

}  // namespace ajar
