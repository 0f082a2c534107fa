#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "os/regular_file.h"

namespace ajar {

/// Serves files that are not on the disk (built-in scenes); empty for unknown files. Its results
/// must stay valid while the scene is imported.
using FileProvider = std::function<std::optional<std::string_view>(const std::string& path)>;

}  // namespace ajar
