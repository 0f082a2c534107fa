#include "import/pbrt/pbrt_writer.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "core/error.h"
#include "import/common/transforms.h"
#include "import/mesh/ply.h"
#include "import/pbrt/light_names.h"
#include "import/pbrt/mean_color.h"
#include "import/pbrt/own_words.h"
#include "import/pbrt/shape_names.h"
#include "import/pbrt/writer_context.h"
#include "import/pbrt/writer_curves.h"
#include "import/pbrt/writer_files.h"
#include "os/atomic_file.h"
#include "os/file_extension.h"
#include "scene/desc/models.h"

namespace ajar {
namespace {

using pbrt::TextWriter;
namespace fs = std::filesystem;

class Writer {
 public:
  Writer(const desc::SceneDesc& scene, const std::string& out_path)
      : context_(scene, out_path),
        scene_(scene),
        path_(context_.path),
        meshes_(path_, "meshes"),
        out_(context_.out) {}

  /// Writes the scene; returns the message on names that pbrt does not know.
  std::string run() {
    write_options();
    out_.line("WorldBegin");
    context_.medium_outside(scene_.camera.medium);
    pbrt::write_textures(context_);
    pbrt::write_materials(context_);
    pbrt::write_lights(context_);
    for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
      out_.line("ObjectBegin").quoted(context_.object_names[i]);
      for (const desc::Shape& shape : scene_.objects[i].shapes) write_shape(shape);
      out_.line("ObjectEnd");
    }
    for (const desc::Instance& instance : scene_.instances) {
      out_.line("TransformBegin").line("Transform").matrix(instance.to_world);
      out_.line("ObjectInstance")
          .quoted(context_.object_names.at(static_cast<std::size_t>(instance.object)));
      out_.line("TransformEnd");
    }
    for (const desc::Shape& shape : scene_.shapes) write_shape(shape);
    out_.line("WorldEnd").line("");
    write_file_atomically(path_, out_.text());
    return context_.unknown_to_pbrt();
  }

 private:
  // -------------------------------------------------------------- options

  void write_options() {
    write_integrator();
    const desc::RenderHints& hints = scene_.hints;
    if (hints.samples_per_pixel || hints.sampler) {
      out_.line("Sampler").quoted(hints.sampler == "independent" ? "random" : "sobol");
      out_.parameter("integer pixelsamples", hints.samples_per_pixel.value_or(16));
    }
    write_filter();
    const desc::Film& film = scene_.film;
    out_.line("Film").quoted("image");
    out_.parameter("integer xresolution", film.resolution.x)
        .parameter("integer yresolution", film.resolution.y);
    out_.parameter("float cropwindow", film.crop[0], film.crop[1], film.crop[2], film.crop[3]);
    out_.parameter("float scale", film.scale);
    if (!film.filename.empty()) out_.parameter("string filename", picture_name(film.filename));
    write_camera();
    for (std::size_t i = 0; i < scene_.media.size(); ++i) write_medium(i);
  }

  /// With a suffix that pbrt-v3 writes.
  static std::string picture_name(const std::string& name) {
    const std::string extension = file_extension(name);
    for (const char* known : {".exr", ".png", ".tga", ".pfm"}) {
      if (extension == known) return name;
    }
    return fs::path(name).replace_extension(".exr").string();
  }

  void write_medium(std::size_t i) {
    const desc::Medium& medium = scene_.media[i];
    if (medium.density) out_.line("Transform").matrix(medium.density->to_world);
    const bool is_colored = medium.density && medium.density->grid->is_colored();
    out_.line("MakeNamedMedium")
        .quoted(context_.medium_names[i])
        .parameter("string type", is_colored       ? "rgbgrid"
                                  : medium.density ? "heterogeneous"
                                                   : "homogeneous")
        .parameter("float g", medium.g);
    if (is_colored) {
      ++context_.unknown_models["rgbgrid"];
      write_colors(medium);
      return;
    }
    out_.rgb("sigma_a", medium.sigma_a).rgb("sigma_s", medium.sigma_s);
    if (!medium.density) return;
    const desc::DensityGrid& grid = *medium.density->grid;
    const int more = write_box(grid, is_clamped(grid));
    write_points(grid, more, "float density",
                 [&](std::size_t point, bool) { out_.number(grid.values[point]); });
  }

