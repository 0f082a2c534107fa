#include <nlohmann/json.hpp>

#include "api/c/handles.h"
#include "api/c/json_text.h"
#include "api/contents.h"
#include "image/flip.h"
#include "image/read_picture.h"
#include "study/comparison.h"
#include "study/comparison_output.h"

using ajar::c::guarded;
using ajar::c::Json;
using ajar::c::text_for_caller;
using ajar::c::value_of;

namespace {

/// A member of an object, where a value of another type names it.
template <typename T>
T member(const Json& object, const char* name, T otherwise) {
  const auto found = object.find(name);
  if (found == object.end() || found->is_null()) return otherwise;
  try {
    return value_of<T>(*found);
  } catch (const ajar::UsageError& error) {
    throw ajar::UsageError(std::string(name) + ": " + error.what());
  }
}

void check_members(const Json& object, const std::vector<std::string>& names) {
  for (const auto& [name, value] : object.items()) {
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      throw ajar::UsageError(ajar::unknown_name_message("member", name, names));
    }
  }
}

}  // namespace

int ajar_picture_width(const ajar_picture* picture) { return picture->picture.width(); }
int ajar_picture_height(const ajar_picture* picture) { return picture->picture.height(); }

int ajar_picture_layers(const ajar_picture* picture, char** json) {
  return guarded(
      [&] { *json = text_for_caller(ajar::c::json_text(Json(picture->picture.layers()))); });
}

int ajar_picture_pixels(const ajar_picture* picture, const char* layer, int* channels,
                        const float** pixels) {
  return guarded([&] {
    *channels = picture->picture.channels(layer);
    *pixels = picture->picture.pixels(layer).data();
  });
}

int ajar_picture_metadata(const ajar_picture* picture, char** json) {
  return guarded(
      [&] { *json = text_for_caller(ajar::c::json_text(Json(picture->picture.metadata()))); });
}

int ajar_picture_save(const ajar_picture* picture, const char* path, const char* display) {
  return guarded([&] {
    const Json wish = ajar::c::parsed_object(display == nullptr ? "{}" : display);
    check_members(wish, {"exposure", "tone_map"});
    const ajar::v0::Display as{static_cast<float>(member(wish, "exposure", 0.0)),
                               member(wish, "tone_map", std::string("srgb"))};
    picture->picture.save(path, as);
  });
}

int ajar_picture_load(const char* path, ajar_picture** picture) {
  return guarded([&] {
    auto content = std::make_shared<const ajar::Picture>(ajar::read_picture(path));
    *picture = new ajar_picture{ajar::v0::public_picture(std::move(content))};
  });
}

void ajar_picture_free(ajar_picture* picture) { delete picture; }

int ajar_compare(const char* request, char** json) {
  return guarded([&] {
    const Json wish = ajar::c::parsed_object(request);
    check_members(wish, {"reference", "pictures", "metrics", "pixels_per_degree"});
    using Names = std::vector<std::string>;
    const ajar::study::Comparison comparison = ajar::study::compare_files(
        member(wish, "reference", std::string()), member(wish, "pictures", Names()),
        ajar::study::metrics_by_name(member(wish, "metrics", Names())),
        member(wish, "pixels_per_degree", ajar::kFlipPixelsPerDegree));
    *json = text_for_caller(ajar::c::json_text(ajar::study::to_json(comparison)));
  });
}
