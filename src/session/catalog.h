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

/// Materials a scene can have (pbrt-v3 names), sorted by name.
const std::vector<CatalogEntry>& material_catalog();
/// The scenes that are part of the program.
std::vector<CatalogEntry> scene_catalog();

/// Raises UsageError for a name that is no AOV. "all" stands for every one.
std::vector<std::string> checked_aovs(const std::vector<std::string>& names);

/// What `ajar list` can list: integrators, materials, aovs, scenes.
const std::vector<std::string>& catalog_kinds();
/// One catalogue for people (a line per entry), and for programs (array of objects with name,
/// summary; integrators also have source and parameters).
std::string catalog_text(const std::string& kind);
nlohmann::ordered_json catalog_json(const std::string& kind);

/// One integrator with its parameters, for people: those for experts come last, under a heading of
/// their own.
std::string integrator_text(const IntegratorInfo& info);
nlohmann::ordered_json integrator_json(const IntegratorInfo& info);

}  // namespace ajar
