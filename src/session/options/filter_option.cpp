#include "session/options/filter_option.h"

#include <algorithm>
#include <array>
#include <vector>

#include "core/error.h"
#include "session/options/option_values.h"

namespace ajar {

desc::Filter parse_filter(const std::string& option, std::string_view text) {
  struct Kind {
    std::string_view name;
    float radius;
    decltype(desc::Filter::node) node;
  };
  static const std::array<Kind, 5> kKinds = {{{"box", 0.5F, desc::BoxFilter{}},
                                              {"triangle", 2.F, desc::TriangleFilter{}},
                                              {"gaussian", 2.F, desc::GaussianFilter{}},
                                              {"mitchell", 2.F, desc::MitchellFilter{}},
                                              {"sinc", 4.F, desc::SincFilter{}}}};
  constexpr Limits<double> kRadius{1e-3, 64.0};
  const std::size_t colon = text.find(':');
  const std::string_view name = text.substr(0, colon);
  const auto* const found = std::find_if(kKinds.begin(), kKinds.end(),
                                         [&](const Kind& kind) { return kind.name == name; });
  if (found == kKinds.end()) {
    std::vector<std::string> names;
    for (const Kind& kind : kKinds) names.emplace_back(kind.name);
    throw UsageError(option + ": " + unknown_name_message("filter", std::string(name), names) +
                     "; as in box or gaussian:1.5");
  }
  desc::Filter filter;
  filter.node = found->node;
  const float radius =
      colon == std::string_view::npos
          ? found->radius
          : static_cast<float>(parse_number(option, text.substr(colon + 1), "pixels", kRadius));
  filter.radius = Vec2(radius, radius);
  return filter;
}

}  // namespace ajar
