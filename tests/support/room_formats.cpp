#include "support/room_formats.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "color/srgb.h"
#include "core/vector.h"
#include "imageio/image_encoder.h"
#include "os/regular_file.h"

namespace ajar::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Seen from the front its corners go around counterclockwise from the lower left.
struct Wall {
  std::array<Vec3, 4> corners;
  Vec3 color{0.F};
  bool has_image = false;
  Vec3 emission{0.F};
};

const std::vector<Wall>& walls() {
  static const std::vector<Wall> kWalls = {
      {{Vec3(-1, 0, 1), Vec3(1, 0, 1), Vec3(1, 0, -1), Vec3(-1, 0, -1)}, Vec3(0.7F)},
      {{Vec3(-1, 0, -1), Vec3(1, 0, -1), Vec3(1, 2, -1), Vec3(-1, 2, -1)}, Vec3(1.F), true},
      {{Vec3(-1, 0, 1), Vec3(-1, 0, -1), Vec3(-1, 2, -1), Vec3(-1, 2, 1)}, {0.6F, 0.1F, 0.1F}},
      {{Vec3(1, 0, -1), Vec3(1, 0, 1), Vec3(1, 2, 1), Vec3(1, 2, -1)}, {0.1F, 0.5F, 0.1F}},
      {{Vec3(-0.4F, 1.9F, -0.4F), Vec3(0.4F, 1.9F, -0.4F), Vec3(0.4F, 1.9F, 0.4F),
        Vec3(-0.4F, 1.9F, 0.4F)},
       Vec3(0.F),
       false,
       {10, 8, 6}}};
  return kWalls;
}

constexpr const char* kImage = "colors.pfm";
constexpr double kFov = 45.0;  ///< degrees, of the height
const Vec3 kLampAt(0.3F, 0.6F, 0.7F);
constexpr double kIntensity = 0.5;  ///< W/sr
constexpr double kRoughness = 0.5;

/// Field of view across the width, degrees.
double fov_of_width() {
  return 2.0 * std::atan(std::tan(kFov * M_PI / 360.0) * 4.0 / 3.0) * 180.0 / M_PI;
}

std::string write(const fs::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
  return path.string();
}

/// Four colours, none like another: the lowest row first.
constexpr std::array<float, 12> kTexels = {0.2F, 0.2F, 0.8F, 0.8F, 0.8F, 0.7F,
                                           0.8F, 0.3F, 0.2F, 0.2F, 0.7F, 0.3F};

void write_image(const fs::path& folder) {
  write(folder / kImage,
        "PF\n2 2\n-1.0\n" +
            std::string(reinterpret_cast<const char*>(kTexels.data()), sizeof(kTexels)));
}

/// Each texel over whole blocks of pixels, so that no color bleeds into another.
std::string jpeg_image() {
  constexpr int kSize = 64;
  ImageLayout layout;
  layout.width = kSize;
  layout.height = kSize;
  layout.names = {"R", "G", "B"};
  const std::vector<unsigned char> bytes = encode_jpeg(layout, [](int y, unsigned char* row) {
    for (int x = 0; x < kSize; ++x) {
      for (int c = 0; c < 3; ++c) {
        const int texel = (y < kSize / 2 ? 2 : 0) + (x < kSize / 2 ? 0 : 1);
        const float value = kTexels[static_cast<std::size_t>(3 * texel + c)];
        row[3 * x + c] = static_cast<unsigned char>(std::lround(255.F * srgb_from_linear(value)));
      }
    }
  });
  return {bytes.begin(), bytes.end()};
}

std::string numbers(const Vec3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }
std::string list(const Vec3& v) { return fmt::format("{}, {}, {}", v.x, v.y, v.z); }

bool is_lamp(const Wall& wall) { return wall.emission != Vec3(0.F); }

/// A file per wall, "wall0.obj" and so on.
void write_objs(const fs::path& folder) {
  for (std::size_t i = 0; i < walls().size(); ++i) {
    std::string text;
    for (const Vec3& corner : walls()[i].corners) text += "v " + numbers(corner) + "\n";
    text += "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";
    write(folder / fmt::format("wall{}.obj", i), text);
  }
}

