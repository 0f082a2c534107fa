#include "core/image_small/small_images.h"

namespace ajar {

std::unique_ptr<ImageDecoder> open_image(const std::string& path, bool has_unassociated_alpha) {
  return small_images::open_image(path, has_unassociated_alpha);
}
std::vector<unsigned char> encode_exr(const ImageLayout& layout, const RowSource<float>& row) {
  return small_images::encode_exr(layout, row);
}
std::vector<unsigned char> encode_hdr(const ImageLayout& layout, const RowSource<float>& row) {
  return small_images::encode_hdr(layout, row);
}
std::vector<unsigned char> encode_png(const ImageLayout& layout,
                                      const RowSource<unsigned char>& row) {
  return small_images::encode_png(layout, row);
}
std::vector<unsigned char> encode_jpeg(const ImageLayout& layout,
                                       const RowSource<unsigned char>& row) {
  return small_images::encode_jpeg(layout, row);
}

}  // namespace ajar
