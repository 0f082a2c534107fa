#pragma once
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <string_view>

#include "core/error.h"
#include "core/vector.h"
#include "core/warnings.h"
#include "import/file_provider.h"

/// Fixtures of the tests of all formats.
namespace ajar {

/// Files beside a scene, by their paths.
using Files = std::map<std::string, std::string>;

/// Serves `files`, which must outlive it.
inline FileProvider provider_of(const Files& files) {
  return [&files](const std::string& path) -> std::optional<std::string_view> {
    const auto found = files.find(path);
    if (found == files.end()) return std::nullopt;
    return found->second;
  };
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// All messages, one per line.
inline std::string lines_of(const Warnings& warnings) {
  std::string result;
  for (const std::string& message : warnings.messages()) result += message + "\n";
  return result;
}

/// Fails for each warning; `context` names its source.
inline void expect_none(const Warnings& warnings, std::string_view context = {}) {
  for (const std::string& message : warnings.messages()) ADD_FAILURE() << context << message;
}

/// Message of the SceneError that `import(Warnings&)` raises, or "no error".
template <typename Import>
std::string error_in(const Import& import) {
  Warnings warnings;
  try {
    import(warnings);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no error";
}

/// All warnings of `import(Warnings&)`, one per line.
template <typename Import>
std::string warnings_in(const Import& import) {
  Warnings warnings;
  import(warnings);
  return lines_of(warnings);
}

inline void expect_near(const Vec3& actual, const Vec3& expected, float tolerance = 1e-5F) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], tolerance) << "lane " << i;
}

}  // namespace ajar