std::string corners_of(const Wall& wall) {
  std::string text;
  for (const Vec3& corner : wall.corners) text += numbers(corner) + " ";
  return text;
}

std::string pbrt_camera() {
  // Its cameras are left-handed: without it x would go to the left.
  return fmt::format(
      "Scale -1 1 1\nLookAt 0 1 3.5  0 1 0  0 1 0\nCamera \"perspective\" \"float fov\" {}\n",
      kFov);
}

}  // namespace

std::string write_pbrt3_room(const fs::path& folder, RoomSurface surface) {
  write_image(folder);
  const bool is_diffuse = surface == RoomSurface::Diffuse;
  std::string text = pbrt_camera() +
                     "WorldBegin\nTexture \"image\" \"spectrum\" \"imagemap\" "
                     "\"string filename\" \"" +
                     kImage + "\"\n";
  for (const Wall& wall : walls()) {
    text += "AttributeBegin\nMaterial ";
    text += is_diffuse
                ? "\"matte\" "
                : fmt::format("\"disney\" \"float roughness\" {} \"float eta\" 1 ", kRoughness);
    const std::string name = is_diffuse ? "Kd" : "color";
    text += wall.has_image ? "\"texture " + name + "\" \"image\"\n"
                           : "\"rgb " + name + "\" [" + numbers(wall.color) + "]\n";
    if (is_lamp(wall)) {
      text += "AreaLightSource \"diffuse\" \"rgb L\" [" + numbers(wall.emission) + "]\n";
    }
    text += "Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3] \"point P\" [" +
            corners_of(wall) + "] \"float uv\" [0 0 1 0 1 1 0 1]\nAttributeEnd\n";
  }
  text += fmt::format("LightSource \"point\" \"rgb I\" [{0} {0} {0}] \"point from\" [{1}]\n",
                      kIntensity, numbers(kLampAt));
  return write(folder / "room.pbrt", text + "WorldEnd\n");
}

std::string write_pbrt4_room(const fs::path& folder) {
  write_image(folder);
  std::string text = "Film \"rgb\"\n" + pbrt_camera() +
                     "WorldBegin\nTexture \"image\" \"spectrum\" \"imagemap\" \"string filename\" "
                     "\"" +
                     kImage + "\"\n";
  for (const Wall& wall : walls()) {
    text += "AttributeBegin\nMaterial \"diffuse\" ";
    text += wall.has_image ? "\"texture reflectance\" \"image\"\n"
                           : "\"rgb reflectance\" [" + numbers(wall.color) + "]\n";
    if (is_lamp(wall)) {
      text += "AreaLightSource \"diffuse\" \"rgb L\" [" + numbers(wall.emission) + "]\n";
    }
    text += "Shape \"trianglemesh\" \"integer indices\" [0 1 2 0 2 3] \"point3 P\" [" +
            corners_of(wall) + "] \"point2 uv\" [0 0 1 0 1 1 0 1]\nAttributeEnd\n";
  }
  text += fmt::format("LightSource \"point\" \"rgb I\" [{0} {0} {0}] \"point3 from\" [{1}]\n",
                      kIntensity, numbers(kLampAt));
  return write(folder / "room4.pbrt", text);
}