  /// Writes media like pbrt-v4. A coefficient that does not vary is 1 there, which leaves `scale`;
  /// coloured ones become a grid.
  void write_colors(const desc::Medium& medium) {
    const desc::DensityGrid& grid = *medium.density->grid;
    const desc::Rgb* constant = grid.absorption.empty()   ? &medium.sigma_a
                                : grid.scattering.empty() ? &medium.sigma_s
                                                          : nullptr;
    const bool is_scale =
        constant != nullptr && constant->x > 0.F && *constant == desc::Rgb(constant->x);
    const float scale = is_scale ? constant->x : 1.F;
    const int more = write_box(grid, is_clamped(grid) || (constant != nullptr && !is_scale));
    if (is_scale) out_.parameter("float scale", scale);
    const auto write = [&](const char* name, const desc::Rgb& sigma,
                           const std::vector<desc::Rgb>& factors) {
      if (factors.empty() && is_scale) return;
      write_points(grid, more, name, [&](std::size_t point, bool is_beyond) {
        desc::Rgb value = sigma / scale;
        if (!factors.empty()) {
          value *= is_beyond && !is_clamped(grid) ? desc::Rgb(0.F) : factors[point];
        }
        for (int lane = 0; lane < 3; ++lane) out_.number(value[lane]);
      });
    };
    write("rgb sigma_a", medium.sigma_a, grid.absorption);
    write("rgb sigma_s", medium.sigma_s, grid.scattering);
  }

  static bool is_clamped(const desc::DensityGrid& grid) {
    return grid.border == desc::DensityGrid::Border::Clamp;
  }

  /// pbrt has values at the middles of cells, and 0 beyond them. Other grids are embedded in a
  /// larger one; beyond their box pbrt has some of the medium, too, unless a surface bounds it, as
  /// those formats require. Our words have the exact bounds. Returns how many points are added at
  /// each side, which is 1 if points in the middle of cells extend to the faces.
  int write_box(const desc::DensityGrid& grid, bool goes_on) {
    const bool at_corners = grid.points == desc::DensityGrid::Points::Corners;
    const bool is_extended = !at_corners && goes_on;
    const int more = is_extended ? 1 : 0;
    const desc::Vec3i& n = grid.resolution;
    out_.parameter("integer nx", n.x + 2 * more)
        .parameter("integer ny", n.y + 2 * more)
        .parameter("integer nz", n.z + 2 * more);
    if (at_corners || is_extended) {
      // Half a cell, of a grid of corners or of centres, or a whole one.
      const Vec3 beyond = at_corners ? Vec3(0.5F) / Vec3(n - desc::Vec3i(1)) : Vec3(1.F) / Vec3(n);
      out_.point("p0", Vec3(0.F) - beyond).point("p1", Vec3(1.F) + beyond);
      out_.parameter("string " + pbrt::own_word("points"), at_corners ? "corners" : "centers")
          .parameter("string " + pbrt::own_word("border"), is_clamped(grid) ? "clamp" : "zero")
          .parameter("integer " + pbrt::own_word("beyond"), more);
      ++context_.unknown_parameters["ends of grids in larger shapes"];
    }
    return more;
  }

  /// `write(point, is_beyond)` of all points, with the nearest one of those that are added.
  template <typename Write>
  void write_points(const desc::DensityGrid& grid, int more, const char* declaration,
                    const Write& write) {
    const desc::Vec3i& n = grid.resolution;
    out_.quoted(declaration).line("  [");
    for (int z = -more; z < n.z + more; ++z) {
      for (int y = -more; y < n.y + more; ++y) {
        for (int x = -more; x < n.x + more; ++x) {
          const desc::Vec3i point(x, y, z);
          std::size_t index = 0;
          bool is_beyond = false;
          for (int axis = 2; axis >= 0; --axis) {
            const int near = std::clamp(point[axis], 0, n[axis] - 1);
            is_beyond = is_beyond || near != point[axis];
            index = index * static_cast<std::size_t>(n[axis]) + static_cast<std::size_t>(near);
          }
          write(index, is_beyond);
        }
      }
    }
    out_.line("  ]");
  }

