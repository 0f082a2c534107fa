#pragma once
#include <set>
#include <string>

namespace ajar::bench {

/// The first `columns` columns of the lines of a CSV file: keys of the finished measurements. Texts
/// in double quotes may have commas. None if there is no file.
std::set<std::string> csv_keys(const std::string& path, int columns);

/// Begins a file with that header, unless there is one.
void begin_csv(const std::string& path, const std::string& header);

}  // namespace ajar::bench
