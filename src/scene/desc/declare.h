#pragma once
#include <string>
#include <vector>

#include "core/parameters.h"

/// Declarations of the parameters of models. Help is one line; a parameter with the default "" may
/// be left out and means something of its own then.
namespace ajar::declare {

ParameterSpec flag(std::string name, std::string help);
ParameterSpec integer(std::string name, std::string value, std::string help, int minimum,
                      int maximum);
ParameterSpec number(std::string name, std::string value, std::string help, std::string unit = "");
ParameterSpec vector(std::string name, std::string value, std::string help);
ParameterSpec point(std::string name, std::string value, std::string help);
/// The default is the identity.
ParameterSpec transform(std::string name, std::string help);
/// The default is none.
ParameterSpec file(std::string name, std::string help);
/// A material before the one that refers to it. There is no default.
ParameterSpec material(std::string name, std::string help);
/// Typed data that a shape is made of (`scene/desc/shape_data.h`). There is no default.
ParameterSpec mesh(std::string name, std::string help);
ParameterSpec curves(std::string name, std::string help);
/// A colour of any size.
ParameterSpec color(std::string name, std::string value, std::string help);
/// A colour with lanes from 0 on, white unless given: how strong a light is.
ParameterSpec emission(std::string name, std::string unit, std::string help);
/// An emission parameter that may be a texture.
ParameterSpec textured_emission(std::string name, std::string unit, std::string help);
/// A number within (minimum, maximum).
ParameterSpec number_between(std::string name, std::string value, std::string unit,
                             std::string help, double minimum, double maximum);
/// A colour of any size, or a texture.
ParameterSpec textured_color(std::string name, std::string value, std::string help);
/// A colour with lanes from 0 to 1, or a texture.
ParameterSpec reflectance(std::string name, std::string value, std::string help);
/// A number from 0 on, or a texture.
ParameterSpec textured_number(std::string name, std::string value, std::string help,
                              double maximum = 1e300);

/// `spec`, of which the value matters only while the choice `name` has one of `values`.
ParameterSpec only_for(std::string name, std::vector<std::string> values, ParameterSpec spec);
/// Both lists as one.
std::vector<ParameterSpec> joined(std::vector<ParameterSpec> first,
                                  const std::vector<ParameterSpec>& second);

}  // namespace ajar::declare
