#pragma once
#include <cstddef>
#include <span>
#include <string>

#include "study/report/report.h"

namespace ajar {

/// The layer's file beside others in `data/`, made of indices only: names of images never become
/// names of files.
std::string layer_file(std::size_t image, std::size_t layer);
std::string thumbnail_file(std::size_t image);

/// A script that hands a layer's packed pixels (`pack_pixels`) to the page.
std::string layer_script(std::size_t image, std::size_t layer, std::span<const std::byte> packed);

/// A script that hands everything but pixels to the page. ASCII, so that no browser can mistake its
/// encoding; numbers that are not finite are the strings "NaN", "Infinity" and "-Infinity".
std::string report_script(const Report& report, const ReportSize& size);

}  // namespace ajar
