#include "core/inactive_parameters.h"

#include <string>

#include "core/error.h"

namespace ajar {

void refuse_inactive(std::span<const ParameterSpec> specs, const Parameters& parameters) {
  for (const ParameterSpec& spec : specs) {
    if (parameters.matters(spec) || !parameters.given().contains(spec.name)) continue;
    std::string values;
    for (const std::string& value : spec.matters_for) {
      values += (values.empty() ? "" : " or ") + value;
    }
    throw UsageError(spec.name + ": only with " + spec.depends_on + "=" + values + ", not " +
                     spec.depends_on + "=" + parameters.get_text(spec.depends_on));
  }
}

}  // namespace ajar
