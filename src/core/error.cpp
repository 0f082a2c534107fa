#include "core/error.h"

#include <algorithm>
#include <numeric>

namespace ajar {

std::string SourceLocation::to_string() const {
  if (!file) return {};
  std::string text = *file;
  if (line > 0) text.append(":").append(std::to_string(line));
  if (line > 0 && column > 0) text.append(":").append(std::to_string(column));
  return text;
}

std::string located(const SourceLocation& where, const std::string& message) {
  const std::string place = where.to_string();
  return place.empty() ? message : place + ": " + message;
}

namespace {
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitution = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substitution});
    }
  }
  return row[b.size()];
}
}  // namespace

SceneError::SceneError(const SourceLocation& where, const std::string& message)
    : Error(located(where, message)) {}

std::string nearest_name(std::string_view name, std::span<const std::string> valid) {
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(2, name.size() / 2) + 1;
  for (const std::string& candidate : valid) {
    const std::size_t distance = edit_distance(name, candidate);
    if (distance < best_distance) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

std::string unknown_name_message(std::string_view kind, std::string_view name,
                                 std::span<const std::string> valid) {
  std::string text = "unknown " + std::string(kind) + " \"" + std::string(name) + "\"";
  if (const std::string near = nearest_name(name, valid); !near.empty()) {
    text += "; did you mean \"" + near + "\"?";
  } else {
    text += ".";
  }
  if (valid.empty()) return text + " There are none";
  text += " Valid: ";
  for (std::size_t i = 0; i < valid.size(); ++i) text += (i > 0 ? ", " : "") + valid[i];
  return text;
}

}  // namespace ajar
