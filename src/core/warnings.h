#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

/// Warnings of input that is unusual but usable, in the order of their effect on the picture:
///
///     constexpr WarningKind kUnreadable{Effect::Surface, "textures cannot be read: magenta"};
///     warnings.add(kUnreadable, where, "cannot read \"a.png\": magenta stands in", "a.png");
namespace ajar {

/// Effect on the picture, the worst first.
enum class Effect {
  Light,     ///< light is missing or another, or the picture as a whole is
  Geometry,  ///< something is missing that should be seen, or has another form
  Surface,   ///< something looks different: a texture or a material is replaced
  Slight,    ///< something is ignored that as a rule changes little
  None       ///< nothing that can be seen
};
inline constexpr std::size_t kEffects = 5;
/// "light", "geometry", "surfaces", "slight effect", "no visible effect".
std::string_view name_of(Effect effect);

/// Common properties of warnings that are printed in one line. Those of the same text are of one
/// kind; it must outlive them.
struct WarningKind {
  Effect effect;
  /// Text for several, after their number: "textures cannot be read: magenta".
  std::string_view several;
  /// Containers of the things that one warning counts (`Warning::amount`), as in "7 triangles have
  /// no area, in 2 meshes"; else empty.
  std::string_view holders = {};
};

struct Warning {
  WarningKind kind;
  SourceLocation where;
  std::string message;       ///< text of this one alone, without its place
  std::string subject = {};  ///< name of its object, as an example for its kind; may be empty
  std::uint64_t amount = 1;  ///< number of things that it is about
  /// "place: message".
  std::string text() const { return located(where, message); }
};

/// All warnings of a kind.
struct WarningGroup {
  static constexpr std::size_t kMaxSubjects = 4;
  Warning first;  ///< in its file
  std::size_t count = 0;
  std::uint64_t amount = 0;           ///< sum of theirs
  std::vector<std::string> subjects;  ///< the first, each once
  bool has_more_subjects = false;
};

/// Counts and keeps warnings. Thread-safe. Equal messages at different places are kept apart. All
/// are counted and in a group.
class Warnings {
 public:
  static constexpr std::size_t kMaxKept = 200;
  static constexpr std::size_t kAll = static_cast<std::size_t>(-1);

  /// `most_kept`: how many are kept, of those with the most effect.
  explicit Warnings(std::size_t most_kept = kMaxKept) : most_kept_(most_kept) {}
  void add(Warning warning);
  void add(const WarningKind& kind, const SourceLocation& where, std::string message,
           std::string subject = {});
  /// Counts all of `others`, and keeps those that it has kept.
  void add_all(const Warnings& others);

  std::size_t count() const;
  std::size_t count(Effect effect) const;
  /// Kept warnings by effect, then by file and line: the scene may be read in another order.
  std::vector<Warning> kept() const;
  /// Their texts.
  std::vector<std::string> messages() const;
  /// By effect, then by where their first ones are.
  std::vector<WarningGroup> groups() const;

 private:
  const std::size_t most_kept_;
  mutable std::mutex mutex_;
  std::array<std::size_t, kEffects> counts_{};
  std::array<std::vector<Warning>, kEffects> kept_;
  std::array<std::vector<WarningGroup>, kEffects> groups_;
};

}  // namespace ajar
