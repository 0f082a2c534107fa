#pragma once
#include <map>
#include <string>

#include "import/tungsten/object_reader.h"

namespace ajar::tungsten {

/// The media of a scene: those of the list "media", which others refer to by name, and those that
/// stand in the place of a name.
class MediumTable {
 public:
  explicit MediumTable(Context& context) : context_(context) {}

  /// Reads the list "media". The first of a name counts, with a warning for others.
  void define(const LocatedJson& list);
  /// The medium that `json` is or names. Unknown names and types are warnings: there is none then.
  desc::MediumId resolve(const LocatedJson& json);

 private:
  desc::MediumId read(const LocatedJson& json);

  Context& context_;
  std::map<std::string, desc::MediumId, std::less<>> named_;
};

}  // namespace ajar::tungsten
