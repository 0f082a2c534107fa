#pragma once
#include "study/report/report.h"

namespace ajar {

/// Small picture for lists.
struct Thumbnail {
  int width = 0;
  int height = 0;
  std::vector<float> pixels;  ///< scene-linear RGB
};

/// The image's first layer, averaged down to at most 256 × 256 pixels (never enlarged). Values that
/// are not finite count as black.
Thumbnail make_thumbnail(const ReportImage& image);

}  // namespace ajar
