#pragma once
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfTiledOutputFile.h>
#include <png.h>
#include <tiffio.h>
#include <webp/encode.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "imageio/image_decoder.h"
#include "imageio/image_encoder.h"
#include "os/file_extension.h"

/// Images for tests, written by the libraries of their formats, or byte by byte.
namespace ajar::testing {

/// Values row by row from the top, channels interleaved.
template <typename T>
struct TestImage {
  int width = 1;
  int height = 1;
  int channels = 3;
  std::vector<T> values;

  std::size_t row() const { return static_cast<std::size_t>(width * channels); }
  const T* at(int x, int y) const {
    return values.data() + static_cast<std::size_t>(y) * row() + x * channels;
  }
};

inline void write_bytes(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}
inline void write_bytes(const std::string& path, const std::vector<unsigned char>& bytes) {
  write_bytes(path, std::string(bytes.begin(), bytes.end()));
}

inline std::string little_endian(std::uint64_t value, int size) {
  std::string bytes;
  for (int i = 0; i < size; ++i) bytes += static_cast<char>(value >> (8 * i));
  return bytes;
}

/// 8 or 16 bits of 1 to 4 channels.
template <typename T>
void write_png(const std::string& path, const TestImage<T>& image) {
  constexpr int kTypes[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                            PNG_COLOR_TYPE_RGB_ALPHA};
  std::FILE* file = std::fopen(path.c_str(), "wb");
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, file);
  png_set_compression_level(png, 9);
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width),
               static_cast<png_uint_32>(image.height), 8 * sizeof(T), kTypes[image.channels - 1],
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  png_set_swap(png);
  for (int y = 0; y < image.height; ++y) {
    png_write_row(png, reinterpret_cast<const unsigned char*>(image.at(0, y)));
  }
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  std::fclose(file);
}

struct TiffOptions {
  int compression = COMPRESSION_NONE;
  int tile = 0;  ///< 0: strips
  bool has_planes = false;
  int rows_per_strip = 16;
  int colors = -1;                             ///< PHOTOMETRIC_…; -1: grey or RGB
  std::vector<std::uint16_t> extra_samples{};  ///< EXTRASAMPLE_…
  const char* mode = "w";
};

/// The tags of an image, for the caller to write its pixels.
template <typename T>
TIFF* open_tiff_of(const std::string& path, const TestImage<T>& image, const TiffOptions& options,
                   int bits = 8 * sizeof(T)) {
  TIFF* tiff = TIFFOpen(path.c_str(), options.mode);
  if (tiff == nullptr) throw std::runtime_error("cannot write " + path);
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, image.width);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, image.height);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, image.channels);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, bits);
  TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT,
               std::is_integral_v<T> ? SAMPLEFORMAT_UINT : SAMPLEFORMAT_IEEEFP);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, options.compression);
  const int colors = image.channels < 3 ? PHOTOMETRIC_MINISBLACK : PHOTOMETRIC_RGB;
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, options.colors < 0 ? colors : options.colors);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG,
               options.has_planes ? PLANARCONFIG_SEPARATE : PLANARCONFIG_CONTIG);
  if (!options.extra_samples.empty()) {
    TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, static_cast<int>(options.extra_samples.size()),
                 options.extra_samples.data());
  }
  if (options.compression == COMPRESSION_JPEG) {
    TIFFSetField(tiff, TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
  }
  if (options.tile > 0) {
    TIFFSetField(tiff, TIFFTAG_TILEWIDTH, options.tile);
    TIFFSetField(tiff, TIFFTAG_TILELENGTH, options.tile);
  } else {
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, options.rows_per_strip);
  }
  return tiff;
}

template <typename T>
void write_tiff(const std::string& path, const TestImage<T>& image,
                const TiffOptions& options = {}) {
  TIFF* tiff = open_tiff_of(path, image, options);
  const int planes = options.has_planes ? image.channels : 1;
  const int samples = image.channels / planes;
  const auto part = [&](int left, int top, int width, int height, int plane) {
    std::vector<T> values(static_cast<std::size_t>(width * height * samples));
    for (int y = top; y < std::min(top + height, image.height); ++y) {
      for (int x = left; x < std::min(left + width, image.width); ++x) {
        std::copy_n(image.at(x, y) + plane, samples,
                    values.data() + ((y - top) * width + x - left) * samples);
      }
    }
    return values;
  };
  for (int plane = 0; plane < planes; ++plane) {
    const auto p = static_cast<std::uint16_t>(plane);
    if (options.tile == 0) {
      for (int y = 0; y < image.height; ++y) {
        std::vector<T> row = part(0, y, image.width, 1, plane);
        if (TIFFWriteScanline(tiff, row.data(), static_cast<std::uint32_t>(y), p) < 0) {
          throw std::runtime_error("cannot write a row of " + path);
        }
      }
      continue;
    }
    for (int y = 0; y < image.height; y += options.tile) {
      for (int x = 0; x < image.width; x += options.tile) {
        std::vector<T> tile = part(x, y, options.tile, options.tile, plane);
        if (TIFFWriteTile(tiff, tile.data(), static_cast<std::uint32_t>(x),
                          static_cast<std::uint32_t>(y), 0, p) < 0) {
          throw std::runtime_error("cannot write a tile of " + path);
        }
      }
    }
  }
  TIFFClose(tiff);
}