std::string write_mitsuba_room(const fs::path& folder, const std::string& version,
                               RoomSurface surface) {
  write_image(folder);
  write_objs(folder);
  const bool is_old = version.starts_with("0");
  const bool is_diffuse = surface == RoomSurface::Diffuse;
  const auto name = [&](const char* old, const char* now) { return is_old ? old : now; };
  std::string text = fmt::format(
      "<scene version=\"{}\"><sensor type=\"perspective\"><float name=\"fov\" value=\"{}\"/>"
      "<transform name=\"{}\"><lookat origin=\"0, 1, 3.5\" target=\"0, 1, 0\" up=\"0, 1, 0\"/>"
      "</transform><film type=\"hdrfilm\"><integer name=\"width\" value=\"96\"/><integer "
      "name=\"height\" value=\"72\"/></film></sensor>",
      version, fov_of_width(), name("toWorld", "to_world"));
  for (std::size_t i = 0; i < walls().size(); ++i) {
    const Wall& wall = walls()[i];
    text += fmt::format(
        "<shape type=\"obj\"><string name=\"filename\" value=\"wall{}.obj\"/><boolean name=\"{}\" "
        "value=\"true\"/>",
        i, name("faceNormals", "face_normals"));
    const std::string color = is_diffuse ? "reflectance" : "base_color";
    const std::string value =
        wall.has_image ? fmt::format(
                             "<texture name=\"{}\" type=\"bitmap\"><string name=\"filename\" "
                             "value=\"{}\"/></texture>",
                             color, kImage)
                       : fmt::format("<rgb name=\"{}\" value=\"{}\"/>", color, list(wall.color));
    text += is_diffuse
                ? "<bsdf type=\"twosided\"><bsdf type=\"diffuse\">" + value + "</bsdf></bsdf>"
                : fmt::format(
                      "<bsdf type=\"twosided\"><bsdf type=\"principled\"><float "
                      "name=\"roughness\" value=\"{}\"/><float name=\"specular\" "
                      "value=\"0\"/>{}</bsdf></bsdf>",
                      kRoughness, value);
    if (is_lamp(wall)) {
      text += "<emitter type=\"area\"><rgb name=\"radiance\" value=\"" + list(wall.emission) +
              "\"/></emitter>";
    }
    text += "</shape>";
  }
  text += fmt::format(
      "<emitter type=\"point\"><point name=\"position\" x=\"{}\" y=\"{}\" z=\"{}\"/><rgb "
      "name=\"intensity\" value=\"{}\"/></emitter></scene>",
      kLampAt.x, kLampAt.y, kLampAt.z, kIntensity);
  return write(folder / ("room" + version + ".xml"), text);
}

std::string write_tungsten_room(const fs::path& folder) {
  write_image(folder);
  write_objs(folder);
  const auto array = [](const Vec3& v) { return Json{v.x, v.y, v.z}; };
  Json scene;
  scene["camera"] = {
      {"type", "pinhole"},
      {"fov", fov_of_width()},
      {"resolution", {96, 72}},
      {"transform", {{"position", {0, 1, 3.5}}, {"look_at", {0, 1, 0}}, {"up", {0, 1, 0}}}}};
  for (std::size_t i = 0; i < walls().size(); ++i) {
    const Wall& wall = walls()[i];
    Json primitive = {
        {"type", "mesh"},
        {"file", fmt::format("wall{}.obj", i)},
        {"smooth", false},
        {"bsdf",
         {{"type", "lambert"}, {"albedo", wall.has_image ? Json(kImage) : array(wall.color)}}}};
    if (is_lamp(wall)) primitive["emission"] = array(wall.emission);
    scene["primitives"].push_back(primitive);
  }
  scene["primitives"].push_back({{"type", "point"},
                                 {"power", 4.0 * M_PI * kIntensity},
                                 {"transform", {{"position", array(kLampAt)}}}});
  return write(folder / "room.json", scene.dump());
}

