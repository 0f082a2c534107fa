#pragma once
#include <map>
#include <string>
#include <vector>

namespace ajar::test {

/// Names of all methods for users, presets included, but those that are `excused`, each with the
/// reason. New methods are included. Raises std::logic_error for the excuse of an unknown method.
std::vector<std::string> methods_but(const std::map<std::string, std::string>& excused);
bool has_chains(const std::string& method);
/// Excuses for all methods without chains.
std::map<std::string, std::string> those_without_chains(const std::string& reason);

bool has_parameter(const std::string& method, const std::string& parameter);
/// Valid name for GoogleTest.
std::string name_for_tests(std::string method);

}  // namespace ajar::test
