#include "import/pbrt/writer_context.h"

namespace ajar::pbrt {
namespace {

/// Writes values by their types.
struct ValueWriter {
  WriterContext& context;
  const ParameterSpec& spec;
  const std::string& name;
  bool numbers_for_colors;

  void operator()(std::monostate) const {}
  void operator()(bool value) const { context.out.flag(name, value); }
  void operator()(int value) const { context.out.parameter("integer " + name, value); }
  void operator()(float value) const { context.out.parameter("float " + name, value); }
  void operator()(const std::string& value) const {
    const bool is_file = spec.type == ParameterType::File;
    if (is_file && value.empty()) return;
    context.out.parameter("string " + name, is_file ? context.image_path(value) : value);
  }
  void operator()(const Vec3& value) const {
    if (spec.type == ParameterType::Color && numbers_for_colors) {
      (*this)(value.x);
    } else if (spec.type == ParameterType::Color) {
      context.out.rgb(name, value);
    } else if (spec.type == ParameterType::Point) {
      context.out.point(name, value);
    } else {
      context.out.parameter("vector " + name, value.x, value.y, value.z);
    }
  }
  void operator()(const desc::TextureRef& value) const { context.reference(name, value.id); }
  void operator()(const desc::MaterialRef& value) const {
    context.out.parameter("string " + name,
                          context.material_names.at(static_cast<std::size_t>(value.id)));
  }
  /// What has a place is written under a transform of its own.
  void operator()(const desc::TransformPointer&) const {}
  /// What shapes are made of is written with them.
  void operator()(const desc::MeshPointer&) const {}
  void operator()(const desc::CurvesPointer&) const {}
};

}  // namespace

void write_parameters(WriterContext& context, const desc::Node& node, const ModelName* names,
                      bool numbers_for_colors) {
  for (std::size_t i = 0; i < node.values().size(); ++i) {
    const ParameterSpec& spec = node.model().parameters[i];
    if (!node.matters(spec)) continue;
    const desc::Value& value = node.values()[i];
    const ParameterName* translated = names == nullptr ? nullptr : names->find(spec.name);
    if (translated == nullptr) {
      std::visit(ValueWriter{context, spec, spec.name, numbers_for_colors}, value);
      continue;
    }
    if (translated->theirs.empty()) continue;
    const std::string name(translated->theirs.front());
    if (!translated->words[0].empty()) {
      const std::string& choice = std::get<std::string>(value);
      if (choice == translated->words[0] || choice == translated->words[1]) {
        context.out.flag(name, choice == translated->words[1]);
      } else {  // more than pbrt's flag can say
        std::visit(ValueWriter{context, spec, spec.name, numbers_for_colors}, value);
      }
    } else if (std::holds_alternative<std::monostate>(value) && !translated->if_absent.empty()) {
      std::visit(ValueWriter{context, spec, name, numbers_for_colors},
                 node.get(translated->if_absent));
    } else {
      std::visit(ValueWriter{context, spec, name, numbers_for_colors}, value);
    }
  }
}

}  // namespace ajar::pbrt