std::string write_gltf_room(const fs::path& folder) {
  write_image(folder);
  const auto array = [](const Vec3& v) { return Json{v.x, v.y, v.z}; };
  std::string bytes;
  const auto append = [&bytes](const auto& values) {
    bytes.append(reinterpret_cast<const char*>(values.data()), sizeof(values));
  };
  // v counts from the top row of an image.
  append(std::array<float, 8>{0, 1, 1, 1, 1, 0, 0, 0});
  append(std::array<std::uint16_t, 6>{0, 1, 2, 0, 2, 3});
  bytes.resize(44);
  for (const Wall& wall : walls()) append(wall.corners);

  constexpr int kFloat = 5126;
  constexpr int kShort = 5123;
  Json scene = {
      {"asset", {{"version", "2.0"}}},
      {"scene", 0},
      {"extensionsUsed",
       {"KHR_lights_punctual", "KHR_materials_specular", "KHR_materials_emissive_strength"}},
      {"images", Json::array({{{"uri", kImage}}})},
      {"textures", Json::array({{{"source", 0}}})},
      {"buffers", Json::array({{{"uri", "room.bin"}, {"byteLength", bytes.size()}}})},
      {"bufferViews",
       {{{"buffer", 0}, {"byteOffset", 0}, {"byteLength", 32}},
        {{"buffer", 0}, {"byteOffset", 32}, {"byteLength", 12}}}},
      {"accessors",
       {{{"bufferView", 0}, {"componentType", kFloat}, {"count", 4}, {"type", "VEC2"}},
        {{"bufferView", 1}, {"componentType", kShort}, {"count", 6}, {"type", "SCALAR"}}}},
      {"cameras",
       Json::array({{{"type", "perspective"},
                     {"perspective", {{"yfov", kFov * M_PI / 180.0}, {"znear", 0.1}}}}})},
      {"extensions",
       {{"KHR_lights_punctual",
         {{"lights", Json::array({{{"type", "point"}, {"intensity", kIntensity}}})}}}}},
      {"nodes",
       {{{"camera", 0}, {"translation", {0, 1, 3.5}}},
        {{"translation", array(kLampAt)},
         {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}}}}};
  for (std::size_t i = 0; i < walls().size(); ++i) {
    const Wall& wall = walls()[i];
    scene["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", 44 + 48 * i}, {"byteLength", 48}});
    scene["accessors"].push_back(
        {{"bufferView", 2 + i}, {"componentType", kFloat}, {"count", 4}, {"type", "VEC3"}});
    Json pbr = {{"metallicFactor", 0}, {"roughnessFactor", kRoughness}};
    if (wall.has_image) {
      pbr["baseColorTexture"] = {{"index", 0}};
    } else {
      pbr["baseColorFactor"] = {wall.color.x, wall.color.y, wall.color.z, 1};
    }
    Json material = {{"pbrMetallicRoughness", pbr},
                     {"extensions", {{"KHR_materials_specular", {{"specularFactor", 0}}}}}};
    if (is_lamp(wall)) {
      material["emissiveFactor"] = array(wall.emission / 10.F);
      material["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", 10}};
    }
    scene["materials"].push_back(material);
    const Json primitive = {
        {"attributes", {{"POSITION", 2 + i}, {"TEXCOORD_0", 0}}}, {"indices", 1}, {"material", i}};
    scene["meshes"].push_back({{"primitives", Json::array({primitive})}});
    scene["nodes"].push_back({{"mesh", i}});
  }
  for (std::size_t i = 0; i < scene["nodes"].size(); ++i) {
    scene["scenes"][0]["nodes"].push_back(i);
  }
  write(folder / "room.bin", bytes);
  return write(folder / "room.gltf", scene.dump());
}

std::string write_glb_room(const fs::path& folder) {
  Json scene = Json::parse(read_file(write_gltf_room(folder)).view());
  std::string binary(read_file((folder / "room.bin").string()).view());
  const std::string image = jpeg_image();
  scene["bufferViews"].push_back(
      {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", image.size()}});
  scene["images"][0] = {{"bufferView", scene["bufferViews"].size() - 1},
                        {"mimeType", "image/jpeg"}};
  binary += image;
  scene["buffers"][0] = {{"byteLength", binary.size()}};
  const auto number = [](std::size_t value) {
    const auto bits = static_cast<std::uint32_t>(value);
    return std::string(reinterpret_cast<const char*>(&bits), sizeof(bits));
  };
  const auto chunk = [&number](std::string bytes, const char* kind, char filler) {
    while (bytes.size() % 4 != 0) bytes += filler;
    return number(bytes.size()) + std::string(kind, 4) + bytes;
  };
  const std::string chunks = chunk(scene.dump(), "JSON", ' ') + chunk(binary, "BIN\0", '\0');
  return write(folder / "room.glb", "glTF" + number(2) + number(12 + chunks.size()) + chunks);
}

}  // namespace ajar::test
