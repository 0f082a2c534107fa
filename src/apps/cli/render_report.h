#pragma once
#include <optional>
#include <string>
#include <vector>

#include "session/job/render_job.h"
#include "session/output/output.h"
#include "session/output/stats_json.h"

/// Report of the program at the end of a render.
namespace ajar::cli {

/// Says where a file is if it is not where it should be; true if it is.
bool report_file(const WrittenFile& file);
/// The last line of a render. `preparing`: seconds, of this run; those of the result are of
/// rendering. `denoised_error`: see the function of that name; where the error of the unfiltered
/// picture is a lower bound, so is this one.
std::string end_text(const RenderResult& result, double preparing,
                     const std::optional<double>& denoised_error);
/// Says what exposure was chosen (if `automatic`) or would help, if pictures for the eye are among
/// `outputs`.
void report_exposure(const Picture& picture, const std::vector<std::string>& outputs,
                     const DisplayOptions& display, bool automatic);

}  // namespace ajar::cli
