#include "session/output/write_picture.h"

#include "imageio/image_file.h"
#include "os/file_extension.h"

namespace ajar {

void write_picture(const std::string& path, const Picture& picture, const DisplayOptions& display) {
  if (is_display_file(path)) {
    DisplayOptions options = display;
    options.has_alpha = file_extension(path) == ".png";
    write_image(path, displayed(picture, options));
  } else {
    write_image(path, picture);
  }
}

}  // namespace ajar
