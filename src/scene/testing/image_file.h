#pragma once
#include <OpenImageIO/imageio.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace ajar::testing {

/// An image file that lasts as long as the object.
class ImageFile {
 public:
  ImageFile(int width, int height, const std::vector<float>& rgb,
            const std::string& extension = ".exr",
            const OIIO::TypeDesc& format = OIIO::TypeDesc::FLOAT, int channels = 3) {
    static int count = 0;
    path_ =
        (std::filesystem::temp_directory_path() / ("ajar_light_test_" + std::to_string(getpid()) +
                                                   "_" + std::to_string(count++) + extension))
            .string();
    const auto output = OIIO::ImageOutput::create(path_);
    const OIIO::ImageSpec spec(width, height, channels, format);
    if (!output || !output->open(path_, spec) ||
        !output->write_image(OIIO::TypeDesc::FLOAT, rgb.data()) || !output->close()) {
      throw std::runtime_error("cannot write " + path_);
    }
  }
  ~ImageFile() { std::filesystem::remove(path_); }
  ImageFile(const ImageFile&) = delete;
  ImageFile& operator=(const ImageFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace ajar::testing
