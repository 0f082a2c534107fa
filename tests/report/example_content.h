#pragma once
#include <vector>

#include "study/report/report.h"

namespace ajar {

/// A report with everything a page can show, made of small computed pictures: a reference and noisy
/// versions of it, one of them with NaN and infinite pixels, one of another size, and names that
/// would break a page which took them for HTML or JavaScript. Always the same.
Report example_report();

/// Report around given images; the first is the reference.
Report example_report_of(std::vector<ReportImage> images);

}  // namespace ajar
