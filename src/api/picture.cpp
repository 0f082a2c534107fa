#include "ajar/picture.h"

#include <algorithm>
#include <utility>

#include "api/contents.h"
#include "imageio/image_file.h"
#include "imageio/read_picture.h"
#include "session/options/limits.h"
#include "session/output/write_picture.h"

namespace ajar::v0 {

namespace {

const ajar::Picture::Layer& find_layer(const ajar::Picture& picture, const std::string& name) {
  const auto found = std::find_if(picture.layers.begin(), picture.layers.end(),
                                  [&](const auto& layer) { return layer.name == name; });
  if (found != picture.layers.end()) return *found;
  std::vector<std::string> valid;
  for (const auto& layer : picture.layers) valid.push_back(layer.name);
  throw Error(Error::Kind::Usage, unknown_name_message("layer", name, valid));
}

}  // namespace

Picture::Picture(std::shared_ptr<const Content> content) : content_(std::move(content)) {}

Picture Picture::load(const std::string& path) {
  return with_public_errors(
      [&] { return public_picture(std::make_shared<const ajar::Picture>(read_picture(path))); });
}

int Picture::width() const { return content_->picture->crop.size().x + 1; }
int Picture::height() const { return content_->picture->crop.size().y + 1; }

std::vector<std::string> Picture::layers() const {
  std::vector<std::string> names;
  for (const auto& layer : content_->picture->layers) names.push_back(layer.name);
  return names;
}

int Picture::channels(const std::string& layer) const {
  return find_layer(*content_->picture, layer).channels;
}

std::span<const float> Picture::pixels(const std::string& layer) const {
  return find_layer(*content_->picture, layer).pixels;
}

const std::map<std::string, std::string>& Picture::metadata() const {
  return content_->picture->metadata;
}

void Picture::save(const std::string& path, const Display& display) const {
  with_public_errors([&] {
    check_image_extension(path);
    check_within(limits::kStops, display.exposure, "exposure");
    write_picture(path, *content_->picture, {tone_map_by_name(display.tone_map), display.exposure});
  });
}

}  // namespace ajar::v0
