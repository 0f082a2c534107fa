#pragma once
#include <memory>
#include <span>
#include <string>

#include "core/warnings.h"
#include "import/code/description.h"
#include "import/code/scene_changes.h"

/// Arrays of a description: geometry and images.
namespace ajar::code {

class ArrayReader {
 public:
  ArrayReader(std::span<const NumberArray> arrays, desc::EmbeddedFiles& embedded,
              Warnings& warnings)
      : arrays_(arrays), embedded_(embedded), warnings_(warnings) {}

  /// {"positions": 0, "indices": 1, "normals": 2, "tangents": 3, "uvs": 4}: numbers of arrays, the
  /// first two needed. Raises SceneError as `validate_mesh` does.
  desc::MeshPointer mesh(const LocatedJson& part) const;
  /// {"control_points": 0, "widths": 1, "normals": 2}.
  desc::CurvesPointer curves(const LocatedJson& part) const;
  /// {"image": 0}: rows × columns × 1 or 3, of display-encoded bytes or linear floats. The name of
  /// an embedded file, which depends on its content alone.
  std::string image(const LocatedJson& part) const;

 private:
  /// The array in a member; null without the member.
  const NumberArray* find(const LocatedJson& part, const char* name) const;
  const NumberArray& array(const LocatedJson& part, const char* name, NumberArray::Type type,
                           std::size_t columns) const;

  std::span<const NumberArray> arrays_;
  desc::EmbeddedFiles& embedded_;
  Warnings& warnings_;
};

}  // namespace ajar::code
