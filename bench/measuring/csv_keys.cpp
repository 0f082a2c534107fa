#include "measuring/csv_keys.h"

#include <filesystem>
#include <fstream>

namespace ajar::bench {

namespace {

std::string first_columns(const std::string& line, int columns) {
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') quoted = !quoted;
    if (line[i] == ',' && !quoted && --columns == 0) return line.substr(0, i);
  }
  return line;
}

}  // namespace

std::set<std::string> csv_keys(const std::string& path, int columns) {
  std::set<std::string> keys;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) keys.insert(first_columns(line, columns));
  return keys;
}

void begin_csv(const std::string& path, const std::string& header) {
  if (!std::filesystem::exists(path)) std::ofstream(path) << header << '\n';
}

}  // namespace ajar::bench
