// Image textures. Source: pbrt-v3, section 10.4; t = 0 is the bottom row. Pixels are filtered by
// supersampling, so there is no pyramid.
#include <algorithm>
#include <array>

#include "color/srgb.h"
#include "core/floor_to_int.h"
#include "scene/texture/constant_texture.h"
#include "scene/texture/inputs.h"
#include "scene/texture/mapping.h"

namespace ajar {

namespace {

/// Linear values of all codes of an unsigned integer type.
using DecodingTable = std::shared_ptr<const std::vector<float>>;
template <typename T, typename ToLinear>
DecodingTable make_table(const ToLinear& to_linear) {
  constexpr std::size_t kCodes = std::size_t{1} << (8 * sizeof(T));
  std::vector<float> values;
  values.reserve(kCodes);
  for (std::size_t i = 0; i < kCodes; ++i) {
    values.push_back(to_linear(static_cast<float>(i) / static_cast<float>(kCodes - 1)));
  }
  return std::make_shared<const std::vector<float>>(std::move(values));
}
template <typename T>
DecodingTable decoding_table(const desc::Node& node) {
  if (const float* gamma = std::get_if<float>(&node.get("decoding_exponent"))) {
    return make_table<T>([=](float v) { return std::pow(v, *gamma); });
  }
  static const DecodingTable kLinear = make_table<T>([](float v) { return v; });
  static const DecodingTable kSrgb = make_table<T>(linear_from_srgb<float>);
  return node.flag("decode_srgb") ? kSrgb : kLinear;
}

float sane(float v) { return std::isfinite(v) ? v : 0.F; }

template <typename T>
struct Decoder {
  explicit Decoder(const desc::Node& /*node*/) {}
  float operator()(T v) const { return sane(static_cast<float>(v)); }
  float gray(T r, T g, T b) const {
    return luminance(Spectrum((*this)(r), (*this)(g), (*this)(b)));
  }
};

template <std::unsigned_integral T>
struct Decoder<T> {
  explicit Decoder(const desc::Node& node) : owner(decoding_table<T>(node)), table(owner->data()) {}
  float operator()(T v) const { return table[v]; }
  /// pbrt-v3 takes the luminance of the encoded colour and decodes that.
  float gray(T r, T g, T b) const {
    const float y = luminance(Spectrum(r, g, b));
    return table[static_cast<std::size_t>(
        std::min(y + 0.5F, static_cast<float>(std::numeric_limits<T>::max())))];
  }
  DecodingTable owner;
  const float* table;
};

enum class Wrap { Repeat, Black, Clamp };

Wrap wrap_of(const desc::Node& node) {
  const std::string& name = node.text("wrap");
  return name == "black" ? Wrap::Black : name == "clamp" ? Wrap::Clamp : Wrap::Repeat;
}

/// Conversion of an image's colours to one number.
enum class Reduction {
  None,       ///< colours stay; where a number is asked for: luminance as pbrt-v3 takes it
  Mean,       ///< mean of the decoded values
  Luminance,  ///< luminance of the decoded values
};

Reduction reduction_of(const desc::Node& node) {
  const std::string& name = node.text("channel");
  if (name == "luminance") return Reduction::Luminance;
  return name == "mean" || name == "alpha_or_mean" || name == "varying_alpha_or_mean"
             ? Reduction::Mean
             : Reduction::None;
}

template <typename T>
class ImageTexture final : public Texture {
 public:
  ImageTexture(const desc::Node& node, std::shared_ptr<const TexelImage> image)
      : mapping_(node),
        wrap_(wrap_of(node)),
        reduction_(reduction_of(node)),
        nearest_(node.text("filter") == "nearest"),
        scale_(node.number("scale")),
        offset_(node.number("offset")),
        image_(std::move(image)),
        texels_(std::get<std::vector<T>>(image_->texels).data()),
        decode_(node),
        invert_(node.flag("invert")),
        clamp_(node.flag("clamp")) {}

  Spectrum eval(const SurfacePoint& at) const override {
    if (image_->channels == 1 || reduction_ != Reduction::None) return Spectrum(eval_float(at));
    return filtered<Spectrum>(at, [this](const T* texel) {
      return Spectrum(decode_(texel[0]), decode_(texel[1]), decode_(texel[2]));
    });
  }
  float eval_float(const SurfacePoint& at) const override {
    if (image_->channels == 1) {
      return filtered<float>(at, [this](const T* texel) { return decode_(*texel); });
    }
    return filtered<float>(at, [this](const T* texel) { return reduced(texel); });
  }

 private:
  float reduced(const T* texel) const {
    if (reduction_ == Reduction::None) return decode_.gray(texel[0], texel[1], texel[2]);
    const Spectrum color(decode_(texel[0]), decode_(texel[1]), decode_(texel[2]));
    return reduction_ == Reduction::Mean ? color.average() : luminance(color);
  }

