#pragma once
#include <cstdint>
#include <map>
#include <string>

#include "core/method_report.h"
#include "support/render.h"

/// Renders by `selective`.
namespace ajar::test {

/// With four replicates.
RenderOptions selective_options(std::uint64_t samples);
/// A render that is hardly more than its preparation.
Render prepared_render(const Scene& scene, std::uint64_t seed,
                       const std::map<std::string, std::string>& parameters);
/// Report of a render by `selective`.
MethodReport report_of(const Scene& scene, std::uint64_t seed,
                       const std::map<std::string, std::string>& parameters);

}  // namespace ajar::test
