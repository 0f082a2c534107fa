#include "measuring/bench_scenes.h"

#include <algorithm>
#include <cmath>

#include "import/import.h"
#include "import/pbrt/pbrt_import.h"
#include "scene/desc/models.h"
#include "session/scenes/builtin_scenes.h"
#include "session/scenes/scene_file.h"
#include "support/shared.h"

namespace ajar::bench {

namespace {

/// A hilly grid of side × side cells, two triangles each, with smooth normals: sizes that no small
/// scene file has.
std::shared_ptr<const desc::Mesh> hills(int side) {
  auto mesh = std::make_shared<desc::Mesh>();
  const auto row = static_cast<unsigned>(side + 1);
  const auto height = [](float x, float z) {
    return 0.35F * std::sin(3.1F * x) * std::cos(2.3F * z) + 0.05F * std::sin(29.F * x + 17.F * z);
  };
  for (int j = 0; j <= side; ++j) {
    for (int i = 0; i <= side; ++i) {
      const float x = 8.F * static_cast<float>(i) / static_cast<float>(side) - 4.F;
      const float z = 8.F * static_cast<float>(j) / static_cast<float>(side) - 4.F;
      constexpr float kStep = 1e-3F;
      mesh->positions.emplace_back(x, height(x, z), z);
      mesh->normals.push_back(normalize({height(x - kStep, z) - height(x + kStep, z), 2.F * kStep,
                                         height(x, z - kStep) - height(x, z + kStep)}));
    }
  }
  for (unsigned j = 0; j + 1 < row; ++j) {
    for (unsigned i = 0; i + 1 < row; ++i) {
      const unsigned a = j * row + i;
      mesh->indices.emplace_back(a, a + row, a + 1);
      mesh->indices.emplace_back(a + 1, a + row, a + row + 1);
    }
  }
  return mesh;
}

desc::SceneDesc hills_scene(int side, Warnings& warnings) {
  desc::SceneDesc scene = import_pbrt_text(
      "LookAt 0 2.2 -5  0 0 0  0 1 0\nCamera \"perspective\" \"float fov\" [50]\nIntegrator "
      "\"path\" \"integer maxdepth\" [15]\n"
      "WorldBegin\nLightSource \"infinite\" \"rgb L\" [0.5 0.6 0.8]\n"
      "AttributeBegin AreaLightSource \"diffuse\" \"rgb L\" [60 50 40] Translate 1 4 0 Shape "
      "\"sphere\" \"float radius\" [0.3] AttributeEnd\n"
      "AttributeBegin Material \"glass\" Translate 0.6 0.9 -1 Shape \"sphere\" \"float radius\" "
      "[0.5] AttributeEnd\n"
      "AttributeBegin Material \"metal\" Translate -0.8 0.9 -0.6 Shape \"sphere\" \"float radius\" "
      "[0.5] AttributeEnd\n"
      "Material \"matte\" \"rgb Kd\" [0.6 0.55 0.5]\nWorldEnd\n",
      "hills.pbrt", ".", warnings);
  desc::Shape shape;
  shape.node = desc::mesh_node(hills(side));
  shape.material = static_cast<desc::MaterialId>(scene.materials.size()) - 1;
  scene.shapes.push_back(std::move(shape));
  return scene;
}

}  // namespace

std::vector<BenchScene> bench_scenes() {
  std::vector<BenchScene> scenes = {
      {"hills-0.5M", [](Warnings& warnings) { return hills_scene(500, warnings); }},
      {"hills-4M", [](Warnings& warnings) { return hills_scene(1414, warnings); }},
  };
  for (const std::string& name : builtin_scene_names()) {
    scenes.push_back(
        {name, [name](Warnings& warnings) { return load_scene("builtin:" + name, warnings); }});
  }
  if (const auto shared = test::shared_folder()) {
    for (const char* path :
         {"cornell-box/pbrt/scene.pbrt", "veach-mis/pbrt/scene.pbrt", "veach-bidir/pbrt/scene.pbrt",
          "staircase2/pbrt/scene.pbrt", "water-caustic/scene.pbrt", "teapot-full/scene.pbrt",
          "caustic-glass/glass.pbrt", "volume-caustic/caustic.pbrt"}) {
      const std::filesystem::path file = *shared / "scenes" / path;
      const std::string text = path;
      scenes.push_back({text.substr(0, text.find('/')), [file](Warnings& warnings) {
                          return import_scene(file.string(), warnings);
                        }});
    }
  }
  return scenes;
}

std::vector<BenchScene> choose_scenes(const std::vector<BenchScene>& scenes,
                                      const std::vector<std::string>& names) {
  std::vector<BenchScene> chosen;
  for (const std::string& name : names) {
    const auto found = std::find_if(scenes.begin(), scenes.end(), [&name](const BenchScene& scene) {
      return scene.name == name;
    });
    if (found != scenes.end()) {
      chosen.push_back(*found);
    } else if (std::filesystem::is_regular_file(name)) {
      chosen.push_back({std::filesystem::path(name).stem().string(),
                        [name](Warnings& warnings) { return import_scene(name, warnings); }});
    } else {
      std::vector<std::string> valid;
      valid.reserve(scenes.size());
      for (const BenchScene& scene : scenes) valid.push_back(scene.name);
      throw UsageError(unknown_name_message("scene", name, valid));
    }
  }
  return chosen;
}

Vec2i scaled_resolution(Vec2i resolution, double factor) {
  const auto scaled = [factor](int size) {
    return static_cast<int>(std::max(1.0, std::round(size * factor)));
  };
  return {scaled(resolution.x), scaled(resolution.y)};
}

Vec2i fitted_resolution(Vec2i resolution, int long_side) {
  return scaled_resolution(resolution,
                           static_cast<double>(long_side) / std::max(resolution.x, resolution.y));
}

}  // namespace ajar::bench
