#pragma once
#include <string>

namespace ajar {

/// Version of this program, e.g. "0.1.0".
const std::string& version();

}  // namespace ajar
