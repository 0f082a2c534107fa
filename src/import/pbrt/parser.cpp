#include "import/pbrt/parser.h"

#include <algorithm>

#include "import/common/printable.h"

namespace ajar::pbrt {
namespace {

constexpr WarningKind kAfterEnd{Effect::Slight, "files go on after WorldEnd, which is ignored"};
constexpr WarningKind kLeftOver{Effect::Slight,
                                "parameters have numbers left over, which are ignored"};

constexpr std::size_t kDeepestInclude = 64;
constexpr int kMostFiles = 20000;
constexpr std::size_t kMostParameters = 1000;

const std::vector<std::string> kDirectives = {"Accelerator",
                                              "ActiveTransform",
                                              "AreaLightSource",
                                              "AttributeBegin",
                                              "AttributeEnd",
                                              "Camera",
                                              "ConcatTransform",
                                              "CoordinateSystem",
                                              "CoordSysTransform",
                                              "Film",
                                              "Identity",
                                              "Include",
                                              "Integrator",
                                              "LightSource",
                                              "LookAt",
                                              "MakeNamedMaterial",
                                              "MakeNamedMedium",
                                              "Material",
                                              "MediumInterface",
                                              "NamedMaterial",
                                              "ObjectBegin",
                                              "ObjectEnd",
                                              "ObjectInstance",
                                              "PixelFilter",
                                              "ReverseOrientation",
                                              "Rotate",
                                              "Sampler",
                                              "Scale",
                                              "Shape",
                                              "Texture",
                                              "Transform",
                                              "TransformBegin",
                                              "TransformEnd",
                                              "TransformTimes",
                                              "Translate",
                                              "WorldBegin",
                                              "WorldEnd"};

Mat4 matrix_of(const std::vector<double>& n) {
  return {n[0], n[1], n[2],  n[3],  n[4],  n[5],  n[6],  n[7],
          n[8], n[9], n[10], n[11], n[12], n[13], n[14], n[15]};
}

/// A file with zero bytes near its beginning is no text.
void refuse_binary(std::string_view text, const std::shared_ptr<const std::string>& file) {
  const std::string_view before = text.substr(0, 4096).substr(0, text.find('\0'));
  if (before.size() == std::min<std::size_t>(text.size(), 4096)) return;
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t column = before.size() - (before.rfind('\n') + 1) + 1;
  throw SceneError({file, static_cast<int>(line), static_cast<int>(column)},
                   "this is not a pbrt scene: it is a binary file, with a zero byte here");
}

}  // namespace

SourceLocation Parser::parse(std::string_view text, const std::string& name,
                             const std::string& path) {
  const auto file = std::make_shared<const std::string>(name);
  refuse_binary(text, file);
  open_files_.push_back(path);
  Lexer lexer(file, text);
  while (!builder_.world_ended() && lexer.peek().kind != TokenKind::End)
    directive(lexer, lexer.next());
  if (builder_.world_ended() && lexer.peek().kind != TokenKind::End) {
    warnings_.add(kAfterEnd, lexer.where(lexer.peek()), "everything after WorldEnd is ignored");
  }
  open_files_.pop_back();
  return lexer.where(lexer.peek());
}

void Parser::directive(Lexer& lexer, const Token& token) {
  const SourceLocation where = lexer.where(token);
  if (token.kind != TokenKind::Word)
    lexer.fail(token, "expected a directive, found \"" + printable(token.text) + "\"");
  if (thing_directive(lexer, token, where) || transform_directive(lexer, token, where) ||
      block_directive(lexer, token, where)) {
    return;
  }
  fail_unknown(where, "directive", token.text, kDirectives);
}

bool Parser::transform_directive(Lexer& lexer, const Token& token, const SourceLocation& where) {
  TransformState& state = builder_.transforms();
  const std::string_view directive = token.text;
  if (directive == "Identity") {
    state.replace(where, Mat4());
  } else if (directive == "Translate") {
    const std::vector<double> n = numbers(lexer, 3);
    state.concatenate(where, translation({n[0], n[1], n[2]}));
  } else if (directive == "Scale") {
    const std::vector<double> n = numbers(lexer, 3);
    state.concatenate(where, scaling({n[0], n[1], n[2]}));
  } else if (directive == "Rotate") {
    const std::vector<double> n = numbers(lexer, 4);
    const std::optional<Mat4> m = rotation(n[0], {n[1], n[2], n[3]});
    if (!m) throw SceneError(where, "the axis of this rotation has no direction");
    state.concatenate(where, *m);
  } else if (directive == "LookAt") {
    const std::vector<double> n = numbers(lexer, 9);
    const std::optional<Mat4> m =
        look_at({n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]});
    if (!m)
      throw SceneError(where,
                       "this LookAt has no viewing direction, or one that is parallel to \"up\"");
    state.concatenate(where, *m);
  } else if (directive == "Transform") {
    state.replace(where, matrix_of(numbers(lexer, 16)));
  } else if (directive == "ConcatTransform") {
    state.concatenate(where, matrix_of(numbers(lexer, 16)));
  } else if (directive == "CoordinateSystem") {
    state.define(name(lexer, token));
  } else if (directive == "CoordSysTransform") {
    state.recall(where, name(lexer, token));
  } else if (directive == "ActiveTransform") {
    const Token which = lexer.next();
    state.activate(lexer.where(which), which.text);
  } else if (directive == "TransformTimes") {
    numbers(lexer, 2);
  } else {
    return false;
  }
  return true;
}

