#include "session/options/display.h"

#include "post/exposure.h"

namespace ajar {

DisplayOptions Display::of(const Picture& picture) const {
  if (!exposure.automatic) return {tone_map, exposure.stops};
  return {tone_map,
          fitting_exposure(shown_layer(picture).pixels, picture.crop.size() + Vec2i(1, 1))};
}

}  // namespace ajar
