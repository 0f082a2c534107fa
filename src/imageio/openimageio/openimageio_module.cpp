#include "imageio/openimageio/openimageio_module.h"

#include <dlfcn.h>

#include <array>

#include "imageio/openimageio/module/entry.h"

namespace ajar {

namespace {

decltype(&ajar_open_image_by_openimageio) load_entry() {
  // $ORIGIN is for the loader to fill in: the folder of the program or library that calls it.
  constexpr std::array kPlaces = {"$ORIGIN/libajar_openimageio.so",
                                  "$ORIGIN/../lib/ajar/libajar_openimageio.so",
                                  "libajar_openimageio.so"};
  for (const char* place : kPlaces) {
    if (void* module = dlopen(place, RTLD_NOW | RTLD_LOCAL)) {
      return reinterpret_cast<decltype(&ajar_open_image_by_openimageio)>(
          dlsym(module, "ajar_open_image_by_openimageio"));
    }
  }
  return nullptr;
}

}  // namespace

std::unique_ptr<ImageDecoder> open_with_openimageio(const std::string& path,
                                                    bool has_unassociated_alpha) {
  static const auto entry = load_entry();
  if (entry == nullptr) return nullptr;
  return std::unique_ptr<ImageDecoder>(entry(path.c_str(), has_unassociated_alpha));
}

}  // namespace ajar
