#include "import/mitsuba/property_reader.h"

#include <algorithm>
#include <array>

#include "color/color.h"
#include "core/printable_text.h"
#include "import/common/transforms.h"
#include "import/mitsuba/numbers.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kUnusableSpectrum{Effect::Surface,
                                        "spectra cannot be used: what they are of has its default"};
constexpr WarningKind kAnimation{Effect::Geometry, "things move: they stay where they begin"};

constexpr std::array<std::string_view, 14> kPropertyTags = {
    "boolean", "integer", "float",     "string", "vector",    "point",    "rgb",
    "srgb",    "xyz",     "blackbody", "color",  "transform", "spectrum", "animation"};

}  // namespace

bool is_property_tag(std::string_view tag) {
  return std::find(kPropertyTags.begin(), kPropertyTags.end(), tag) != kPropertyTags.end();
}

bool is_value_tag(std::string_view tag) {
  constexpr std::array<std::string_view, 7> kValueTags = {"float", "rgb",       "srgb",    "xyz",
                                                          "color", "blackbody", "spectrum"};
  return std::find(kValueTags.begin(), kValueTags.end(), tag) != kValueTags.end();
}

std::optional<PropertyValue> PropertyReader::read(const pugi::xml_node& node) const {
  const std::string_view tag = node.name();
  const auto checked = [&](auto value, const char* expected) -> PropertyValue {
    if (!value) fail_value(node, "value", expected);
    return *value;
  };
  if (tag == "boolean") return checked(parse_boolean(text(node, "value")), "true or false");
  if (tag == "integer") return checked(parse_integer(text(node, "value")), "a whole number");
  if (tag == "float") return checked(parse_number(text(node, "value")), "a number");
  if (tag == "string") return text(node, "value");
  if (tag == "vector" || tag == "point") return triple(node, 0.0);
  if (tag == "transform") return read_transform(node);
  if (tag == "animation") {
    warnings_.add(kAnimation, file_.where(node),
                  "motion is not supported: only the first transform of it is used");
    const pugi::xml_node first = node.child("transform");
    return first ? read_transform(first) : Mat4();
  }
  const std::optional<desc::Rgb> color = read_color(node);
  return color ? std::optional<PropertyValue>(*color) : std::nullopt;
}

// ---------------------------------------------------------------- colours

std::optional<desc::Rgb> PropertyReader::read_color(const pugi::xml_node& node) const {
  const std::string_view tag = node.name();
  if (tag == "spectrum") return read_spectrum(node);
  if (tag == "blackbody") {
    std::string kelvin = text(node, "temperature");
    if (!kelvin.empty() && kelvin.back() == 'K') kelvin.pop_back();
    const std::optional<double> temperature = parse_number(kelvin);
    if (!temperature) fail_value(node, "temperature", "a number of kelvins");
    return desc::Rgb(blackbody(*temperature) * number(node, "scale", 1.0));
  }
  const std::optional<Vec3d> lanes = triple_in(node, "value");
  if (!lanes) fail_value(node, "value", "one number, three numbers, or #rrggbb");
  if (tag == "srgb") return desc::Rgb(srgb_to_linear(*lanes));
  if (tag == "xyz") return desc::Rgb(xyz_to_rgb(*lanes));
  return desc::Rgb(*lanes);
}

std::optional<desc::Rgb> PropertyReader::read_spectrum(const pugi::xml_node& node) const {
  if (node.attribute("filename")) return read_spectrum_file(node);
  std::string value = text(node, "value");
  if (seen_ == Seen::Emitted && parse_number(value)) value = "300:" + value + ", 900:" + value;
  const std::optional<Vec3d> color =
      value.find(':') == std::string::npos ? parse_triple(value) : parse_spectrum(value, seen_);
  if (!color)
    fail_value(node, "value", "a number, or wavelengths with values as in \"400:1, 700:0\"");
  return desc::Rgb(*color);
}

std::optional<desc::Rgb> PropertyReader::read_spectrum_file(const pugi::xml_node& node) const {
  const std::string name = text(node, "filename");
  try {
    return desc::Rgb(read_spectrum_of(files_, name, seen_, file_.where(node), warnings_));
  } catch (const Error& error) {
    warnings_.add(kUnusableSpectrum, file_.where(node),
                  "spectrum \"" + printable(name) + "\" cannot be used (" + error.what() + "): \"" +
                      printable(node.attribute("name").value()) + "\" has its default",
                  printable(name));
    return std::nullopt;
  }
}

