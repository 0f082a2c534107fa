#include "import/pbrt/parser.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "core/printable_text.h"
#include "import/mesh/gzip.h"

namespace ajar::pbrt {
namespace {

constexpr WarningKind kAccelerator{Effect::None, "accelerators are unknown: ignored"};
constexpr WarningKind kUnknownDirective{Effect::Surface, "directives are unknown and skipped"};
constexpr WarningKind kUnknownType{Effect::Surface, "parameters are of unknown types and ignored"};
constexpr WarningKind kAfterEnd{Effect::Slight, "files go on after WorldEnd, which is ignored"};
constexpr WarningKind kNoInclude{Effect::Geometry, "files to include are missing: left out"};
constexpr WarningKind kLeftOver{Effect::Slight,
                                "parameters have numbers left over, which are ignored"};

constexpr std::size_t kDeepestInclude = 64;
constexpr int kMostFiles = 20000;
constexpr std::size_t kMostParameters = 1000;

/// A file that claims to be larger than this when it is decompressed is none of ours.
constexpr std::size_t kMostBytes = std::size_t{1} << 32;

const std::vector<std::string>& directives(Dialect dialect) {
  static const std::vector<std::string> kCommon = {"Accelerator",
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
                                                   "WorldBegin"};
  static const auto kAll = [] {
    std::array<std::vector<std::string>, 2> all = {kCommon, kCommon};
    all[0].emplace_back("WorldEnd");
    all[1].insert(all[1].end(), {"Attribute", "ColorSpace", "Import", "Option"});
    return all;
  }();
  return kAll[dialect == Dialect::V3 ? 0 : 1];
}

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

bool starts_directive(const Token& token) {
  return token.kind == TokenKind::Word && token.text[0] >= 'A' && token.text[0] <= 'Z';
}

}  // namespace

SourceLocation Parser::parse(std::string_view text, const std::string& name,
                             const std::string& path, Lexer* after) {
  const auto file = std::make_shared<const std::string>(name);
  refuse_binary(text, file);
  open_files_.push_back(path);
  Lexer lexer(file, text, after);
  while (!builder_.world_ended() && !lexer.is_at_own_end()) directive(lexer, lexer.next());
  if (builder_.world_ended() && !lexer.is_at_own_end()) {
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
      block_directive(lexer, token, where) ||
      (dialect_ == Dialect::V4 && directive_of_v4(lexer, token, where))) {
    return;
  }
  report_unknown(builder_.context(), where, "directive", token.text, directives(dialect_),
                 kUnknownDirective, "It is skipped");
  skip_directive(lexer);
}

void Parser::skip_directive(Lexer& lexer) {
  while (lexer.peek().kind != TokenKind::End && !starts_directive(lexer.peek())) lexer.next();
}

void Parser::option(Lexer& lexer, const SourceLocation& where) {
  // pbrt writes the name alone: Option "seed" 3. As a parameter, "integer seed", it is read, too.
  const Token named = lexer.peek();
  const std::string text = lexer.string_value(named);
  if (text.find(' ') != std::string::npos) {
    if (const std::optional<Parameter> given = parameter(lexer)) {
      const bool is_off = !given->strings.empty() && given->strings.front() == "false";
      builder_.option(where, given->where, given->name, !is_off);
    }
    return;
  }
  lexer.next();
  const Token value = lexer.peek();
  if (value.kind == TokenKind::End || starts_directive(value)) {
    lexer.fail(named, "the option \"" + printable(text) + "\" has no value");
  }
  const bool is_on = value.text != "false";
  skip_values(lexer);
  builder_.option(where, lexer.where(named), text, is_on);
}

bool Parser::directive_of_v4(Lexer& lexer, const Token& token, const SourceLocation& where) {
  const std::string_view directive = token.text;
  if (directive == "Attribute") {
    const std::string target = name(lexer, token);
    builder_.attribute(where, target, parameters(lexer));
  } else if (directive == "ColorSpace") {
    builder_.color_space(where, name(lexer, token));
  } else if (directive == "Option") {
    if (lexer.peek().kind != TokenKind::String) {
      lexer.fail(lexer.peek(), "Option needs a parameter here, as \"type name\" value");
    }
    option(lexer, where);
  } else if (directive == "Import") {
    builder_.import_begin(where);
    include(lexer, where, false);
    builder_.import_end();
  } else {
    return false;
  }
  return true;
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
    include(lexer, where, true);
  } else {
    return false;
  }
  return true;
}

