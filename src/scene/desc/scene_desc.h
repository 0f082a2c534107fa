#pragma once
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "core/error.h"
#include "core/vector.h"
#include "core/warnings.h"
#include "scene/desc/density_grid.h"
#include "scene/desc/node.h"
#include "scene/desc/shape_data.h"

/// A scene description, independent of file format and renderer. Importers make it, `Scene` is
/// built from it. Every node knows where in a file it came from. Colours are linear Rec. 709 RGB;
/// lengths are scene units; angles are degrees.
namespace ajar::desc {

// ---------------------------------------------------------------- textures, materials

struct Texture {
  std::string name;
  SourceLocation where;
  Node node;  ///< refers only to textures with a smaller id
};

/// Shading normals by a texture: its colour c encodes 2c − 1 along dp/du, across it and along the
/// normal.
struct NormalMap {
  TextureId texture = kNone;
  float strength = 1;  ///< multiplies the first two lanes of 2c − 1
  bool right_handed =
      false;  ///< across is the normal × dp/du, even where dp/dv is on the other side
};

struct Material {
  std::string name;
  SourceLocation where;
  TextureId bump = kNone;  ///< displacement along the normal, scene units
  NormalMap normal_map{};  ///< ignored beside a bump
  Node node{};             ///< refers only to materials with a smaller id

  bool has_relief() const { return bump != kNone || normal_map.texture != kNone; }
};

// ---------------------------------------------------------------- media

/// Absorption and scattering coefficients in 1/(scene unit), Henyey–Greenstein g. Homogeneous, or
/// with coefficients times a density or colours from place to place.
struct Medium {
  std::string name;
  SourceLocation where;
  Rgb sigma_a{0, 0, 0}, sigma_s{0, 0, 0};
  float g = 0;
  std::optional<Density> density{};
};

// ---------------------------------------------------------------- shapes

/// Light that leaves a surface.
struct Emission {
  SourceLocation where;
  Node node;
};

struct Shape {
  SourceLocation where;
  std::string name;  ///< name of the object, for ids and messages; may be empty
  Node node;         ///< in a space of its own
  Mat4 to_world;
  bool reverse_orientation = false;
  MaterialId material = kNone;
  TextureId alpha = kNone;         ///< surface is cut away where this is 0
  TextureId shadow_alpha = kNone;  ///< alpha for shadow rays only
  bool alpha_counted = false;      ///< where it is cut away, it adds an edge to paths
  std::optional<Emission> emission;
  MediumId inside = kNone, outside = kNone;
  bool has_medium_interface = false;  ///< false: the shape does not change the medium of a ray
};

/// A group of shapes that is placed by instances.
struct Object {
  std::string name;
  SourceLocation where;
  std::vector<Shape> shapes;
};
struct Instance {
  ObjectId object = kNone;
  Mat4 to_world;
  SourceLocation where;
};

// ---------------------------------------------------------------- lights

/// Light that comes from no surface.
struct Light {
  SourceLocation where;
  Mat4 to_world;
  Node node;
  MediumId medium = kNone;  ///< the medium that a light at a point is in
};

// ---------------------------------------------------------------- camera, film

/// The part of the camera's plane that the image shows: in units of tan(fov/2) at z = 1
/// (perspective) or of camera space (orthographic). Without one the shorter side of the image spans
/// [-1, 1].
struct ScreenWindow {
  float x_min = -1, x_max = 1, y_min = -1, y_max = 1;
};
struct PerspectiveCamera {
  float fov = 90;
  float lens_radius = 0, focal_distance = 1e6F;
  std::optional<ScreenWindow> window;
  std::optional<float> aspect;
};
struct OrthographicCamera {
  float lens_radius = 0, focal_distance = 1e6F;
  std::optional<ScreenWindow> window;
  std::optional<float> aspect;
};
struct EnvironmentCamera {};
struct Camera {
  SourceLocation where;
  Mat4 to_world;  ///< camera looks along +z, +y is up, +x right (left-handed)
  std::variant<PerspectiveCamera, OrthographicCamera, EnvironmentCamera> node;
  MediumId medium = kNone;
  /// Looks past lights at the background; they shine all the same.
  bool hides_lights = false;
};

struct BoxFilter {};
struct TriangleFilter {};
struct GaussianFilter {
  float falloff = 2;  ///< exp(−falloff · x²), 1/pixel²
};
struct MitchellFilter {
  float b = 1.F / 3, c = 1.F / 3;
};
struct SincFilter {
  float lobes = 3;  ///< on each side of the Lanczos window: sinc(x) · sinc(x / lobes)
};
struct Filter {
  Vec2 radius{0.5F, 0.5F};  ///< pixels
  std::variant<BoxFilter, TriangleFilter, GaussianFilter, MitchellFilter, SincFilter> node;
  SourceLocation where{};
};

struct Film {
  SourceLocation where;
  Vec2i resolution{1280, 720};
  /// The part that is rendered, in fractions of the image: x_min, x_max, y_min, y_max.
  float crop[4] = {0, 1, 0, 1};
  Filter filter;
  float scale = 1;  ///< multiplies every pixel
  std::string filename;
};

/// Render settings in the file; the command line overrides them.
struct RenderHints {
  /// Where neither a scene nor a user says one.
  static constexpr int kDefaultMaxDepth = 100;

  std::string integrator;        ///< by its name in the registry; empty if the file says nothing
  std::optional<int> max_depth;  ///< edges of a path (docs/methods/notation.md)
  std::optional<int> samples_per_pixel;
  std::optional<std::string> sampler;  ///< value for the parameter `sampler` of integrators
  std::vector<std::pair<std::string, std::string>> parameters;  ///< for `integrator`
};

/// Contents of files that are inside of others, by the names that nodes have for them.
using EmbeddedFiles = std::map<std::string, std::shared_ptr<const std::string>>;

/// A warning of something that only matters where the camera sees it: `Scene` looks whether it
/// does.
struct WarningIfSeen {
  enum class If { FromBehind, Nearer, Farther };
  If condition;
  MaterialId material = kNone;  ///< material that is seen from behind; kNone: any
  float depth = 0.F;            ///< nearer or farther than which it is, along the camera's axis
  Warning warning;
};

struct SceneDesc {
  std::string source;           ///< the file it came from
  std::set<std::string> files;  ///< on the disk that it names, itself too; nothing may replace them
  EmbeddedFiles embedded_files;
  std::vector<Texture> textures;
  std::vector<Material> materials;
  std::vector<Medium> media;
  std::vector<Shape> shapes;
  std::vector<Object> objects;
  std::vector<Instance> instances;
  std::vector<Light> lights;
  Camera camera;
  Film film;
  RenderHints hints;
  std::vector<WarningIfSeen> warnings_if_seen;
};

/// Hash of everything that decides the picture (not of names, hints or locations): the same scene
/// described twice has the same hash. Contents of image files count by path.
std::uint64_t hash(const SceneDesc& scene);

}  // namespace ajar::desc
