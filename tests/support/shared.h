#pragma once
#include <filesystem>
#include <optional>

namespace ajar::test {

/// Folder with scenes and references that others made: `$AJAR_SHARED`, else `../shared` beside the
/// repository. Empty if it is not there; then call GTEST_SKIP with `kNoSharedFolder`.
std::optional<std::filesystem::path> shared_folder();
inline constexpr const char* kNoSharedFolder =
    "the folder of shared scenes is absent (set AJAR_SHARED to run this test)";

}  // namespace ajar::test
