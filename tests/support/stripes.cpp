#include "support/stripes.h"

#include "support/render.h"

namespace ajar::test {

namespace {
std::string material(const std::string& name, float reflectance) {
  const std::string r = std::to_string(reflectance);
  return "MakeNamedMaterial \"" + name + "\" \"string type\" \"matte\" \"rgb Kd\" [" + r + " " + r +
         " " + r + "]\n";
}
}  // namespace

std::unique_ptr<Scene> stripes(int width, int height, const std::string& lamp, float offset) {
  const float half_width = static_cast<float>(width) / 2.F;
  const float half_height = static_cast<float>(height) / 2.F;
  std::string world = lamp + material("bright", kBright) + material("dark", kDark);
  // Two more to the left, so that an offset leaves no gap.
  for (int column = -2; column < width + 2; ++column) {
    const float x = static_cast<float>(column) - half_width + offset;
    const std::string left = std::to_string(x);
    const std::string right = std::to_string(x + 1.F);
    const std::string y = std::to_string(half_height + 2.F);
    world += "NamedMaterial \"" + std::string(column % 2 == 0 ? "bright" : "dark") +
             "\"\nShape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3] \"point P\" [" + left +
             " -" + y + " 4 " + right + " -" + y + " 4 " + right + " " + y + " 4 " + left + " " +
             y + " 4]\n";
  }
  const std::string window = std::to_string(-half_width) + " " + std::to_string(half_width) + " " +
                             std::to_string(-half_height) + " " + std::to_string(half_height);
  return scene_from(pbrt_scene(
      "LookAt 0 0 0  0 0 1  0 1 0 Camera \"orthographic\" \"float screenwindow\" [" + window + "]",
      width, height, world));
}

}  // namespace ajar::test
