#pragma once
#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ajar::pbrt {

/// Names that end, or regain their earlier meaning, at the end of the scope they were defined in.
/// Entering and leaving a scope costs only its own definitions.
template <typename Value>
class ScopedNames {
 public:
  void begin_scope() { marks_.push_back(log_.size()); }
  void end_scope() {
    const std::size_t mark = marks_.back();
    marks_.pop_back();
    while (log_.size() > mark) {
      auto& [name, previous] = log_.back();
      if (previous) {
        names_[name] = std::move(*previous);
      } else {
        names_.erase(name);
      }
      log_.pop_back();
    }
  }
  void set(const std::string& name, Value value) {
    const auto [place, is_new] = names_.try_emplace(name, value);
    if (!marks_.empty())
      log_.emplace_back(name, is_new ? std::nullopt : std::optional<Value>(place->second));
    if (!is_new) place->second = std::move(value);
  }
  const Value* find(const std::string& name) const {
    const auto found = names_.find(name);
    return found == names_.end() ? nullptr : &found->second;
  }
  /// True if the name was given in the innermost scope.
  bool is_from_here(const std::string& name) const {
    if (find(name) == nullptr) return false;
    if (marks_.empty()) return true;
    const auto first = log_.begin() + static_cast<std::ptrdiff_t>(marks_.back());
    return std::any_of(first, log_.end(), [&](const auto& entry) { return entry.first == name; });
  }
  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const auto& entry : names_) result.push_back(entry.first);
    return result;
  }

 private:
  std::map<std::string, Value> names_;
  std::vector<std::pair<std::string, std::optional<Value>>> log_;
  std::vector<std::size_t> marks_;
};

}  // namespace ajar::pbrt
