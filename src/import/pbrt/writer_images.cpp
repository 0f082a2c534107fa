#include "import/pbrt/writer_images.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "color/srgb.h"
#include "core/error.h"
#include "core/spectrum.h"
#include "imageio/image_encoder.h"
#include "imageio/image_input.h"
#include "os/file_extension.h"
#include "os/memory_file.h"
#include "scene/desc/models.h"

namespace ajar::pbrt {
namespace {

namespace fs = std::filesystem;

bool opens_in_pbrt(const std::string& image) {
  const std::string extension = file_extension(image);
  return extension == ".exr" || extension == ".png" || extension == ".tga" || extension == ".pfm";
}

/// Decodes the values in a file to linear ones.
struct Decoding {
  bool is_integer;
  bool is_srgb;
  std::optional<float> exponent;

  float operator()(float value) const {
    if (!std::isfinite(value)) return 0.F;
    if (!is_integer) return value;
    if (exponent) return std::pow(value, *exponent);
    return is_srgb ? linear_from_srgb(value) : value;
  }
};

std::optional<float> number_if_given(const desc::Node& node, const char* name) {
  if (!node.has(name)) return std::nullopt;
  const float* value = std::get_if<float>(&node.get(name));
  return value == nullptr ? std::nullopt : std::optional(*value);
}

float mean_of(const Vec3& c) { return (c.x + c.y + c.z) / 3.F; }

/// Selection among the channels of a texel, by `channel` of an image texture.
struct Choice {
  std::string channel;
  const ColorChannels& from;

