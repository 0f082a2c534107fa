#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <exception>

#include "core/error.h"
#include "imageio/image_encoder.h"

namespace ajar {

namespace {

class MemoryStream final : public Imf::OStream {
 public:
  explicit MemoryStream(std::vector<unsigned char>& bytes) : OStream("memory"), bytes_(bytes) {}
  void write(const char* from, int count) override {
    const std::size_t end = at_ + static_cast<std::size_t>(count);
    if (bytes_.size() < end) bytes_.resize(end);
    std::copy_n(from, count, bytes_.begin() + static_cast<std::ptrdiff_t>(at_));
    at_ = end;
  }
  std::uint64_t tellp() override { return at_; }
  void seekp(std::uint64_t place) override { at_ = place; }

 private:
  std::vector<unsigned char>& bytes_;
  std::size_t at_ = 0;
};

Imf::Header header_of(const ImageLayout& layout) {
  const Vec2i size(layout.width, layout.height);
  Imf::Header header(Imath::Box2i(Vec2i(0, 0), layout.resolution - Vec2i(1, 1)),
                     Imath::Box2i(layout.origin, layout.origin + size - Vec2i(1, 1)));
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const std::string& name : layout.names) {
    header.channels().insert(name, Imf::Channel(Imf::FLOAT));
  }
  for (const auto& [name, text] : layout.texts) {
    header.insert(name, Imf::StringAttribute(text));
  }
  return header;
}

void write(const ImageLayout& layout, const RowSource<float>& row, Imf::OutputFile& file) {
  constexpr int kRows = 16;  // rows of a block
  const std::size_t pixel = layout.names.size() * sizeof(float);
  const std::size_t stride = pixel * static_cast<std::size_t>(layout.width);
  std::vector<float> strip(stride / sizeof(float) * kRows);
  for (int first = 0; first < layout.height; first += kRows) {
    const int rows = std::min(kRows, layout.height - first);
    for (int y = 0; y < rows; ++y) {
      row(first + y, strip.data() + stride / sizeof(float) * static_cast<std::size_t>(y));
    }
    Imf::FrameBuffer buffer;
    for (std::size_t i = 0; i < layout.names.size(); ++i) {
      buffer.insert(layout.names[i],
                    Imf::Slice::Make(Imf::FLOAT, strip.data() + i, layout.origin + Vec2i(0, first),
                                     layout.width, rows, pixel, stride));
    }
    file.setFrameBuffer(buffer);
    file.writePixels(rows);
  }
}

}  // namespace

std::vector<unsigned char> encode_exr(const ImageLayout& layout, const RowSource<float>& row) {
  std::vector<unsigned char> bytes;
  try {
    MemoryStream stream(bytes);
    // The destructor writes the table of its rows.
    Imf::OutputFile file(stream, header_of(layout), 0);
    write(layout, row, file);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw IoError(error.what());
  }
  return bytes;
}

}  // namespace ajar
