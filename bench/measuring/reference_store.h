#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/vector.h"
#include "measuring/reference.h"

namespace ajar::bench {

/// Parameters of a reference, its noise apart.
struct ReferenceKey {
  std::string scene;
  Vec2i resolution{0, 0};
  int depth = 0;
  std::string filter;
  std::string variant;           ///< method that renders it
  std::uint64_t scene_hash = 0;  ///< a changed scene must not be compared with old pictures
};

/// Parts of one reference in a folder: for each an EXR with layers "" and "standard-error", named
/// `SCENE-WxH-dDEPTH-FILTER-VARIANT-HASH-seedI.exr`, and a JSON beside it.
class ReferenceStore {
 public:
  ReferenceStore(std::filesystem::path folder, ReferenceKey key);

  /// Raises IoError for a file that cannot be read or has another size.
  std::vector<ReferencePart> load() const;
  /// Keeps a part under the next number; makes the folder if need be. Raises IoError.
  void add(const ReferencePart& part) const;
  /// Number of parts, which is the number of the next one.
  std::uint64_t count() const;

 private:
  std::string path(std::uint64_t index, const char* extension) const;

  std::filesystem::path folder_;
  ReferenceKey key_;
};

}  // namespace ajar::bench
