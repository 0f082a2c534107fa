#include "session/write_picture.h"

#include "core/file_extension.h"
#include "image/image_file.h"

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
