#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "integrator/integrator.h"

namespace ajar {

/// A name with its one-line explanation.
struct CatalogEntry {
  std::string name;
  std::string summary;
};

/// The scenes that are part of the program.
std::vector<CatalogEntry> scene_catalog();

/// Raises UsageError for a name that is no AOV. "all" stands for every one.
std::vector<std::string> checked_aovs(const std::vector<std::string>& names);

/// Kinds that `ajar list` can list: integrators, materials, textures …
const std::vector<std::string>& catalog_kinds();
/// Names of all entries that have parameters.
std::vector<std::string> names_with_parameters();
/// The kinds with an entry of that name that has parameters.
std::vector<std::string> kinds_with(const std::string& name);
/// One catalogue for people (a line per entry), and for programs (array of objects with name,
/// summary; what has parameters also has source and parameters).
std::string catalog_text(const std::string& kind);
nlohmann::ordered_json catalog_json(const std::string& kind);

/// One entry of a kind that has parameters, with them, for people: those for experts come last,
/// under a heading of their own. Raises UsageError for kinds whose entries have none and for
/// unknown names.
std::string entry_text(const std::string& kind, const std::string& name);
nlohmann::ordered_json entry_json(const std::string& kind, const std::string& name);

}  // namespace ajar
