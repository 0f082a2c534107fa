#pragma once
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "core/error.h"
#include "import/scene_definitions.h"

namespace ajar::mitsuba {

/// Values of `$name`: given from outside, or by `<default>` in the scene.
class Definitions {
 public:
  /// Values `given` take precedence over those that files define.
  explicit Definitions(SceneDefinitions given) : given_(given), values_(std::move(given)) {}

  /// Adds the value of a `<default>`. Earlier and given values take precedence.
  void define(const std::string& name, const std::string& value);

  /// `text` with all `$name` replaced, of several fitting names by the longest; `\$` is a dollar
  /// sign. Raises SceneError at `where` for names without a definition, and if the result is beyond
  /// all measure.
  std::string substitute(std::string_view text, const SourceLocation& where);

  /// Once the scene is read. Raises SceneError at `where` for a name that was given, but that the
  /// scene neither defines nor uses: the picture would not be the one that is wanted.
  void check_given(const SourceLocation& where) const;

 private:
  const SceneDefinitions given_;
  SceneDefinitions values_;
  std::set<std::string> of_scene_;  ///< names that it defines or uses
};

}  // namespace ajar::mitsuba
