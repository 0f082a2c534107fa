#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/cli/commands.h"
#include "apps/cli/messages.h"
#include "core/error.h"
#include "os/standard_streams.h"
#include "session/options/option_values.h"
#include "study/comparison.h"
#include "study/comparison_output.h"
#include "study/comparison_report.h"

namespace ajar::cli {

int compare(const CompareArguments& arguments) {
  const auto metrics = study::metrics_by_name(parse_list(arguments.metrics));
  const study::Comparison comparison = study::compare_files(arguments.reference, arguments.pictures,
                                                            metrics, arguments.pixels_per_degree);
  for (const std::string& warning : comparison.warnings) print_warning(warning);
  print_result(arguments.json ? study::to_json(comparison).dump(2) + "\n"
                              : study::to_text(comparison));
  if (!arguments.report.empty()) {
    write_report(study::to_report(comparison), arguments.report);
    print_note("the report is " +
               (std::filesystem::path(arguments.report) / "index.html").string());
  }
  return 0;
}

}  // namespace ajar::cli
