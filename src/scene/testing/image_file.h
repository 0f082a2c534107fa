#pragma once
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "imageio/image_file.h"

namespace ajar::testing {

/// An image file that lasts as long as the object.
class ImageFile {
 public:
  ImageFile(int width, int height, const std::vector<float>& rgb,
            const std::string& extension = ".exr", int channels = 3) {
    static int count = 0;
    path_ =
        (std::filesystem::temp_directory_path() / ("ajar_light_test_" + std::to_string(getpid()) +
                                                   "_" + std::to_string(count++) + extension))
            .string();
    write_image(
        path_,
        {{width, height}, Box2i({0, 0}, {width - 1, height - 1}), {{"", channels, rgb}}, {}});
  }
  ~ImageFile() { std::filesystem::remove(path_); }
  ImageFile(const ImageFile&) = delete;
  ImageFile& operator=(const ImageFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace ajar::testing
