#pragma once
#include <gtest/gtest.h>

#include <memory>

#include "scene/desc/node.h"
#include "scene/desc/shape_data.h"

namespace ajar::testing {

/// A value that is not the default.
inline desc::Value another_value(const ParameterSpec& spec) {
  switch (spec.type) {
    case ParameterType::Bool:
      return spec.default_value != "true";
    case ParameterType::Int:
      return std::get<int>(desc::default_value(spec)) + 1;
    case ParameterType::Float:
      return 0.375F + static_cast<float>(spec.minimum > 0.375 ? spec.minimum : 0.0);
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
    case ParameterType::Mesh: {
      desc::Mesh mesh;
      mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
      mesh.indices = {{0, 1, 2}};
      return std::make_shared<const desc::Mesh>(mesh);
    }
    case ParameterType::Curves: {
      desc::Curves curves;
      curves.control_points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 1, 0}};
      curves.widths.assign(4, 0.5F);
      curves.normals.assign(4, {0, 0, 1});
      return std::make_shared<const desc::Curves>(curves);
    }
  }
  ADD_FAILURE() << spec.name;
  return {};
}

}  // namespace ajar::testing
