#include "support/methods.h"

#include <algorithm>
#include <stdexcept>

#include "integrator/integrator.h"

namespace ajar::test {

std::vector<std::string> methods_but(const std::map<std::string, std::string>& excused) {
  std::vector<std::string> names;
  for (const IntegratorInfo& info : integrators()) names.push_back(info.name);
  for (const auto& [name, reason] : excused) {
    if (std::erase(names, name) == 0) throw std::logic_error("there is no method " + name);
  }
  return names;
}

std::map<std::string, std::string> those_without_chains(const std::string& reason) {
  std::map<std::string, std::string> excused;
  for (const std::string& name : methods_but({})) {
    if (!has_chains(name)) excused.emplace(name, reason);
  }
  return excused;
}

bool has_chains(const std::string& method) {
  return has_parameter(method, "chain") || has_parameter(method, "chains");
}

bool has_parameter(const std::string& method, const std::string& parameter) {
  const std::vector<ParameterSpec>& specs = find_integrator(method).parameters;
  return std::any_of(specs.begin(), specs.end(),
                     [&](const ParameterSpec& spec) { return spec.name == parameter; });
}

std::string name_for_tests(std::string method) {
  std::replace(method.begin(), method.end(), '+', '_');
  return method;
}

}  // namespace ajar::test
