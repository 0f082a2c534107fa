#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/warnings.h"
#include "import/common/file_access.h"
#include "import/pbrt/cloud.h"
#include "import/pbrt/dialect.h"
#include "import/pbrt/spectra.h"
#include "scene/desc/scene_desc.h"

namespace ajar::pbrt {

/// State shared by all parts of the importer.
struct Context {
  desc::SceneDesc& scene;
  Warnings& warnings;
  FileAccess& files;
  SpectrumReader& spectra;
  CloudGrids& clouds;
  const DialectChoice& choice;

  bool is_v4() const { return choice.dialect == Dialect::V4; }
};

/// Message for a type that the file's dialect does not have: the nearest names, or that the other
/// version of pbrt has it and why the file is taken for this one.
std::string unknown_message(const DialectChoice& choice, std::string_view what,
                            std::string_view name, const std::vector<std::string>& valid);

/// Reports an unknown type: in pbrt-v3 files an error; in pbrt-v4 files, which may be newer than
/// this reader, a warning that ends with `stand_in`, as in "a diffuse one stands in".
void report_unknown(const Context& context, const SourceLocation& where, std::string_view what,
                    std::string_view name, const std::vector<std::string>& valid,
                    const WarningKind& kind, std::string_view stand_in);

/// Warns that the `what` at `where` has the name of another, which it replaces from here on.
void warn_of_same_name(const Context& context, const SourceLocation& where, std::string_view what,
                       std::string_view name);

/// Warns of a name that nothing has that was made before; `stand_in` as for `report_unknown`.
void warn_of_unknown_name(const Context& context, const WarningKind& kind,
                          const SourceLocation& where, std::string_view what,
                          const std::string& name, const std::vector<std::string>& valid,
                          std::string_view stand_in);

/// The error for a word that no version of pbrt has in this place.
[[noreturn]] void fail_unknown(const SourceLocation& where, std::string_view what,
                               std::string_view name, const std::vector<std::string>& valid);

/// Where a file is that the scene names at `where`, as `FileAccess::resolve`. Raises SceneError.
std::string resolve_file(Context& context, const SourceLocation& where, const std::string& name);

}  // namespace ajar::pbrt
