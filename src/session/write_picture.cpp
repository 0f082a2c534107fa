#include "session/write_picture.h"

#include "image/image_file.h"

namespace ajar {

void write_picture(const std::string& path, const Picture& picture, const DisplayOptions& display) {
  if (is_display_file(path)) {
    write_image(path, displayed(picture, display));
  } else {
    write_image(path, picture);
  }
}

}  // namespace ajar
