#pragma once
#include <map>

#include "import/mitsuba/arguments.h"

namespace ajar::mitsuba {

/// The media of the scene, each made once however often it is referred to.
class MediumTable {
 public:
  explicit MediumTable(Context& context) : context_(context) {}

  /// Makes the medium of a `<medium>`. Unknown ones become homogeneous, with a warning.
  desc::MediumId make(const Element& medium);
  /// The one that a plugin calls `name`, such as "interior"; none if there is none.
  desc::MediumId find(Arguments& arguments, std::string_view name);

 private:
  Context& context_;
  std::map<const Element*, desc::MediumId> made_;
};

}  // namespace ajar::mitsuba
