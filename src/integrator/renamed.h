#pragma once
#include <map>
#include <string>

/// Names of version 0.2 that 0.3 has no more: whoever uses one is told the new one (CHANGELOG.md,
/// "Upgrading from 0.2").
namespace ajar {

/// Raises UsageError if that was the name of an integrator.
void refuse_renamed_integrator(const std::string& name);

/// Raises UsageError if one of these was a parameter, or the value of one, of `selective`.
void refuse_renamed_parameters(const std::map<std::string, std::string>& given);

}  // namespace ajar
