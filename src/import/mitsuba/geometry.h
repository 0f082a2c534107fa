#pragma once
#include <optional>

#include "import/mesh/mesh_loader.h"
#include "import/mitsuba/arguments.h"
#include "scene/desc/models.h"

namespace ajar::mitsuba {

/// The form of a `<shape>`.
struct Geometry {
  desc::Node node;
  Mat4 to_shape;           ///< from the space of our node to that of Mitsuba's shape
  bool is_closed = false;  ///< invisible from within, unless it is transparent
  std::string name = {};   ///< name of a file
};

/// Empty, after a warning, for shapes that are not supported or make no sense.
std::optional<Geometry> make_geometry(Arguments& arguments, MeshLoader& meshes);

// In mesh_geometry.cpp:
/// obj, ply and serialized.
std::optional<Geometry> make_mesh_geometry(Arguments& arguments, MeshLoader& meshes);

// In curve_geometry.cpp:
/// hair, linearcurve and bsplinecurve.
std::optional<Geometry> make_curve_geometry(Arguments& arguments);

}  // namespace ajar::mitsuba
