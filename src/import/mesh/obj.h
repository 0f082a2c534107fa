#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "scene/desc/shape_data.h"

/// Wavefront OBJ files: `v`, `vt`, `vn`, `f`, `usemtl` and `mtllib`; curves and smoothing groups
/// are skipped. Polygons become triangles (`polygon.h`); those of fewer than three corners are left
/// out. Texture coordinates stay as they are, v from the bottom row of an image, as textures have
/// it. Numbers are not judged: see `validate_mesh`. All raise SceneError, with line and column,
/// for what is no number, for faces that refer to what the file does not have before them, and if
/// there are no faces. Source: Wavefront, Advanced Visualizer manual, appendix B1.
namespace ajar {

/// All faces of all groups as one mesh. Corners with the same three indices become one vertex; a
/// corner without texture coordinates has (0, 0). Normals are kept if every corner has one.
desc::Mesh read_obj(std::string_view bytes, const std::string& name);

/// Reads one run of faces, counted from 0: `g` and `usemtl` begin another if there are faces before
/// them. Raises SceneError, too, if there are not so many.
desc::Mesh read_obj_run(std::string_view bytes, const std::string& name, std::uint32_t index);

/// All faces that have one material, and texture coordinates and normals, or not.
struct ObjPart {
  std::string material;  ///< empty if none is named
  SourceLocation where;  ///< place of its first face
  desc::Mesh mesh;
  /// Vertex colours, linear, if a vertex of the file has one; white where it has none. `v x y z r g
  /// b` has sRGB values, from 0 to 1, or from 0 to 255 if all of the file are whole numbers and one
  /// is above 1. Source: output of MeshLab and Blender; Wavefront's manual has no colours.
  std::vector<Vec3> colors;
};
/// Events while a file is read, with their places; none may be empty.
struct ObjEvents {
  using Event = std::function<void(const SourceLocation&, std::string_view)>;
  Event on_library;  ///< with the value of `mtllib`
  Event on_unread;   ///< with the first word of a line that is not read, the first time
  Event on_numbers;  ///< first vertex with numbers of unknown meaning; with these
};
/// In the order of their first faces.
std::vector<ObjPart> read_obj_parts(std::string_view bytes, const std::string& name,
                                    const ObjEvents& events);

}  // namespace ajar
