#pragma once

namespace cereal {
class PortableBinaryOutputArchive;
}  // namespace cereal

namespace ajar {

/// See core/archive.h, which is much to read for those who only pass an archive on.
using OutputArchive = cereal::PortableBinaryOutputArchive;
class InputArchive;

}  // namespace ajar
