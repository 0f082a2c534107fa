#pragma once
#include <string>

#include "study/loaded_picture.h"
#include "study/metric.h"
#include "study/report/report.h"

namespace ajar::study {

/// A picture's file as reports show it: the picture, the file's other layers (without replicates:
/// they are the picture again), and Ajar's metadata of the render. Layers and metadata are read
/// anew from the picture's path. Raises IoError.
ReportImage report_image(const std::string& name, const LoadedPicture& picture);

/// Descriptions of metrics for the page.
std::vector<ReportMetric> report_metrics(const std::vector<const Metric*>& metrics);

}  // namespace ajar::study