  void write_integrator() {
    const desc::RenderHints& hints = scene_.hints;
    static const std::map<std::string, std::string> kNames = {
        {"", "path"}, {"pt", "path"}, {"bdpt", "bdpt"}, {"mmlt", "mlt"}, {"sppm", "sppm"}};
    const auto name = kNames.find(hints.integrator);
    const bool has_media =
        !scene_.media.empty() && (name == kNames.end() || name->second == "path");
    out_.line("Integrator")
        .quoted(has_media              ? "volpath"
                : name == kNames.end() ? "path"
                                       : name->second);
    // Always: readers of the format stop after few bounces where a file says nothing.
    out_.parameter("integer maxdepth",
                   hints.max_depth.value_or(desc::RenderHints::kDefaultMaxDepth) - 1);
    if (name == kNames.end()) return;
    if (name->second == "sppm" && hints.samples_per_pixel) {
      out_.parameter("integer iterations", *hints.samples_per_pixel);
    }
    for (const auto& [parameter, value] : hints.parameters) {
      const bool is_float =
          parameter == "largestepprobability" || parameter == "sigma" || parameter == "radius";
      out_.quoted((is_float ? "float " : "integer ") + parameter).line("  " + value);
    }
  }

  void write_filter() {
    const desc::Filter& filter = scene_.film.filter;
    static constexpr const char* kNames[] = {"box", "triangle", "gaussian", "mitchell", "sinc"};
    out_.line("PixelFilter").quoted(kNames[filter.node.index()]);
    out_.parameter("float xwidth", filter.radius.x).parameter("float ywidth", filter.radius.y);
    if (const auto* gaussian = std::get_if<desc::GaussianFilter>(&filter.node))
      out_.parameter("float alpha", gaussian->falloff);
    if (const auto* mitchell = std::get_if<desc::MitchellFilter>(&filter.node)) {
      out_.parameter("float B", mitchell->b).parameter("float C", mitchell->c);
    }
    if (const auto* sinc = std::get_if<desc::SincFilter>(&filter.node))
      out_.parameter("float tau", sinc->lobes);
  }

  template <typename Camera>
  void write_lens(const Camera& camera) {
    out_.parameter("float lensradius", camera.lens_radius)
        .parameter("float focaldistance", camera.focal_distance);
    if (camera.aspect) out_.parameter("float frameaspectratio", *camera.aspect);
    if (camera.window) {
      const desc::ScreenWindow& w = *camera.window;
      out_.parameter("float screenwindow", w.x_min, w.x_max, w.y_min, w.y_max);
    }
  }

  void write_camera() {
    const desc::Camera& camera = scene_.camera;
    const std::optional<Mat4> from_world = inverse(camera.to_world);
    if (!from_world) {
      throw SceneError(camera.where, "the transform of the camera cannot be inverted");
    }
    out_.line("Transform").matrix(*from_world);
    if (const auto* perspective = std::get_if<desc::PerspectiveCamera>(&camera.node)) {
      out_.line("Camera").quoted("perspective").parameter("float fov", perspective->fov);
      write_lens(*perspective);
    } else if (const auto* orthographic = std::get_if<desc::OrthographicCamera>(&camera.node)) {
      out_.line("Camera").quoted("orthographic");
      write_lens(*orthographic);
    } else {
      out_.line("Camera").quoted("environment");
    }
    if (camera.hides_lights) out_.flag("hides_lights", true);
  }

  // -------------------------------------------------------------- shapes

  void write_shape(const desc::Shape& shape) {
    out_.line("AttributeBegin").line("Transform").matrix(shape.to_world);
    if (shape.reverse_orientation) out_.line("ReverseOrientation");
    if (shape.material >= 0)
      out_.line("NamedMaterial")
          .quoted(context_.material_names.at(static_cast<std::size_t>(shape.material)));
    if (shape.emission) write_emission(shape.emission->node);
    if (!scene_.media.empty()) {
      const desc::MediumId inside = shape.has_medium_interface ? shape.inside : desc::kNone;
      const desc::MediumId outside = shape.has_medium_interface ? shape.outside : desc::kNone;
      out_.line("MediumInterface")
          .quoted(context_.medium_name(inside))
          .quoted(context_.medium_name(outside));
    }
    write_geometry(shape);
    out_.line("AttributeEnd");
  }

