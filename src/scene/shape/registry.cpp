#include "scene/shape/registry.h"

namespace ajar {

// Each is defined in the file of its name. Listed by hand, because a linker drops self-registering
// objects of a library.
ShapeModel cone_shape();
ShapeModel curves_shape();
ShapeModel cylinder_shape();
ShapeModel disk_shape();
ShapeModel hyperboloid_shape();
ShapeModel mesh_shape();
ShapeModel paraboloid_shape();
ShapeModel sphere_shape();
ShapeModel subdivision_shape();

const std::vector<ShapeModel>& shape_models() {
  static const std::vector<ShapeModel> kModels{
      cone_shape(), curves_shape(),     cylinder_shape(), disk_shape(),       hyperboloid_shape(),
      mesh_shape(), paraboloid_shape(), sphere_shape(),   subdivision_shape()};
  return kModels;
}

}  // namespace ajar
