#include "scene/desc/declare.h"

#include <utility>

namespace ajar::declare {
namespace {

ParameterSpec of_type(ParameterType type, std::string name, std::string value, std::string help) {
  return {.name = std::move(name),
          .type = type,
          .default_value = std::move(value),
          .unit = "",
          .help = std::move(help),
          .choices = {}};
}

ParameterSpec textured(ParameterSpec spec, double minimum, double maximum) {
  spec.textured = true;
  spec.minimum = minimum;
  spec.maximum = maximum;
  return spec;
}

}  // namespace

ParameterSpec flag(std::string name, std::string help) {
  return of_type(ParameterType::Bool, std::move(name), "false", std::move(help));
}

ParameterSpec integer(std::string name, std::string value, std::string help, int minimum,
                      int maximum) {
  ParameterSpec spec =
      of_type(ParameterType::Int, std::move(name), std::move(value), std::move(help));
  spec.minimum = minimum;
  spec.maximum = maximum;
  return spec;
}

ParameterSpec number(std::string name, std::string value, std::string help, std::string unit) {
  ParameterSpec spec =
      of_type(ParameterType::Float, std::move(name), std::move(value), std::move(help));
  spec.unit = std::move(unit);
  return spec;
}

ParameterSpec number_between(std::string name, std::string value, std::string unit,
                             std::string help, double minimum, double maximum) {
  ParameterSpec spec = number(std::move(name), std::move(value), std::move(help), std::move(unit));
  spec.minimum = minimum;
  spec.maximum = maximum;
  spec.open_range = true;
  return spec;
}

ParameterSpec vector(std::string name, std::string value, std::string help) {
  return of_type(ParameterType::Vector, std::move(name), std::move(value), std::move(help));
}

ParameterSpec point(std::string name, std::string value, std::string help) {
  return of_type(ParameterType::Point, std::move(name), std::move(value), std::move(help));
}

ParameterSpec transform(std::string name, std::string help) {
  return of_type(ParameterType::Transform, std::move(name), "", std::move(help));
}

ParameterSpec file(std::string name, std::string help) {
  return of_type(ParameterType::File, std::move(name), "", std::move(help));
}

ParameterSpec material(std::string name, std::string help) {
  return of_type(ParameterType::Material, std::move(name), "", std::move(help));
}

ParameterSpec mesh(std::string name, std::string help) {
  return of_type(ParameterType::Mesh, std::move(name), "", std::move(help));
}

ParameterSpec curves(std::string name, std::string help) {
  return of_type(ParameterType::Curves, std::move(name), "", std::move(help));
}

ParameterSpec color(std::string name, std::string value, std::string help) {
  return of_type(ParameterType::Color, std::move(name), std::move(value), std::move(help));
}

ParameterSpec emission(std::string name, std::string unit, std::string help) {
  ParameterSpec spec = color(std::move(name), "1", std::move(help));
  spec.unit = std::move(unit);
  spec.minimum = 0.0;
  return spec;
}

ParameterSpec textured_emission(std::string name, std::string unit, std::string help) {
  return textured(emission(std::move(name), std::move(unit), std::move(help)), 0.0, 1e300);
}

ParameterSpec textured_color(std::string name, std::string value, std::string help) {
  return textured(color(std::move(name), std::move(value), std::move(help)), -1e300, 1e300);
}

ParameterSpec reflectance(std::string name, std::string value, std::string help) {
  return textured(color(std::move(name), std::move(value), std::move(help)), 0.0, 1.0);
}

ParameterSpec textured_number(std::string name, std::string value, std::string help,
                              double maximum) {
  return textured(number(std::move(name), std::move(value), std::move(help)), 0.0, maximum);
}

ParameterSpec only_for(std::string name, std::vector<std::string> values, ParameterSpec spec) {
  spec.depends_on = std::move(name);
  spec.matters_for = std::move(values);
  return spec;
}

std::vector<ParameterSpec> joined(std::vector<ParameterSpec> first,
                                  const std::vector<ParameterSpec>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

}  // namespace ajar::declare
