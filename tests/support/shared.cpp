#include "support/shared.h"

#include <cstdlib>

namespace ajar::test {

std::optional<std::filesystem::path> shared_folder() {
  // Nothing in the tests changes the environment.
  const char* given = std::getenv("AJAR_SHARED");  // NOLINT(concurrency-mt-unsafe)
  const std::filesystem::path folder =
      given != nullptr ? std::filesystem::path(given)
                       : std::filesystem::path(AJAR_SOURCE_DIR) / ".." / "shared";
  if (!std::filesystem::is_directory(folder / "scenes")) return std::nullopt;
  return folder;
}

}  // namespace ajar::test