bool Parser::thing_directive(Lexer& lexer, const Token& token, const SourceLocation& where) {
  const std::string_view directive = token.text;
  const auto shared_parameters = [&] {
    return std::make_shared<const ParameterList>(parameters(lexer, "material"));
  };
  if (directive == "Shape") {
    const std::string type = name(lexer, token);
    builder_.shape(where, type, parameters(lexer, "shape"));
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
    builder_.texture(where, texture, texture_class, type, parameters(lexer, "texture"));
  } else if (directive == "LightSource") {
    const std::string type = name(lexer, token);
    builder_.light_source(where, type, parameters(lexer, "light"));
  } else if (directive == "AreaLightSource") {
    const std::string type = name(lexer, token);
    builder_.area_light_source(where, type, parameters(lexer, "light"));
  } else if (directive == "MakeNamedMedium") {
    const std::string medium = name(lexer, token);
    builder_.make_named_medium(where, medium, parameters(lexer, "medium"));
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
    // Embree is used, whatever the file asks for.
    const std::string type = name(lexer, token);
    const ParameterList list = parameters(lexer);
    if (type != "bvh" && type != "kdtree") {
      warnings_.add(kAccelerator, where,
                    "unknown accelerator \"" + printable(type) + "\": ignored");
    }
    list.accept({"maxnodeprims", "splitmethod", "intersectcost", "traversalcost", "emptybonus",
                 "maxprims", "maxdepth"});
    list.report_unused(warnings_);
  } else {
    return false;
  }
  return true;
}

bool Parser::is_missing(const std::string& included) const {
  try {
    const std::string path = files_.resolve(included);
    return !files_.exists(path) && !std::filesystem::exists(std::filesystem::symlink_status(path));
  } catch (const std::runtime_error&) {
    return false;  // `open` reports the error
  }
}

Parser::OpenFile Parser::open(const std::string& included, const SourceLocation& where) {
  if (open_files_.size() >= kDeepestInclude)
    throw SceneError(where, "files include each other too deeply");
  try {
    const std::string path = files_.resolve(included, where);
    if (std::find(open_files_.begin(), open_files_.end(), path) != open_files_.end()) {
      throw SceneError(where, "\"" + printable(included) + "\" includes itself");
    }
    if (peeked_ && peeked_->path == path) {
      OpenFile file = std::move(*peeked_);
      peeked_.reset();
      return file;
    }
    if (++files_parsed_ > kMostFiles) throw SceneError(where, "too many files are included");
    OpenFile file{included, path, files_.load_text(path), {}};
    if (is_gzip(file.bytes.view())) {
      std::optional<std::string> text = gunzip(file.bytes.view(), kMostBytes);
      if (!text) throw IoError("\"" + printable(included) + "\" is a damaged gzip file");
      file.decompressed = std::move(*text);
    }
    return file;
  } catch (const IoError& error) {
    throw SceneError(where, error.what());
  }
}

void Parser::include(Lexer& lexer, const SourceLocation& where, bool goes_on) {
  const std::string included = name(lexer, {TokenKind::Word, "Include", 0, 0});
  if (is_missing(included)) {
    warn_of_missing(included, where);
    return;
  }
  const OpenFile file = open(included, where);
  parse(file.text(), file.name, file.path, goes_on ? &lexer : nullptr);
}

