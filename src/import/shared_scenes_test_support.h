#pragma once
#include <cstdlib>
#include <filesystem>

namespace ajar {

/// Why tests of scenes that others made are skipped.
inline constexpr const char* kNoSharedScenes =
    "no shared scenes; set AJAR_SHARED to the folder that has them in \"scenes\"";

/// Where the scenes are that others made; there may be none.
inline std::filesystem::path shared_scenes_folder() {
  // Nothing in the tests changes the environment.
  const char* shared = std::getenv("AJAR_SHARED");  // NOLINT(concurrency-mt-unsafe)
  if (shared != nullptr) return std::filesystem::path(shared) / "scenes";
#ifdef AJAR_SOURCE_DIR
  return std::filesystem::path(AJAR_SOURCE_DIR) / "../shared/scenes";
#else
  return "../shared/scenes";
#endif
}

}  // namespace ajar
