#include "import/pbrt/own_words.h"
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
  void operator()(bool value) const {
    // pbrt's defaults are ours, but for "gamma", which depends on the file there: it is written for
    // files of integers only.
    if (desc::Value(value) != desc::default_value(spec)) context.out.flag(name, value);
  }
  void operator()(int value) const { context.out.parameter("integer " + name, value); }
  void operator()(float value) const { context.out.parameter("float " + name, value); }
  void operator()(const std::string& value) const {
    const bool is_file = spec.type == ParameterType::File;
    if (is_file && value.empty()) return;
    context.out.parameter("string " + name, is_file ? context.images.name(value) : value);
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
  /// Transforms are written as a transform of the object.
  void operator()(const desc::TransformPointer&) const {}
  /// Meshes and curves are written with their shapes.
  void operator()(const desc::MeshPointer&) const {}
  void operator()(const desc::CurvesPointer&) const {}
};

struct ParameterWriter {
  WriterContext& context;
  const desc::Node& node;
  const ModelName* names;
  bool numbers_for_colors;
  const Substitutes& substitutes;

  void write(const ParameterSpec& spec, const std::string& word, const desc::Value& value) const {
    std::visit(ValueWriter{context, spec, word, numbers_for_colors}, value);
  }

  /// By our name, as pbrt has none that we know.
  void write_untranslated(const ParameterSpec& spec, const desc::Value& value) const {
    if (names != nullptr && !is_unknown_to_v3(node.model(), spec.name)) {
      return write(spec, spec.name, value);
    }
    if (value == desc::default_value(spec)) return;
    if (names != nullptr) ++context.unknown_parameters[spec.name];
    write(spec, substitutes.empty() ? spec.name : own_word(spec.name), value);
  }

  void write_translated(const ParameterSpec& spec, const ParameterName& translated,
                        const desc::Value& value) const {
    if (translated.theirs.empty()) return;
    const std::string word(translated.theirs.front());
    if (has_own_prefix(word)) {
      if (value == desc::default_value(spec)) return;
      ++context.unknown_parameters[spec.name];
    }
    // Ours of another default.
    const bool is_own = word == spec.name && is_unknown_to_v3(node.model(), spec.name);
    if (is_own && value != desc::Value(std::string(translated.fallback))) {
      ++context.unknown_parameters[spec.name];
    }
    if (translated.words[0].empty()) return write(spec, word, value);
    const std::string& choice = std::get<std::string>(value);
    if (choice == translated.words[0] || choice == translated.words[1]) {
      context.out.flag(word, choice == translated.words[1]);
    } else {  // more than pbrt's flag can say
      ++context.unknown_parameters[spec.name];
      write(spec, spec.name, value);
    }
  }

  void write(const ParameterSpec& spec, const desc::Value& value) const {
    const ParameterName* translated = names == nullptr ? nullptr : names->find(spec.name);
    // pbrt has a default where ours is absent.
    const bool is_absent = std::holds_alternative<std::monostate>(value) && translated != nullptr &&
                           !translated->if_absent.empty();
    const desc::Value& meant = is_absent ? node.get(translated->if_absent) : value;
    const auto substitute = substitutes.find(spec.name);
    const bool is_substituted = substitute != substitutes.end();
    if (!is_substituted && !node.matters(spec)) return;
    const desc::Value& told = is_substituted ? substitute->second : meant;
    if (is_substituted && std::holds_alternative<std::monostate>(told)) {  // by others
      if (meant != desc::default_value(spec)) write(spec, own_word(spec.name), meant);
      return;
    }
    if (translated == nullptr) {
      write_untranslated(spec, told);
    } else {
      write_translated(spec, *translated, told);
    }
    if (is_substituted && node.matters(spec)) write(spec, own_word(spec.name), meant);
  }
};

}  // namespace

void write_parameters(WriterContext& context, const desc::Node& node, const ModelName* names,
                      bool numbers_for_colors, const Substitutes& substitutes) {
  if (names == nullptr) ++context.unknown_models[node.model().name];
  const ParameterWriter writer{context, node, names, numbers_for_colors, substitutes};
  for (std::size_t i = 0; i < node.values().size(); ++i) {
    writer.write(node.model().parameters[i], node.values()[i]);
  }
}

void write_own_words(WriterContext& context, const desc::Node& node) {
  context.out.parameter("string " + std::string(kOwnModel), node.model().name);
  for (std::size_t i = 0; i < node.values().size(); ++i) {
    const ParameterSpec& spec = node.model().parameters[i];
    const std::string word = own_word(spec.name);
    std::visit(ValueWriter{context, spec, word, false}, node.values()[i]);
  }
}

}  // namespace ajar::pbrt
