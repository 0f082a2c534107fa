#include "import/tungsten/transmittance.h"

#include <algorithm>
#include <vector>

namespace ajar::tungsten {
namespace {

constexpr WarningKind kTransmittance{Effect::Surface,
                                     "media do not fade exponentially, which is not supported"};

/// Source: Tungsten, src/core/transmittances.
struct TransmittanceType {
  std::string_view name;
  std::vector<std::string_view> members;
};
const std::vector<TransmittanceType> kTransmittances = {
    {"exponential", {}},
    {"double_exponential", {"sigma_a", "sigma_b"}},
    {"quadratic", {"max_t"}},
    {"linear", {"max_t"}},
    {"erlang", {"rate"}},
    {"davis", {"alpha"}},
    {"davis_weinstein", {"h", "c"}},
    {"pulse", {"min", "max", "num_pulses"}},
    {"interpolated", {"tr_a", "tr_b", "ratio"}}};

/// Its type, if that is known; its members, and those of its parts, are checked.
const TransmittanceType* known_type(const Context& context, const LocatedJson& json) {
  if (!json.is(LocatedJson::Kind::Object)) return nullptr;
  const ObjectReader object(context, json, "a transmittance");
  object.accept({"name"});
  const std::string name = object.text("type").value_or("");
  const auto type =
      std::find_if(kTransmittances.begin(), kTransmittances.end(),
                   [&](const TransmittanceType& known) { return known.name == name; });
  if (type == kTransmittances.end()) return nullptr;
  object.accept(type->members);
  object.report_unknown();
  for (const char* part : {"tr_a", "tr_b"}) {
    if (const auto found = json.find(part)) known_type(context, *found);
  }
  return &*type;
}

}  // namespace

void check_transmittance(const Context& context, const LocatedJson& json) {
  const TransmittanceType* type = known_type(context, json);
  if (type == &kTransmittances.front()) return;
  std::string message = "only exponential transmittance is supported: it stands in";
  if (const std::string name = type_of(json); type == nullptr && !name.empty()) {
    std::vector<std::string> names;
    names.reserve(kTransmittances.size());
    for (const TransmittanceType& known : kTransmittances) names.emplace_back(known.name);
    message = unknown_name_message("transmittance", printable(name), names) +
              ". An exponential one stands in";
  }
  context.warnings.add(kTransmittance, json.where(), message);
}

}  // namespace ajar::tungsten
