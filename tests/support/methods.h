#pragma once
#include <map>
#include <string>
#include <vector>

namespace ajar::test {

/// Names of all methods but those that are `excused`, each with the reason. Whoever adds a method
/// has it tested. Raises std::logic_error for the excuse of a method that is no more.
std::vector<std::string> methods_but(const std::map<std::string, std::string>& excused);
bool has_chains(const std::string& method);
/// Excuses for all methods without chains.
std::map<std::string, std::string> those_without_chains(const std::string& reason);

bool has_parameter(const std::string& method, const std::string& parameter);
/// Valid name for GoogleTest.
std::string name_for_tests(std::string method);

}  // namespace ajar::test
