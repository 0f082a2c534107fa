#pragma once

namespace cereal {
class PortableBinaryOutputArchive;
}  // namespace cereal

namespace ajar {

/// Forward declarations of core/archive.h, a large header, for code that only passes an archive on.
using OutputArchive = cereal::PortableBinaryOutputArchive;
class InputArchive;

}  // namespace ajar