  void write_emission(const desc::Node& node) {
    const ModelName* names = find_ours(pbrt::emission_names(), node.model().name);
    out_.line("AreaLightSource").quoted(names == nullptr ? node.model().name : names->theirs);
    pbrt::Substitutes substitutes;
    if (const auto* texture = std::get_if<desc::TextureRef>(&node.get("radiance"))) {
      substitutes["radiance"] = pbrt::mean_color(scene_, context_.images, texture->id);
      ++context_.unknown_parameters["textures of lamps"];
    }
    write_parameters(context_, node, names, false, substitutes);
  }

  TextWriter& begin_shape(const desc::Shape& shape, std::string_view shape_type) {
    out_.line("Shape").quoted(shape_type);
    context_.reference("alpha", shape.alpha);
    context_.reference("shadowalpha", shape.shadow_alpha);
    if (shape.alpha_counted) out_.flag("alpha_counted", true);
    return out_;
  }

  void write_geometry(const desc::Shape& shape) {
    const desc::Node& node = shape.node;
    if (node.is("mesh")) return write_mesh(shape, node.mesh("mesh"));
    if (node.is("subdivision")) return write_subdivision(shape);
    if (node.is("curves")) return write_curves(shape);
    const ModelName* names = find_ours(pbrt::shape_names(), node.model().name);
    begin_shape(shape, names == nullptr ? node.model().name : names->theirs);
    write_parameters(context_, node, names);
  }

  void write_mesh(const desc::Shape& shape, const desc::MeshPointer& mesh) {
    if (mesh->tangents.empty()) {
      begin_shape(shape, "plymesh").parameter("string filename", mesh_file(mesh));
      return;
    }
    // PLY has no place for tangents.
    begin_shape(shape, "trianglemesh")
        .vectors("integer indices", mesh->indices)
        .vectors("point P", mesh->positions);
    out_.vectors("vector S", mesh->tangents);
    if (!mesh->handedness.empty()) {
      out_.integers("integer " + pbrt::own_word("handedness"), mesh->handedness);
      ++context_.unknown_parameters["handedness"];
    }
    if (!mesh->normals.empty()) out_.vectors("normal N", mesh->normals);
    if (!mesh->uvs.empty()) out_.vectors("float uv", mesh->uvs);
  }

  std::string mesh_file(const desc::MeshPointer& mesh) {
    const auto known = mesh_files_.find(mesh.get());
    if (known != mesh_files_.end()) return known->second;
    const fs::path file = meshes_.write("mesh", write_ply(*mesh), ".ply");
    return mesh_files_[mesh.get()] = file.lexically_relative(path_.parent_path()).generic_string();
  }

  void write_subdivision(const desc::Shape& shape) {
    const desc::Mesh& control = *shape.node.mesh("control");
    begin_shape(shape, "loopsubdiv").parameter("integer levels", shape.node.integer("levels"));
    out_.vectors("integer indices", control.indices).vectors("point P", control.positions);
  }
  void write_curves(const desc::Shape& shape) {
    for (const pbrt::CurveChain& chain : pbrt::curve_chains(*shape.node.curves("curves"))) {
      begin_shape(shape, "curve").parameter("string type", shape.node.text("type"));
      out_.parameter("float width0", chain.width0).parameter("float width1", chain.width1);
      out_.vectors("point P", chain.points);
      if (!chain.normals.empty()) out_.vectors("normal N", chain.normals);
    }
  }

  pbrt::WriterContext context_;
  const desc::SceneDesc& scene_;
  const fs::path& path_;
  pbrt::WriterFiles meshes_;
  TextWriter& out_;
  std::map<const desc::Mesh*, std::string> mesh_files_;
};

}  // namespace

std::string write_pbrt(const desc::SceneDesc& scene, const std::string& out_path) {
  return Writer(scene, out_path).run();
}

}  // namespace ajar
