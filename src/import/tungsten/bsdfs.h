#pragma once
#include <map>
#include <string>

#include "import/tungsten/textures.h"

namespace ajar::tungsten {

/// Surface properties of a bsdf.
struct Surface {
  desc::MaterialId material = desc::kNone;
  desc::TextureId alpha = desc::kNone;  ///< the surface is cut away where this is 0
  /// Media of older files, which have them in bsdfs.
  std::optional<LocatedJson> inside = std::nullopt;
  std::optional<LocatedJson> outside = std::nullopt;
};

/// The bsdfs of a scene: those of the list "bsdfs", which others refer to by name, and those that
/// stand in the place of a name.
class BsdfTable {
 public:
  BsdfTable(Context& context, TextureReader& textures) : context_(context), textures_(textures) {}

  /// Reads the list "bsdfs". The first of a name counts, with a
  /// warning for others.
  void define(const LocatedJson& list);

  /// The bsdf that `json` is or names. Unknown names and types are warnings: grey stands in.
  Surface resolve(const LocatedJson& json);
  /// Surface of primitives without a bsdf.
  Surface white();

  /// A material without a name, for `resolve`'s parts.
  desc::MaterialId add(const SourceLocation& where, desc::Node node);
  /// Copy of the material without its bump.
  desc::MaterialId without_relief(desc::MaterialId id);
  /// One that reflects nothing.
  desc::MaterialId black();

 private:
  struct Entry {
    LocatedJson json;
    bool is_open = false;  ///< being read: cycles of references are refused
    bool is_done = false;
    Surface surface{};
  };

  desc::Material& material_at(desc::MaterialId id);
  Surface read(const LocatedJson& json);
  Surface read_named(Entry& entry);
  Surface grey(const SourceLocation& where);

  Context& context_;
  TextureReader& textures_;
  std::map<std::string, Entry, std::less<>> named_;
  desc::MaterialId black_ = desc::kNone;
  desc::MaterialId white_ = desc::kNone;
  int depth_ = 0;  ///< depth of references
};

}  // namespace ajar::tungsten
