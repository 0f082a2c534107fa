#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "core/error.h"
#include "import/common/file_access.h"

namespace ajar::pbrt {

/// pbrt-v3 and pbrt-v4 share their extension and most of their words, but not the meanings.
enum class Dialect { V3, V4 };
std::string_view name_of(Dialect dialect);  ///< "pbrt-v3"

/// Dialect of a file, and the reason.
struct DialectChoice {
  Dialect dialect = Dialect::V3;
  SourceLocation where = {};  ///< place of the word that decides; unknown if no word does
  std::string word = {};      ///< as in `Film "rgb"`
};

/// Determines the dialect of a file, by the first of these that decides:
///
/// 1. the type of the film: "image" is v3; "rgb", "gbuffer" and "spectral" are v4;
/// 2. directives: WorldEnd is v3; Option, ColorSpace, Attribute and Import are v4;
/// 3. the first name that only one version has: of a material ("matte", "diffuse"), a sampler,
///    a camera, a shape, a texture or a filter's parameter;
/// 4. the same in the files that it includes, in their order.
///
/// A file that says nothing of all this is read as v3. So is, with an error at the first word that
/// v3 does not have, one whose film or WorldEnd says so.
DialectChoice tell_dialect(std::string_view text, const std::string& name, FileAccess& files);

/// The dialect that alone has this word, a directive or the name of a type; empty if both have it
/// or none.
std::optional<Dialect> dialect_of_word(std::string_view word);

}  // namespace ajar::pbrt
