#include "import/mitsuba/spectrum_plugins.h"

#include <algorithm>
#include <array>

#include "color/color.h"
#include "core/printable_text.h"
#include "import/mitsuba/arguments.h"
#include "import/mitsuba/numbers.h"
#include "import/mitsuba/plugin_types.h"
#include "import/mitsuba/spectra.h"

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kUnknownSpectrum{Effect::Surface, "spectra are unknown: others stand in"};

constexpr std::array<std::string_view, 8> kTypes = {
    "uniform", "d65", "srgb", "rgb", "blackbody", "irregular", "regular", "rawconstant"};

/// Wavelengths and values, written side by side or, at even steps, from one to another.
desc::Rgb sampled(Arguments& arguments) {
  const auto list = [&](const char* name) {
    const std::optional<std::vector<double>> numbers =
        parse_numbers(arguments.text(name).value_or(""));
    if (!numbers || numbers->empty()) {
      throw SceneError(arguments.where(),
                       "a spectrum needs numbers as \"" + std::string(name) + "\"");
    }
    return *numbers;
  };
  const std::vector<double> values = list("values");
  std::vector<double> wavelengths;
  if (arguments.element().type == "irregular") {
    wavelengths = list("wavelengths");
  } else {
    const double first = arguments.number("wavelength_min", 360.F);
    const double last = arguments.number("wavelength_max", 830.F);
    const double steps = values.size() > 1 ? static_cast<double>(values.size() - 1) : 1.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      wavelengths.push_back(first + (last - first) * static_cast<double>(i) / steps);
    }
  }
  if (wavelengths.size() != values.size()) {
    throw SceneError(arguments.where(), "a spectrum needs as many wavelengths as values");
  }
  return desc::Rgb(sampled_to_rgb(wavelengths, values));
}

}  // namespace

std::span<const std::string_view> spectrum_types() { return kTypes; }

bool is_spectrum(const Element& element) {
  return element.tag == "texture" &&
         std::find(kTypes.begin(), kTypes.end(), element.type) != kTypes.end();
}

desc::Rgb evaluate_spectrum(Context& context, const Element& element) {
  Arguments arguments(context, element);
  const std::string& type = element.type;
  const auto evaluate = [&]() -> desc::Rgb {
    if (type == "blackbody") {
      return desc::Rgb(blackbody(arguments.number("temperature", 5000.F))) *
             arguments.number("scale", 1.F);
    }
    if (type == "irregular" || type == "regular") return sampled(arguments);
    if (type == "d65" || type == "srgb" || type == "rgb") {
      const desc::Rgb color = arguments.color("color").value_or(desc::Rgb(1.F));
      return type == "d65" ? color * arguments.number("scale", 1.F) : color;
    }
    const desc::Rgb value = arguments.color("value").value_or(desc::Rgb(1.F));
    if (is_spectrum(element)) return value;
    context.warnings.add(kUnknownSpectrum, element.where,
                         unknown_type_message(element) + ". Its \"value\", or 1, stands in",
                         printable(type));
    arguments.accept_all();
    return value;
  };
  arguments.accept({"unbounded", "wavelength_min", "wavelength_max"});
  return evaluate();
}

}  // namespace ajar::mitsuba