bool Parser::block_directive(Lexer& lexer, const Token& token, const SourceLocation& where) {
  const std::string_view directive = token.text;
  if (directive == "AttributeBegin") {
    builder_.attribute_begin(where);
  } else if (directive == "AttributeEnd") {
    builder_.attribute_end(where);
  } else if (directive == "TransformBegin") {
    builder_.transform_begin(where);
  } else if (directive == "TransformEnd") {
    builder_.transform_end(where);
  } else if (directive == "ObjectBegin") {
    builder_.object_begin(where, name(lexer, token));
  } else if (directive == "ObjectEnd") {
    builder_.object_end(where);
  } else if (directive == "ObjectInstance") {
    builder_.object_instance(where, name(lexer, token));
  } else if (directive == "ReverseOrientation") {
    builder_.reverse_orientation(where);
  } else if (directive == "WorldBegin") {
    builder_.world_begin(where);
  } else if (directive == "WorldEnd") {
    builder_.world_end(where);
  } else if (directive == "Include") {
    include(lexer, where);
  } else {
    return false;
  }
  return true;
}

bool Parser::thing_directive(Lexer& lexer, const Token& token, const SourceLocation& where) {
  const std::string_view directive = token.text;
  const auto shared_parameters = [&] {
    return std::make_shared<const ParameterList>(parameters(lexer));
  };
  if (directive == "Shape") {
    const std::string type = name(lexer, token);
    builder_.shape(where, type, parameters(lexer));
  } else if (directive == "Material") {
    const std::string type = name(lexer, token);
    builder_.material(where, type, shared_parameters());
  } else if (directive == "MakeNamedMaterial") {
    const std::string material = name(lexer, token);
    builder_.make_named_material(where, material, shared_parameters());
  } else if (directive == "NamedMaterial") {
    builder_.named_material(where, name(lexer, token));
    parameters(lexer).report_unused(warnings_);
  } else if (directive == "Texture") {
    const std::string texture = name(lexer, token);
    const std::string texture_class = name(lexer, token);
    const std::string type = name(lexer, token);
    builder_.texture(where, texture, texture_class, type, parameters(lexer));
  } else if (directive == "LightSource") {
    const std::string type = name(lexer, token);
    builder_.light_source(where, type, parameters(lexer));
  } else if (directive == "AreaLightSource") {
    const std::string type = name(lexer, token);
    builder_.area_light_source(where, type, parameters(lexer));
  } else if (directive == "MakeNamedMedium") {
    const std::string medium = name(lexer, token);
    builder_.make_named_medium(where, medium, parameters(lexer));
  } else if (directive == "MediumInterface") {
    const std::string inside = name(lexer, token);
    const std::string outside =
        lexer.peek().kind == TokenKind::String ? name(lexer, token) : inside;
    builder_.medium_interface(where, inside, outside);
  } else if (directive == "Camera") {
    const std::string type = name(lexer, token);
    builder_.camera(where, type, parameters(lexer));
  } else if (directive == "Film") {
    const std::string type = name(lexer, token);
    builder_.film(where, type, parameters(lexer));
  } else if (directive == "PixelFilter") {
    const std::string type = name(lexer, token);
    builder_.pixel_filter(where, type, parameters(lexer));
  } else if (directive == "Sampler") {
    const std::string type = name(lexer, token);
    builder_.sampler(where, type, parameters(lexer));
  } else if (directive == "Integrator") {
    const std::string type = name(lexer, token);
    builder_.integrator(where, type, parameters(lexer));
  } else if (directive == "Accelerator") {
    name(lexer, token);  // ours is Embree, whatever the file wants
    parameters(lexer);
  } else {
    return false;
  }
  return true;
}

void Parser::include(Lexer& lexer, const SourceLocation& where) {
  const std::string included = name(lexer, {TokenKind::Word, "Include", 0, 0});
  if (open_files_.size() >= kDeepestInclude)
    throw SceneError(where, "files include each other too deeply");
  if (++files_parsed_ > kMostFiles) throw SceneError(where, "too many files are included");
  try {
    const std::string path = files_.resolve(included);
    if (std::find(open_files_.begin(), open_files_.end(), path) != open_files_.end()) {
      throw SceneError(where, "\"" + printable(included) + "\" includes itself");
    }
    const FileBytes bytes = files_.load(path);
    parse(bytes.view(), included, path);
  } catch (const IoError& error) {
    throw SceneError(where, error.what());
  }
}

