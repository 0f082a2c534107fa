#pragma once
#include <string>

namespace ajar {

/// Version of this program, e.g. "0.2.0".
const std::string& version();

}  // namespace ajar
