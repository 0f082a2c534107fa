#pragma once
#include "post/display.h"

namespace ajar {

/// Value of `--exposure`.
struct Exposure {
  bool automatic = false;  ///< for each picture the one that fits it (`fitting_exposure`)
  float stops = 0.F;       ///< else these
  bool operator==(const Exposure&) const = default;
};

/// Display settings of pictures for the eye.
struct Display {
  ToneMap tone_map = ToneMap::Srgb;
  Exposure exposure;

  DisplayOptions of(const Picture& picture) const;
};

}  // namespace ajar
