#pragma once
#include <gtest/gtest.h>

#include <memory>

#include "scene/desc/node.h"

namespace ajar::testing {

/// A value that is not the default.
inline desc::Value another_value(const ParameterSpec& spec) {
  switch (spec.type) {
    case ParameterType::Bool:
      return spec.default_value != "true";
    case ParameterType::Int:
      return std::get<int>(desc::default_value(spec)) + 1;
    case ParameterType::Float:
      return 0.375F;
    case ParameterType::Color:
    case ParameterType::Vector:
    case ParameterType::Point:
      return Vec3(0.125F, 0.375F, 0.625F);
    case ParameterType::Choice:
      return spec.choices.back();
    case ParameterType::Text:
      return "text";
    case ParameterType::File:
      return "/somewhere/picture.exr";
    case ParameterType::Material:
      return desc::MaterialRef{0};
    case ParameterType::Transform: {
      Mat4 place;
      place.setTranslation(Vec3d(1.0, 2.0, 3.0));
      return std::make_shared<const Mat4>(place);
    }
  }
  ADD_FAILURE() << spec.name;
  return {};
}

}  // namespace ajar::testing