// ---------------------------------------------------------------- pieces of directives

std::string Parser::name(Lexer& lexer, const Token& directive) {
  const Token token = lexer.next();
  if (token.kind != TokenKind::String) {
    lexer.fail(token,
               std::string(directive.text) + " needs a quoted name here" +
                   (token.kind == TokenKind::End ? "" : ", not \"" + printable(token.text) + "\""));
  }
  return lexer.string_value(token);
}

std::vector<double> Parser::numbers(Lexer& lexer, std::size_t count) {
  const bool bracket = lexer.peek().kind == TokenKind::Open;
  if (bracket) lexer.next();
  std::vector<double> result;
  for (std::size_t i = 0; i < count; ++i) result.push_back(lexer.double_value(lexer.next()));
  if (bracket) {
    const Token close = lexer.next();
    if (close.kind != TokenKind::Close)
      lexer.fail(close, "expected ] after " + std::to_string(count) + " numbers");
  }
  return result;
}

ParameterList Parser::parameters(Lexer& lexer) {
  ParameterList list;
  std::size_t count = 0;
  while (lexer.peek().kind == TokenKind::String) {
    if (++count > kMostParameters) lexer.fail(lexer.peek(), "too many parameters");
    list.add(parameter(lexer), warnings_);
  }
  return list;
}

Parameter Parser::parameter(Lexer& lexer) {
  const Token declaration = lexer.next();
  Parameter result;
  result.where = lexer.where(declaration);
  constexpr std::string_view kSpace = " \t\r";
  const std::string text = lexer.string_value(declaration);
  const std::size_t type_begin = std::min(text.find_first_not_of(kSpace), text.size());
  const std::size_t type_end = std::min(text.find_first_of(kSpace, type_begin), text.size());
  const std::size_t name_begin = std::min(text.find_first_not_of(kSpace, type_end), text.size());
  const std::size_t name_end = std::min(text.find_first_of(kSpace, name_begin), text.size());
  const std::string type = text.substr(type_begin, type_end - type_begin);
  result.name = text.substr(name_begin, name_end - name_begin);
  if (result.name.empty() || text.find_first_not_of(kSpace, name_end) != std::string::npos) {
    lexer.fail(declaration,
               "expected a parameter as \"type name\", found \"" + printable(text) + "\"");
  }
  const std::optional<ParameterKind> kind = kind_from_name(type);
  if (!kind) {
    static const std::vector<std::string> kValid = {
        "integer", "float",   "point2", "vector2", "point", "vector",    "normal",  "bool",
        "string",  "texture", "rgb",    "color",   "xyz",   "blackbody", "spectrum"};
    lexer.fail(declaration, unknown_name_message("parameter type", printable(type), kValid));
  }
  result.kind = *kind;

  const Token first = lexer.next();
  if (first.kind == TokenKind::Open) {
    for (Token token = lexer.next(); token.kind != TokenKind::Close; token = lexer.next()) {
      if (token.kind == TokenKind::End) lexer.fail(first, "this bracket is never closed");
      value(lexer, token, result);
    }
  } else {
    value(lexer, first, result);
  }
  const auto per_value = static_cast<std::size_t>(numbers_per_value(result.kind));
  if (const std::size_t excess = result.numbers.size() % per_value; excess > 0) {
    warnings_.add(kLeftOver, result.where,
                  "\"" + printable(text) + "\" takes " + std::to_string(per_value) +
                      " numbers per value: the last " + std::to_string(excess) + " ignored",
                  printable(text));
    result.numbers.resize(result.numbers.size() - excess);
  }
  return result;
}

void Parser::value(Lexer& lexer, const Token& token, Parameter& parameter) {
  switch (parameter.kind) {
    case ParameterKind::Integer:
      parameter.integers.push_back(lexer.int_value(token));
      return;
    case ParameterKind::Bool: {
      const bool is_value = (token.kind == TokenKind::String || token.kind == TokenKind::Word) &&
                            (token.text == "true" || token.text == "false");
      if (!is_value)
        lexer.fail(token, "expected true or false, found \"" + printable(token.text) + "\"");
      parameter.strings.emplace_back(token.text);
      return;
    }
    case ParameterKind::String:
    case ParameterKind::Texture:
      if (token.kind != TokenKind::String) {
        lexer.fail(token, "expected a quoted string, found \"" + printable(token.text) + "\"");
      }
      parameter.strings.push_back(lexer.string_value(token));
      return;
    case ParameterKind::Spectrum:
      if (token.kind == TokenKind::String) {
        if (!parameter.numbers.empty())
          lexer.fail(token, "a spectrum is either numbers or a file name");
        parameter.strings.push_back(lexer.string_value(token));
        return;
      }
      if (!parameter.strings.empty())
        lexer.fail(token, "a spectrum is either numbers or a file name");
      [[fallthrough]];
    default:
      parameter.numbers.push_back(lexer.float_value(token));
  }
}

}  // namespace ajar::pbrt