/// Floats, or halves, of channels R, G, B, A or Y, Z.
template <typename T>
void write_exr(const std::string& path, const TestImage<T>& image,
               Imf::Compression compression = Imf::ZIP_COMPRESSION, int tile = 0,
               Vec2i origin = {0, 0}, std::vector<std::string> names = {}) {
  if (names.empty())
    names = image.channels < 3 ? std::vector<std::string>{"Y", "Z"}
                               : std::vector<std::string>{"R", "G", "B", "A"};
  const Imf::PixelType type = std::is_same_v<T, float> ? Imf::FLOAT : Imf::HALF;
  const Imath::Box2i window(origin, origin + Vec2i(image.width - 1, image.height - 1));
  Imf::Header header(Imath::Box2i({0, 0}, {image.width - 1, image.height - 1}), window);
  header.compression() = compression;
  Imf::FrameBuffer buffer;
  for (int c = 0; c < image.channels; ++c) {
    const std::string& name = names[static_cast<std::size_t>(c)];
    header.channels().insert(name, Imf::Channel(type));
    buffer.insert(name,
                  Imf::Slice::Make(type, image.values.data() + c, origin, image.width, image.height,
                                   sizeof(T) * image.channels, sizeof(T) * image.row()));
  }
  if (tile == 0) {
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(buffer);
    file.writePixels(image.height);
    return;
  }
  header.setTileDescription(
      {static_cast<unsigned>(tile), static_cast<unsigned>(tile), Imf::ONE_LEVEL});
  Imf::TiledOutputFile file(path.c_str(), header);
  file.setFrameBuffer(buffer);
  file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
}

/// Red, green, blue (and alpha) without loss.
inline void write_webp(const std::string& path, const TestImage<std::uint8_t>& image) {
  unsigned char* bytes = nullptr;
  const auto encode = image.channels == 4 ? WebPEncodeLosslessRGBA : WebPEncodeLosslessRGB;
  const std::size_t size =
      encode(image.values.data(), image.width, image.height, static_cast<int>(image.row()), &bytes);
  write_bytes(path, std::vector<unsigned char>(bytes, bytes + size));
  WebPFree(bytes);
}

/// Red, green and blue, or with alpha: rows from the bottom, blue first. Source: Microsoft,
/// "BITMAPINFOHEADER"; of 32 bits the BITMAPV4HEADER, which says where alpha is.
inline std::string bmp_bytes(const TestImage<std::uint8_t>& image) {
  const bool has_alpha = image.channels == 4;
  const int header = has_alpha ? 108 : 40;
  std::string bytes = "BM" + little_endian(0, 8) + little_endian(14 + header, 4) +
                      little_endian(header, 4) + little_endian(image.width, 4) +
                      little_endian(image.height, 4) + little_endian(1, 2) +
                      little_endian(8 * image.channels, 2) + little_endian(has_alpha ? 3 : 0, 4) +
                      std::string(20, '\0');
  if (has_alpha) {
    for (const std::uint32_t mask : {0xff0000U, 0xff00U, 0xffU, 0xff000000U}) {
      bytes += little_endian(mask, 4);
    }
    bytes.resize(14 + 108, '\0');
  }
  for (int y = image.height - 1; y >= 0; --y) {
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t* pixel = image.at(x, y);
      for (const int c : {2, 1, 0, 3}) {
        if (c < image.channels) bytes += static_cast<char>(pixel[c]);
      }
    }
    bytes.resize((bytes.size() - 14 - header + 3) / 4 * 4 + 14 + header, '\0');
  }
  return bytes;
}

/// Grey, red, green and blue, or with alpha, in runs of one pixel value or as they are. Source:
/// Truevision 1991, "TGA File Format Specification", version 2.0.
inline std::string tga_bytes(const TestImage<std::uint8_t>& image, bool in_runs, bool from_top) {
  const bool is_gray = image.channels == 1;
  std::string bytes = little_endian(0, 2);
  bytes += static_cast<char>((is_gray ? 3 : 2) + (in_runs ? 8 : 0));
  bytes += std::string(9, '\0') + little_endian(image.width, 2) + little_endian(image.height, 2);
  bytes += static_cast<char>(8 * image.channels);
  bytes += static_cast<char>((image.channels == 4 ? 8 : 0) + (from_top ? 0x20 : 0));
  for (int i = 0; i < image.height; ++i) {
    const int y = from_top ? i : image.height - 1 - i;
    for (int x = 0; x < image.width;) {
      const std::uint8_t* pixel = image.at(x, y);
      int run = 1;
      while (in_runs && x + run < image.width && run < 128 &&
             std::equal(pixel, pixel + image.channels, image.at(x + run, y))) {
        ++run;
      }
      if (in_runs) bytes += static_cast<char>(127 + run);
      for (const int c : {2, 1, 0, 3}) {
        if (c < image.channels) bytes += static_cast<char>(pixel[c]);
      }
      x += run;
    }
  }
  return bytes;
}

}  // namespace ajar::testing
