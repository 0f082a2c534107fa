#include "imageio/image_decoder.h"

namespace ajar {

namespace {

template <typename T>
T multiplied(T value, T alpha) {
  const float product = static_cast<float>(value) * static_cast<float>(alpha);
  if constexpr (!std::is_integral_v<T>) return static_cast<T>(product);
  return static_cast<T>(product / static_cast<float>(static_cast<T>(-1)) + 0.5F);
}

template <typename T>
float float_of(T value) {
  if constexpr (!std::is_integral_v<T>) return static_cast<float>(value);
  return static_cast<float>(value) * (1.F / static_cast<float>(static_cast<T>(-1)));
}

}  // namespace

void ImageDecoder::describe_pixels(int width, int height, int channels, SampleType type) {
  header_.width = width;
  header_.height = height;
  header_.channels = row_channels_ = channels;
  header_.resolution = {width, height};
  header_.type = type;
  header_.is_integer = type == SampleType::UInt8 || type == SampleType::UInt16;
  header_.names =
      channels < 3 ? std::vector<std::string>{"Y"} : std::vector<std::string>{"R", "G", "B"};
  if (channels % 2 == 0) {
    header_.alpha_channel = channels - 1;
    header_.names.emplace_back("A");
  }
}

void ImageDecoder::pick(const void* row, int first_channel, int channels, SampleType type,
                        void*& to) const {
  const auto pick_of = [&]<typename T>(T) {
    const auto fill = [&](auto* out, const auto& convert) {
      const T* pixel = static_cast<const T*>(row);
      for (int x = 0; x < header_.width; ++x, pixel += row_channels_) {
        for (int c = first_channel; c < first_channel + channels; ++c) {
          const bool is_multiplied = multiplies_ && c != header_.alpha_channel;
          *out++ = convert(is_multiplied ? multiplied(pixel[c], pixel[header_.alpha_channel])
                                         : pixel[c]);
        }
      }
      to = out;
    };
    if (type == SampleType::Float) {
      fill(static_cast<float*>(to), float_of<T>);
    } else {
      fill(static_cast<T*>(to), [](T value) { return value; });
    }
  };
  switch (header_.type) {
    case SampleType::UInt8:
      return pick_of(std::uint8_t{});
    case SampleType::UInt16:
      return pick_of(std::uint16_t{});
    case SampleType::Half:
      return pick_of(Imath::half{});
    case SampleType::Float:
      return pick_of(float{});
  }
}

}  // namespace ajar
