#pragma once
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "core/error.h"
#include "core/vector.h"
#include "scene/desc/scene_desc.h"

/// A scene as its XML says it, without any meaning: elements that are plugins, with properties and
/// further elements in them. Names are as in Mitsuba 2 and 3: "toWorld" is "to_world".
namespace ajar::mitsuba {

using PropertyValue = std::variant<bool, long long, double, std::string, desc::Rgb, Vec3d, Mat4>;

/// `<float name="radius" value="2"/>` and the like.
struct Property {
  std::string name;
  SourceLocation where;
  PropertyValue value;
};

struct Element;
using ElementPointer = std::shared_ptr<const Element>;

/// An element inside of another, or a reference to one that is elsewhere.
struct Child {
  std::string name;  ///< name in its parent; may be empty
  SourceLocation where;
  ElementPointer element;  ///< null for a reference
  std::string id;          ///< id of the referenced element
};

/// `<bsdf type="diffuse" id="wall"> … </bsdf>`.
struct Element {
  std::string tag;
  std::string type;
  std::string id;  ///< may be empty
  SourceLocation where;
  std::vector<Property> properties;
  std::vector<Child> children;
};

struct Document {
  Element scene;
  std::map<std::string, ElementPointer> by_id;
  int major_version = 3;  ///< Mitsuba's version that the file is for: 0, 2 or 3
  SourceLocation end;     ///< end of the file

  /// Element of a child. Raises SceneError if there is no element of that id.
  const Element& resolve(const Child& child) const;
};

}  // namespace ajar::mitsuba
