#include "api/c/handles.h"
#include "api/c/json_text.h"

using ajar::c::give_text;
using ajar::c::given;
using ajar::c::guarded;
using ajar::c::parsed_object;

int ajar_picture_width(const ajar_picture* picture) {
  int width = 0;
  guarded([&] { width = given(picture, "picture").picture.width(); });
  return width;
}

int ajar_picture_height(const ajar_picture* picture) {
  int height = 0;
  guarded([&] { height = given(picture, "picture").picture.height(); });
  return height;
}

int ajar_picture_layers(const ajar_picture* picture, char** json) {
  return guarded([&] {
    const ajar::v0::Picture& of = given(picture, "picture").picture;
    give_text(ajar::c::json_text(of.layers()), json);
  });
}

int ajar_picture_pixels(const ajar_picture* picture, const char* layer, int* channels,
                        const float** pixels) {
  return guarded([&] {
    const ajar::v0::Picture& of = given(picture, "picture").picture;
    const char* name = &given(layer, "layer");
    given(channels, "channels") = of.channels(name);
    given(pixels, "pixels") = of.pixels(name).data();
  });
}

int ajar_picture_metadata(const ajar_picture* picture, char** json) {
  return guarded([&] {
    const ajar::v0::Picture& of = given(picture, "picture").picture;
    give_text(ajar::c::json_text(of.metadata()), json);
  });
}

int ajar_picture_save(const ajar_picture* picture, const char* path, const char* display) {
  return guarded([&] {
    const ajar::LocatedJson wish =
        parsed_object(display == nullptr ? "{}" : display, "member", {"exposure", "tone_map"});
    const ajar::v0::Display as{wish.value_or("exposure", 0.F),
                               wish.value_or("tone_map", std::string("srgb"))};
    given(picture, "picture").picture.save(&given(path, "path"), as);
  });
}

int ajar_picture_load(const char* path, ajar_picture** picture) {
  return guarded([&] {
    given(picture, "picture") = nullptr;
    *picture = new ajar_picture{ajar::v0::Picture::load(&given(path, "path"))};
  });
}

void ajar_picture_free(ajar_picture* picture) { delete picture; }

int ajar_compare(const char* request, char** json) {
  return guarded([&] {
    const ajar::LocatedJson wish =
        parsed_object(&given(request, "request"), "member",
                      {"reference", "pictures", "metrics", "pixels_per_degree"});
    using Names = std::vector<std::string>;
    given(json, "json");
    give_text(ajar::v0::compare(
                  wish.value_or("reference", std::string()), wish.value_or("pictures", Names()),
                  wish.value_or("metrics", Names()), wish.find<double>("pixels_per_degree")),
              json);
  });
}