  Vec3 operator()(const float* texel, const Decoding& decode) const {
    const auto at = [&](int i) { return decode(texel[from.first + (from.count < 3 ? 0 : i)]); };
    const auto alone = [](float value) { return Vec3(value); };
    if (channel == "red") return alone(at(0));
    if (channel == "green") return alone(at(1));
    if (channel == "blue") return alone(at(2));
    if (channel == "alpha") return alone(from.alpha < 0 ? 1.F : decode(texel[from.alpha]));
    const Vec3 color(at(0), at(1), at(2));
    if (channel == "mean") return alone(mean_of(color));
    if (channel == "luminance") return alone(luminance(Spectrum(color.x, color.y, color.z)));
    return color;
  }
};

/// All that the texels of an image texture follow from.
std::string key_of(const desc::Node& texture) {
  return fmt::format("{} {} {} {} {} {} {} {}", texture.text("channel"), texture.flag("invert"),
                     texture.flag("clamp"), texture.flag("decode_srgb"), texture.number("scale"),
                     texture.number("offset"),
                     number_if_given(texture, "decoding_exponent").value_or(0.F),
                     texture.text("file"));
}

/// `channel` of a texture, resolved for the image.
std::string settled_channel(const std::string& channel, const ImageInput& input,
                            const std::vector<float>& values) {
  const ColorChannels& colors = input.colors();
  const bool has_alpha = colors.alpha >= 0;
  if (channel == "alpha_or_mean") return has_alpha ? "alpha" : "mean";
  if (channel != "varying_alpha_or_mean") return channel;
  if (!has_alpha || colors.count < 3) return "mean";
  for (auto i = static_cast<std::size_t>(colors.alpha); i < values.size();
       i += static_cast<std::size_t>(input.header().channels)) {
    if (values[i] != 1.F) return "alpha";
  }
  return "mean";
}

}  // namespace

std::optional<LinearImage> ImageWriter::read_linear(const desc::Node& node,
                                                    const std::string& image) {
  try {
    std::optional<MemoryFile> memory;
    const auto embedded = scene_.embedded_files.find(image);
    if (embedded != scene_.embedded_files.end()) memory.emplace(*embedded->second);
    ImageInput input(memory ? memory->path() : image, true);
    const ImageHeader& header = input.header();
    // The texels themselves, and their conversion.
    const std::vector<float> values =
        input.read<float>(header.channels, 3 * header.pixels() * sizeof(Vec3));
    const bool is_integer = header.type == SampleType::UInt8 || header.type == SampleType::UInt16;
    const Decoding decode{is_integer, !node.has("decode_srgb") || node.flag("decode_srgb"),
                          number_if_given(node, "decoding_exponent")};
    const bool is_gray = node.has("gray") && node.flag("gray");
    const std::string channel = node.has("channel") ? node.text("channel") : "color";
    const Choice choice{is_gray ? "mean" : settled_channel(channel, input, values), input.colors()};
    LinearImage result{header.width, header.height, header.type == SampleType::UInt8, {}};
    result.texels.reserve(header.pixels());
    for (std::size_t i = 0; i < values.size(); i += static_cast<std::size_t>(header.channels)) {
      result.texels.push_back(choice(&values[i], decode));
    }
    return result;
  } catch (const Error&) {
    unreadable_.insert(image);
    return std::nullopt;
  }
}

std::string ImageWriter::name(const std::string& image) {
  std::string path = image;
  const auto embedded = scene_.embedded_files.find(image);
  if (embedded != scene_.embedded_files.end()) {
    path = files_.write("image", *embedded->second, file_extension(image));
  }
  const fs::path relative = fs::path(path).lexically_relative(path_.parent_path());
  return relative.empty() ? path : relative.generic_string();
}

/// `is_decoded`: pbrt takes the integers of a PNG file for sRGB.
std::string ImageWriter::write(const LinearImage& image, bool is_decoded, bool may_be_png) const {
  ImageLayout layout;
  layout.width = image.width;
  layout.height = image.height;
  layout.names = {"R", "G", "B"};
  layout.resolution = {image.width, image.height};
  const auto row = [&](int y) {
    return &image.texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width)];
  };
  const auto fits = [](const Vec3& c) {
    return std::min({c.x, c.y, c.z}) >= 0.F && std::max({c.x, c.y, c.z}) <= 1.F;
  };
  const bool is_png =
      may_be_png && image.is_8_bit && std::all_of(image.texels.begin(), image.texels.end(), fits);
  const auto code = [&](float value) {
    const float coded = is_decoded ? srgb_from_linear(value) : value;
    return static_cast<unsigned char>(std::clamp(coded * 255.F + 0.5F, 0.F, 255.F));
  };
  const auto width = static_cast<std::size_t>(image.width);
  const std::vector<unsigned char> bytes =
      is_png ? encode_png(layout,
                          [&](int y, unsigned char* out) {
                            for (std::size_t i = 0; i < 3 * width; ++i)
                              out[i] = code(row(y)[i / 3][static_cast<int>(i % 3)]);
                          })
             : encode_exr(layout, [&](int y, float* out) {
                 for (std::size_t i = 0; i < 3 * width; ++i)
                   out[i] = row(y)[i / 3][static_cast<int>(i % 3)];
               });
  return files_.write("image", {reinterpret_cast<const char*>(bytes.data()), bytes.size()},
                      is_png ? ".png" : ".exr");
}

std::optional<std::string> ImageWriter::for_texture(const desc::Node& texture) {
  const std::string& image = texture.text("file");
  const float scale = texture.number("scale");
  const std::optional<float> exponent = number_if_given(texture, "decoding_exponent");
  const bool is_inverted = texture.flag("invert");
  const bool is_clamped = texture.flag("clamp");
  const std::string& channel = texture.text("channel");
  const bool is_plain = channel == "color" && !is_inverted && !is_clamped && !exponent &&
                        texture.number("offset") == 0.F;
  if (image.empty() || scale == 0.F || (is_plain && opens_in_pbrt(image))) return std::nullopt;
  const std::string key = key_of(texture);
  const auto known = textures_.find(key);
  if (known != textures_.end()) return known->second;
  std::optional<std::string>& file = textures_[key];
  if (std::optional<LinearImage> linear = read_finished(texture)) {
    for (Vec3& texel : linear->texels) texel /= scale;  // pbrt has the scale, too
    file = write(*linear, texture.flag("decode_srgb"), true);
  }
  return file;
}

/// Texels as the texture has them.
std::optional<LinearImage> ImageWriter::read_finished(const desc::Node& texture) {
  std::optional<LinearImage> linear = read_linear(texture, texture.text("file"));
  if (!linear) return std::nullopt;
  for (Vec3& texel : linear->texels) {
    for (int i = 0; i < 3; ++i) {
      float value = texel[i] * texture.number("scale") + texture.number("offset");
      if (texture.flag("invert")) value = std::max(1.F - value, 0.F);
      if (texture.flag("clamp")) value = std::clamp(value, 0.F, 1.F);
      texel[i] = value;
    }
  }
  return linear;
}

