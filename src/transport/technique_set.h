#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace ajar {

/// Numbers of vertices from the light, s, and from the camera, t (docs/methods/bidirectional.md).
struct Technique {
  int s;
  int t;
  /// Edges of the path.
  constexpr int depth() const { return s + t - 1; }
  constexpr bool operator==(const Technique&) const = default;
};

/// The kinds of techniques.
enum class TechniqueClass {
  Implicit,   ///< (0, k+1): camera path runs into an emitter
  NextEvent,  ///< (1, k), called "explicit" by users
  Light,      ///< (k, 1): light path connected to the lens
  Inner,      ///< (s ≥ 2, t ≥ 2)
  Count       ///< number of classes
};
constexpr std::size_t index_of(TechniqueClass kind) { return static_cast<std::size_t>(kind); }
/// One of each, by `index_of`.
template <typename Value>
using ByTechniqueClass = std::array<Value, index_of(TechniqueClass::Count)>;
/// Class of a technique that exists.
constexpr TechniqueClass class_of(Technique technique) {
  if (technique.s == 0) return TechniqueClass::Implicit;
  if (technique.t == 1) return TechniqueClass::Light;
  return technique.s == 1 ? TechniqueClass::NextEvent : TechniqueClass::Inner;
}
/// "implicit", "explicit", "light" or "inner".
std::string_view name_of(TechniqueClass kind);

/// The techniques an integrator uses, and their counts. MIS weights are over exactly this set, so
/// any set that covers the light paths of a scene is unbiased. Direct visibility, technique (0, 2),
/// always belongs to it; (1, 1) and (k+1, 0) never do.
///
/// A count is the number of tries at each opportunity (a camera vertex for next event estimation, a
/// light vertex for light tracing, a pair of vertices for inner connections), on average: 0.5
/// tries at every other one, at random; 0 leaves the technique out.
class TechniqueSet {
 public:
  static constexpr int kAny = -1;
  /// Count of the single technique (s, t); either may be `kAny`.
  struct Rule {
    int s;
    int t;
    double count;
    bool operator==(const Rule&) const = default;
  };
  static constexpr double kMaxNextEventCount = 32.0;

  /// Reads the user's syntax: names of sets (pt, lt, ibpt, bdpt) and of classes (implicit,
  /// explicit, light, inner) and pairs `(s,t)` or `(s,*)`, separated by commas, each with an
  /// optional count `*n`. Raises UsageError.
  static TechniqueSet parse(const std::string& text);

  /// True if both are written alike; sets written differently may still be the same.
  bool operator==(const TechniqueSet&) const = default;

  static TechniqueSet pt() { return parse("pt"); }
  static TechniqueSet ibpt() { return parse("ibpt"); }
  static TechniqueSet bdpt() { return parse("bdpt"); }

  /// 0 if the technique does not belong to the set.
  double count(Technique technique) const {
    const auto [s, t] = technique;
    if (s == 0 && t == 2) return 1.0;
    if (s < 0 || t < 1 || s + t < 3) return 0.0;
    for (const Rule& rule : rules_) {
      if ((rule.s == kAny || rule.s == s) && (rule.t == kAny || rule.t == t)) return rule.count;
    }
    return count(class_of(technique));
  }
  bool enabled(Technique technique) const { return count(technique) > 0.0; }
  /// Count of those techniques of a class that no rule names.
  double count(TechniqueClass kind) const { return counts_[index_of(kind)]; }
  /// True if every technique is tried once at each opportunity, or not at all.
  bool tries_once() const;
  /// True if all techniques of a class have the same count.
  bool uniform() const { return rules_.empty(); }
  /// True if any technique of the class belongs to the set ((0, 2) aside).
  bool any(TechniqueClass kind) const { return any_[index_of(kind)]; }
  bool needs_light_subpath() const {
    return any(TechniqueClass::Light) || any(TechniqueClass::Inner);
  }

 private:
  TechniqueSet(const ByTechniqueClass<double>& counts, std::vector<Rule> rules);

  ByTechniqueClass<double> counts_;
  std::vector<Rule> rules_;
  ByTechniqueClass<bool> any_;
};

}  // namespace ajar
