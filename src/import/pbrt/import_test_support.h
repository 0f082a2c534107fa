#pragma once
#include <map>
#include <string>
#include <string_view>

#include "core/error.h"
#include "import/pbrt/pbrt_import.h"

namespace ajar {

/// Imports text as "test.pbrt", with the given files beside it.
inline desc::SceneDesc import_with(std::string_view text, Warnings& warnings,
                                   const std::map<std::string, std::string>& files = {}) {
  return import_pbrt_text(text, "test.pbrt", "", warnings,
                          [&](const std::string& path) -> std::optional<std::string_view> {
                            const auto found = files.find(path);
                            if (found == files.end()) return std::nullopt;
                            return found->second;
                          });
}

/// A world with `body` in it; there must be no warnings but the one about missing shapes.
inline std::string world(const std::string& body) {
  return "Camera \"perspective\" WorldBegin\n" + body + "\nShape \"sphere\" WorldEnd";
}

/// Message of the SceneError that importing raises, or "no error".
inline std::string error_of(std::string_view text,
                            const std::map<std::string, std::string>& files = {}) {
  Warnings warnings;
  try {
    import_with(text, warnings, files);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no error";
}

/// All warnings of importing, one per line.
inline std::string warnings_of(std::string_view text,
                               const std::map<std::string, std::string>& files = {}) {
  Warnings warnings;
  import_with(text, warnings, files);
  std::string result;
  for (const std::string& message : warnings.messages()) result += message + "\n";
  return result;
}

}  // namespace ajar