void Parser::warn_of_missing(const std::string& included, const SourceLocation& where) {
  warnings_.add(kNoInclude, where,
                "\"" + printable(included) + "\" is not there: what it should include is left out",
                printable(included));
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

ParameterList Parser::parameters(Lexer& lexer, std::string_view target) {
  ParameterList list;
  std::size_t count = 0;
  read_parameters(lexer, list, count);
  if (!target.empty()) list.add_defaults(builder_.attributes(target), warnings_);
  return list;
}

void Parser::read_parameters(Lexer& lexer, ParameterList& list, std::size_t& count) {
  do {
    while (lexer.peek().kind == TokenKind::String) {
      if (++count > kMostParameters) lexer.fail(lexer.peek(), "too many parameters");
      if (std::optional<Parameter> read = parameter(lexer)) list.add(std::move(*read), warnings_);
    }
  } while (read_included_parameters(lexer, list, count));
}

bool Parser::read_included_parameters(Lexer& lexer, ParameterList& list, std::size_t& count) {
  if (lexer.peek().kind != TokenKind::Word || lexer.peek().text != "Include") return false;
  Lexer& source = lexer.current();
  Lexer ahead = source;
  const SourceLocation where = ahead.where(ahead.next());
  if (ahead.is_at_own_end() || ahead.peek().kind != TokenKind::String) return false;
  const std::string included = ahead.string_value(ahead.next());
  const bool goes_on = ahead.peek().kind == TokenKind::String;
  if (is_missing(included)) {
    if (!goes_on) return false;  // maybe of directives: for the Include itself
    warn_of_missing(included, where);
    source = ahead;
    return true;
  }
  OpenFile file = open(included, where);
  Lexer inner(std::make_shared<const std::string>(file.name), file.text());
  const bool is_among_parameters =
      inner.peek().kind == TokenKind::String || (inner.is_at_own_end() && goes_on);
  if (!is_among_parameters) {
    peeked_ = std::move(file);  // directives: for the Include itself
    return false;
  }
  source = ahead;
  open_files_.push_back(file.path);
  read_parameters(inner, list, count);
  open_files_.pop_back();
  if (inner.peek().kind != TokenKind::End) {
    inner.fail(inner.peek(), "expected parameters only, as this file starts with some, found \"" +
                                 printable(inner.peek().text) + "\"");
  }
  return true;
}

std::optional<Parameter> Parser::parameter(Lexer& lexer) {
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
    report_unknown(builder_.context(), result.where, "parameter type", type, kValid, kUnknownType,
                   "The parameter is ignored");
    skip_values(lexer);
    return std::nullopt;
  }
  result.kind = *kind;
  result.dialect = dialect_;
  result.color_space = builder_.color_space();

  const Token first = lexer.next();
  if (first.kind == TokenKind::Open) {
    for (Token token = lexer.next(); token.kind != TokenKind::Close; token = lexer.next()) {
      if (token.kind == TokenKind::End) lexer.fail(first, "this bracket is never closed");
      value(lexer, token, result);
    }
  } else {
    value(lexer, first, result);
  }
  const auto per_value = static_cast<std::size_t>(numbers_per_value(result.kind, dialect_));
  if (const std::size_t excess = result.numbers.size() % per_value; excess > 0) {
    warnings_.add(kLeftOver, result.where,
                  "\"" + printable(text) + "\" takes " + std::to_string(per_value) +
                      " numbers per value: the last " + std::to_string(excess) + " ignored",
                  printable(text));
    result.numbers.resize(result.numbers.size() - excess);
  }
  return result;
}

void Parser::skip_values(Lexer& lexer) {
  const Token first = lexer.next();
  if (first.kind != TokenKind::Open) return;
  for (Token token = lexer.next(); token.kind != TokenKind::Close; token = lexer.next()) {
    if (token.kind == TokenKind::End) lexer.fail(first, "this bracket is never closed");
  }
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
