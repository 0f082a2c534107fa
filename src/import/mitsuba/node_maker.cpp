#include "import/mitsuba/node_maker.h"

#include <algorithm>

namespace ajar::mitsuba {
namespace {

constexpr WarningKind kOutOfRange{Effect::Surface,
                                  "values are out of range: the nearest ones stand in"};

const ParameterSpec& spec_of(const desc::Node& node, std::string_view name) {
  const std::vector<ParameterSpec>& specs = node.model().parameters;
  return *std::find_if(specs.begin(), specs.end(),
                       [&](const ParameterSpec& spec) { return spec.name == name; });
}

float clamped(const ParameterSpec& spec, float value) {
  constexpr double kLargest = 3e38;
  const double low = std::max(spec.minimum, -kLargest);
  const double high = std::min(spec.maximum, kLargest);
  const double margin = spec.open_range ? 1e-6 * (high - low) : 0.0;
  return static_cast<float>(std::clamp(static_cast<double>(value), low + margin, high - margin));
}

}  // namespace

void set_in_range(Context& context, const SourceLocation& where, desc::Node& node,
                  std::string_view name, desc::Value value) {
  const ParameterSpec& spec = spec_of(node, name);
  const std::optional<std::string> reason = desc::complaint(spec, value);
  if (reason) {
    context.warnings.add(kOutOfRange, where,
                         "\"" + spec.name + "\" " + *reason + ": the nearest value stands in",
                         spec.name);
    if (float* number = std::get_if<float>(&value)) {
      *number = clamped(spec, *number);
    } else if (auto* color = std::get_if<Vec3>(&value)) {
      for (int i = 0; i < 3; ++i) (*color)[i] = clamped(spec, (*color)[i]);
    }
  }
  node.set(name, std::move(value));
}

desc::Node make_node(Context& context, const SourceLocation& where, desc::ModelKind kind,
                     std::string_view name, desc::Node::Given given) {
  desc::Node node = desc::make_node(kind, name);
  for (const auto& [parameter, value] : given) set_in_range(context, where, node, parameter, value);
  return node;
}

}  // namespace ajar::mitsuba