  /// Index into a row or column, or −1 outside of a black border.
  int wrapped(int i, int size) const {
    if (i >= 0 && i < size) return i;
    switch (wrap_) {
      case Wrap::Repeat: {
        const int m = i % size;
        return m < 0 ? m + size : m;
      }
      case Wrap::Clamp:
        return i < 0 ? 0 : size - 1;
      case Wrap::Black:
        break;
    }
    return -1;
  }

  template <typename Value, typename Decode>
  Value texel(int x, int y, const Decode& decode) const {
    x = wrapped(x, image_->width);
    y = wrapped(y, image_->height);
    if (x < 0 || y < 0) return Value(0.F);
    const auto row = static_cast<std::size_t>(image_->height - 1 - y);
    const std::size_t index =
        row * static_cast<std::size_t>(image_->width) + static_cast<std::size_t>(x);
    return decode(texels_ + index * static_cast<std::size_t>(image_->channels));
  }

  template <typename Value, typename Decode>
  Value filtered(const SurfacePoint& at, const Decode& decode) const {
    const Vec2 st = mapping_.map(at);
    const float x = st.x * static_cast<float>(image_->width);
    const float y = st.y * static_cast<float>(image_->height);
    if (nearest_) return finished(texel<Value>(floor_to_int(x), floor_to_int(y), decode));
    const int x0 = floor_to_int(x - 0.5F);
    const int y0 = floor_to_int(y - 0.5F);
    const float dx = std::clamp(x - 0.5F - static_cast<float>(x0), 0.F, 1.F);
    const float dy = std::clamp(y - 0.5F - static_cast<float>(y0), 0.F, 1.F);
    const Value low =
        texel<Value>(x0, y0, decode) * (1.F - dx) + texel<Value>(x0 + 1, y0, decode) * dx;
    const Value high =
        texel<Value>(x0, y0 + 1, decode) * (1.F - dx) + texel<Value>(x0 + 1, y0 + 1, decode) * dx;
    return finished(low * (1.F - dy) + high * dy);
  }

  float finished(float value) const {
    const float scaled = value * scale_ + offset_;
    const float result = invert_ ? std::max(1.F - scaled, 0.F) : scaled;
    return clamp_ ? std::clamp(result, 0.F, 1.F) : result;
  }
  Spectrum finished(const Spectrum& value) const {
    if (!invert_ && !clamp_ && offset_ == 0.F) return value * scale_;
    return map_lanes(value, [this](float lane) { return finished(lane); });
  }

  TextureMapping mapping_;
  Wrap wrap_;
  Reduction reduction_;
  bool nearest_;
  float scale_;
  float offset_;
  std::shared_ptr<const TexelImage> image_;
  const T* texels_;
  Decoder<T> decode_;
  bool invert_;
  bool clamp_;
};

std::unique_ptr<const Texture> make_image_texture(const TextureInputs& in) {
  const std::shared_ptr<const TexelImage> image = in.image("file");
  if (!image) {
    // The best replacement of a number has no effect on the rest of its material.
    const bool is_color = in.node().text("channel") == "color";
    return std::make_unique<ConstantTexture>(is_color ? Spectrum(1.F, 0.F, 1.F) : Spectrum(1.F),
                                             true);
  }
  return std::visit(
      [&]<typename T>(const std::vector<T>&) -> std::unique_ptr<const Texture> {
        return std::make_unique<ImageTexture<T>>(in.node(), image);
      },
      image->texels);
}

}  // namespace

TextureModel image_texture() {
  ParameterSpec decode = declare::flag(
      "decode_srgb", "whether integers are sRGB-coded; files of floats are linear in any case");
  decode.default_value = "true";
  ParameterSpec gamma =
      declare::number("decoding_exponent", "",
                      "exponent that decodes integers; without it, they are as decode_srgb says");
  gamma.minimum = 0.0;
  return {{.name = "image",
           .summary = "an image file",
           .source = "",
           .parameters = declare::joined(
               {declare::file("file", "the image"),
                choice_parameter("channel",
                                 {"color", "red", "green", "blue", "alpha", "mean", "luminance",
                                  "alpha_or_mean", "varying_alpha_or_mean"},
                                 "what is taken of it: all colours, one of them, alpha (1 if it "
                                 "has none), the mean or the luminance of the colours; "
                                 "alpha_or_mean: alpha, or the mean if it has none; "
                                 "varying_alpha_or_mean: the mean also where alpha is 1 "
                                 "everywhere, or beside a gray"),
                choice_parameter("wrap", {"repeat", "black", "clamp"},
                                 "what is beyond the edge of the image"),
                std::move(decode), std::move(gamma),
                declare::number("scale", "1", "factor of all values"),
                declare::number("offset", "0", "added to all values, after the scale"),
                declare::flag("invert", "1 − value, after the offset; never below 0"),
                declare::flag("clamp", "to 0 and 1, after all this"),
                choice_parameter("filter", {"bilinear", "nearest"}, "between texels")},
               mapping_parameters())},
          make_image_texture};
}

}  // namespace ajar
