#pragma once
#include "study/comparison.h"
#include "study/report/report.h"

namespace ajar::study {

/// Report of `ajar compare --report`: the reference first, then the pictures in their order, their
/// metrics, and the tests for bias. Reads the files' layers anew; raises IoError.
Report to_report(const Comparison& comparison);

}  // namespace ajar::study