std::optional<desc::Node> ImageWriter::cut_out(const desc::Node& texture, float edge) {
  if (texture.text("mapping") != "uv" && texture.text("mapping") != "planar") return std::nullopt;
  std::optional<LinearImage> image = read_finished(texture);
  if (!image) return std::nullopt;
  for (Vec3& texel : image->texels) {
    const float value = texture.text("channel") == "color"
                            ? luminance(Spectrum(texel.x, texel.y, texel.z))
                            : texel.x;
    texel = Vec3(value >= edge ? 1.F : 0.F);
  }
  image->is_8_bit = true;
  desc::Node result =
      desc::texture_node("image", {{"file", write(*image, false, true)}, {"decode_srgb", false}});
  for (const char* name : {"wrap", "mapping", "scale_u", "scale_v", "rotation", "offset_u",
                           "offset_v", "axis_u", "axis_v"}) {
    result.set(name, texture.get(name));
  }
  return result;
}

std::string ImageWriter::sky(const desc::Node& light) {
  return write(
      clear_sky(light.number("turbidity"), light.number("elevation"), light.number("scale")), false,
      false);
}

ImageWriter::LightImage ImageWriter::for_light(const desc::Node& light) {
  std::string key(light.model().name);
  for (const char* said : {"projection", "gray", "irradiance", "power", "decoding_exponent"}) {
    if (!light.has(said)) continue;
    const desc::Value& value = light.get(said);
    key += ' ';
    if (const float* number = std::get_if<float>(&value)) key += fmt::format("{}", *number);
    if (const bool* flag = std::get_if<bool>(&value)) key += fmt::format("{}", *flag);
    if (const auto* text = std::get_if<std::string>(&value)) key += *text;
  }
  key += " " + light.text("image");
  const auto known = lights_.find(key);
  return known != lights_.end() ? known->second : lights_[key] = make_for_light(light);
}

ImageWriter::LightImage ImageWriter::make_for_light(const desc::Node& light) {
  const std::string& image = light.text("image");
  const std::string extension = file_extension(image);
  const bool is_gray = light.has("gray") && light.flag("gray");
  const bool may_be_square = light.has("projection") && light.text("projection") == "equal_area";
  const bool is_seen = (extension == ".exr" || extension == ".pfm") && !is_gray;
  const bool is_from_above = light.has("irradiance");
  // The strength of a slide depends on its field of view, too.
  const std::optional<float> target =
      light.is("projection") ? std::nullopt
                             : number_if_given(light, is_from_above ? "irradiance" : "power");
  LightImage result;
  if (image.empty() || (is_seen && !may_be_square && !target)) return result;
  std::optional<LinearImage> linear = read_linear(light, image);
  if (!linear || linear->texels.empty()) return result;
  // Others have rows of latitude in spite of the word.
  const bool is_square = may_be_square && linear->width == linear->height;
  if (is_square) linear = rows_of_latitude(*linear);
  if (!is_seen || is_square) {
    result.file = write(*linear, false, false);
  } else if (may_be_square) {
    result.file = image;
  }
  if (!target) return result;
  const double actual =
      is_from_above ? luminance_from_above(*linear) : luminance_all_around(*linear);
  if (actual > 0.0) result.factor = static_cast<float>(*target / actual);
  return result;
}

std::optional<Vec3> ImageWriter::mean(const desc::Node& texture) {
  const std::string key = key_of(texture);
  const auto known = means_.find(key);
  if (known != means_.end()) return known->second;
  std::optional<Vec3>& mean = means_[key];
  const std::optional<LinearImage> image = read_finished(texture);
  if (!image || image->texels.empty()) return mean;
  Vec3d sum(0.0);
  for (const Vec3& texel : image->texels) sum += Vec3d(texel);
  mean = Vec3(sum / static_cast<double>(image->texels.size()));
  return mean;
}

}  // namespace ajar::pbrt
