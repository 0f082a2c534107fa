#include "core/error.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <utility>
#include <vector>

namespace ajar {

std::string SourceLocation::to_string() const {
  if (!file) return {};
  std::string text = *file;
  if (line > 0) text.append(":").append(std::to_string(line));
  if (line > 0 && column > 0) text.append(":").append(std::to_string(column));
  if (part) text += *part;
  return text;
}

std::string located(const SourceLocation& where, const std::string& message) {
  const std::string place = where.to_string();
  return place.empty() ? message : place + ": " + message;
}

namespace {
char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

/// Letters left out, put in, changed, or swapped with the next one; capitals are no difference.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  const auto same = [&](std::size_t i, std::size_t j) { return lower(a[i]) == lower(b[j]); };
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(before_last, last);
    std::swap(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] =
          std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same(i - 1, j - 1) ? 0U : 1U)});
      if (i > 1 && j > 1 && same(i - 1, j - 2) && same(i - 2, j - 1)) {
        row[j] = std::min(row[j], before_last[j - 2] + 1);
      }
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
