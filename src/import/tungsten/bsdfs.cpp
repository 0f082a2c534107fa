#include "import/tungsten/bsdfs.h"

#include <utility>

#include "import/common/opacity.h"
#include "import/tungsten/bsdf_models.h"
#include "scene/desc/models.h"

namespace ajar::tungsten {
namespace {

constexpr WarningKind kUnknownName{Effect::Surface, "bsdfs have no such name: grey stands in"};
constexpr WarningKind kUnknownType{Effect::Surface, "bsdfs are of unknown types: grey stands in"};
constexpr WarningKind kSameBsdfName{Effect::Surface, "bsdfs have the same name: the first counts"};
constexpr WarningKind kLoop{Effect::Surface, "bsdfs refer to themselves: grey stands in"};
constexpr WarningKind kBump{Effect::Slight, "bumps have a height that is a guess"};

using Kind = LocatedJson::Kind;

Surface with_opacity(const BsdfInputs& in, Surface base, const desc::Value& opacity) {
  const float* share = std::get_if<float>(&opacity);
  if (share != nullptr && *share >= 1.F) return base;
  if (share != nullptr && *share <= 0.F) {
    base.material = in.add(desc::material_node("interface", {{"counted", true}}));
    return base;
  }
  const PartlyClear partly = ajar::with_opacity(
      in.context.scene, {.name = {}, .where = in.object.where()}, base.material, opacity);
  base.material = partly.material;
  base.alpha = partly.alpha;
  return base;
}

}  // namespace

desc::MaterialId BsdfTable::add(const SourceLocation& where, desc::Node node) {
  context_.scene.materials.push_back({.name = {}, .where = where, .node = std::move(node)});
  return static_cast<desc::MaterialId>(context_.scene.materials.size()) - 1;
}

desc::Material& BsdfTable::material_at(desc::MaterialId id) {
  return context_.scene.materials[static_cast<std::size_t>(id)];
}

desc::MaterialId BsdfTable::without_relief(desc::MaterialId id) {
  const desc::Material& whole = material_at(id);
  return whole.bump == desc::kNone ? id : add(whole.where, whole.node);
}

desc::MaterialId BsdfTable::black() {
  if (black_ == desc::kNone) {
    black_ = add({}, desc::material_node("diffuse", {{"reflectance", Vec3(0.F)}}));
  }
  return black_;
}

Surface BsdfTable::white() {
  if (white_ == desc::kNone) {
    white_ = add({}, desc::material_node("diffuse", {{"reflectance", Vec3(1.F)}}));
  }
  return {white_};
}

Surface BsdfTable::grey(const SourceLocation& where) {
  return {add(where, desc::material_node("diffuse"))};
}

void BsdfTable::define(const LocatedJson& list) {
  if (!list.is(Kind::Array)) throw SceneError(list.where(), "\"bsdfs\" must be an array");
  std::vector<Entry*> entries;
  for (const LocatedJson& json : list.items()) {
    const auto name = json.is(Kind::Object) ? json.find("name") : std::nullopt;
    if (!name) continue;  // nothing can refer to it
    const auto [place, is_new] = named_.try_emplace(name->text(), Entry{json});
    if (is_new) {
      entries.push_back(&place->second);
    } else {
      context_.warnings.add(
          kSameBsdfName, name->where(),
          "there is another bsdf \"" + printable(name->text()) + "\" before, which counts",
          printable(name->text()));
    }
  }
  for (Entry* entry : entries) read_named(*entry);
}

Surface BsdfTable::read_named(Entry& entry) {
  if (entry.is_done) return entry.surface;
  if (entry.is_open || depth_ == kDeepestReference) {
    context_.warnings.add(
        kLoop, entry.json.where(),
        "this bsdf refers to itself, or to too many others in a row: grey stands in");
    return grey(entry.json.where());
  }
  entry.is_open = true;
  ++depth_;
  entry.surface = read(entry.json);
  --depth_;
  entry.is_open = false;
  entry.is_done = true;
  return entry.surface;
}

Surface BsdfTable::resolve(const LocatedJson& json) {
  if (!json.is(Kind::Text)) return read(json);
  const auto found = named_.find(json.text());
  if (found != named_.end()) return read_named(found->second);
  std::vector<std::string> names;
  for (const auto& entry : named_) names.push_back(printable(entry.first));
  context_.warnings.add(
      kUnknownName, json.where(),
      unknown_name_message("bsdf", printable(json.text()), names) + ". Grey stands in",
      printable(json.text()));
  return grey(json.where());
}

Surface BsdfTable::read(const LocatedJson& json) {
  const ObjectReader object(context_, json, "a bsdf");
  const BsdfInputs in{context_, object, textures_, *this};
  const std::string name = object.text("name").value_or("");
  const std::optional<std::string> type = object.text("type");
  if (!type) throw SceneError(json.where(), "a bsdf needs \"type\"");

  Surface surface;
  if (*type == "transparency") {
    const std::optional<desc::MaterialId> base = in.part("base");
    const desc::MaterialId visible = base ? *base : white().material;
    surface = with_opacity(in, {visible}, in.opacity());
    // Fully opaque: a copy of the base, which others may use, too.
    if (surface.material == visible) {
      surface.material = add(json.where(), material_at(visible).node);
    }
    object.accept({"albedo", "color"});
  } else if (std::optional<desc::Node> node = make_bsdf(*type, in)) {
    surface.material = add(json.where(), std::move(*node));
    if (object.has("alpha")) surface = with_opacity(in, surface, in.opacity());
  } else {
    context_.warnings.add(
        kUnknownType, json.where(),
        unknown_name_message("bsdf type", printable(*type), bsdf_types()) + ". Grey stands in",
        printable(*type));
    return grey(json.where());
  }
  desc::Material& material = material_at(surface.material);
  material.name = name;
  // A bump that is the same everywhere is none.
  const desc::Value bump = in.number("bump", 0.F);
  if (const auto* texture = std::get_if<desc::TextureRef>(&bump)) {
    material.bump = texture->id;
    in.warn(kBump, "the height of \"bump\" depends on the number of its pixels: taken as it is");
  }
  if (const auto inside = object.find("int_medium")) surface.inside = inside;
  if (const auto outside = object.find("ext_medium")) surface.outside = outside;
  object.report_unknown();
  return surface;
}

}  // namespace ajar::tungsten