// ---------------------------------------------------------------- transforms

Mat4 PropertyReader::read_transform(const pugi::xml_node& node) const {
  Mat4 result;
  for (const pugi::xml_node& step : node.children()) {
    if (step.type() == pugi::node_element) result = result * read_step(step);
  }
  if (!is_finite(result)) fail(node, "this transform has numbers that are not finite");
  return result;
}

Mat4 PropertyReader::read_step(const pugi::xml_node& node) const {
  static const std::vector<std::string> kSteps = {"translate", "rotate", "scale", "matrix",
                                                  "lookat"};
  const std::string tag = node.name();
  if (tag == "translate") return translation(triple(node, 0.0));
  if (tag == "scale") return scaling(triple(node, 1.0));
  if (tag == "matrix") return read_matrix(node);
  if (tag == "lookat" || tag == "lookAt" || tag == "look_at") return read_look_at(node);
  if (tag == "rotate") {
    const std::optional<Mat4> turn = rotation(number(node, "angle", 0.0), triple(node, 0.0));
    if (!turn) fail(node, "the axis of this rotation has no direction");
    return *turn;
  }
  fail(node, unknown_name_message("transform", printable(tag), kSteps));
}

Mat4 PropertyReader::read_matrix(const pugi::xml_node& node) const {
  const std::optional<std::vector<double>> n = parse_numbers(text(node, "value"));
  if (!n || (n->size() != 16 && n->size() != 9)) {
    fail_value(node, "value", "16 numbers, or 9, row by row");
  }
  // Mitsuba multiplies columns from the right; ours is the transpose.
  Mat4 result;
  const std::size_t size = n->size() == 16 ? 4 : 3;
  for (std::size_t row = 0; row < size; ++row) {
    for (std::size_t column = 0; column < size; ++column) {
      result.x[column][row] = (*n)[row * size + column];
    }
  }
  return result;
}

Mat4 PropertyReader::read_look_at(const pugi::xml_node& node) const {
  const auto point = [&](const char* name) {
    const std::optional<Vec3d> p = triple_in(node, name);
    if (!p) fail_value(node, name, "three numbers");
    return *p;
  };
  const Vec3d origin = point("origin");
  const Vec3d target = point("target");
  if (!node.attribute("up")) {
    if (const std::optional<Mat4> turn = z_to(target - origin)) return *turn * translation(origin);
  } else if (const std::optional<Mat4> to_local = look_at(origin, target, point("up"))) {
    return *inverse(*to_local);
  }
  fail(node, "this look-at has no direction, or one parallel to \"up\"");
}

// ---------------------------------------------------------------- attributes

std::string PropertyReader::text(const pugi::xml_node& node, const char* attribute) const {
  return definitions_.substitute(node.attribute(attribute).value(), file_.where(node));
}

double PropertyReader::number(const pugi::xml_node& node, const char* attribute,
                              double fallback) const {
  if (!node.attribute(attribute)) return fallback;
  const std::optional<double> value = parse_number(text(node, attribute));
  if (!value) fail_value(node, attribute, "a number");
  return *value;
}

Vec3d PropertyReader::triple(const pugi::xml_node& node, double fallback) const {
  if (!node.attribute("value")) {
    return {number(node, "x", fallback), number(node, "y", fallback), number(node, "z", fallback)};
  }
  const std::optional<Vec3d> value = triple_in(node, "value");
  if (!value) fail_value(node, "value", "one number, or three");
  return *value;
}

std::optional<Vec3d> PropertyReader::triple_in(const pugi::xml_node& node,
                                               const char* attribute) const {
  return parse_triple(text(node, attribute));
}

void PropertyReader::fail(const pugi::xml_node& node, const std::string& message) const {
  throw SceneError(file_.where(node), message);
}

void PropertyReader::fail_value(const pugi::xml_node& node, const char* attribute,
                                const std::string& expected) const {
  const std::string name = node.attribute("name").value();
  fail(node, "<" + printable(node.name()) + ">" +
                 (name.empty() ? "" : " \"" + printable(name) + "\"") + ": \"" + attribute +
                 "\" must be " + expected + ", not \"" + printable(text(node, attribute)) + "\"");
}

}  // namespace ajar::mitsuba
