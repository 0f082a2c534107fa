#include "core/warnings.h"

#include <algorithm>
#include <compare>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace ajar {

namespace {

std::size_t index_of(Effect effect) { return static_cast<std::size_t>(effect); }

/// By file, in the order in which files come first, and line; unlocated ones come last.
template <typename T, typename WhereOf>
void sort_by_place(std::vector<T>& list, WhereOf where_of) {
  std::map<std::string, std::size_t> ranks;
  struct Key {
    std::size_t rank;
    int line;
    int column;
    std::size_t index;
    auto operator<=>(const Key&) const = default;
  };
  std::vector<Key> keys;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const SourceLocation& where = where_of(list[i]);
    const std::size_t rank =
        where.file ? ranks.try_emplace(*where.file, ranks.size()).first->second : list.size();
    keys.push_back({rank, where.line, where.column, i});
  }
  std::sort(keys.begin(), keys.end());
  std::vector<T> sorted;
  for (const Key& key : keys) sorted.push_back(std::move(list[key.index]));
  list = std::move(sorted);
}

bool is_earlier(const SourceLocation& a, const SourceLocation& b) {
  if (!a.file || !b.file || *a.file != *b.file) return false;
  return std::tie(a.line, a.column) < std::tie(b.line, b.column);
}

WarningGroup group_of(const Warning& warning) {
  WarningGroup group{.first = warning, .count = 1, .amount = warning.amount, .subjects = {}};
  if (!warning.subject.empty()) group.subjects.push_back(warning.subject);
  return group;
}

void join(std::vector<WarningGroup>& groups, const WarningGroup& more) {
  const auto group = std::find_if(groups.begin(), groups.end(), [&](const WarningGroup& known) {
    return known.first.kind.several == more.first.kind.several;
  });
  if (group == groups.end()) {
    groups.push_back(more);
    return;
  }
  if (is_earlier(more.first.where, group->first.where)) group->first = more.first;
  group->count += more.count;
  group->amount += more.amount;
  group->has_more_subjects |= more.has_more_subjects;
  std::vector<std::string>& subjects = group->subjects;
  for (const std::string& subject : more.subjects) {
    if (std::find(subjects.begin(), subjects.end(), subject) != subjects.end()) continue;
    if (subjects.size() < WarningGroup::kMaxSubjects) {
      subjects.push_back(subject);
    } else {
      group->has_more_subjects = true;
    }
  }
}

template <typename T>
void append(std::vector<T>& list, const std::vector<T>& more, std::size_t most) {
  const std::size_t count = std::min(more.size(), most - std::min(most, list.size()));
  list.insert(list.end(), more.begin(), more.begin() + static_cast<std::ptrdiff_t>(count));
}

}  // namespace

std::string_view name_of(Effect effect) {
  static constexpr std::array<std::string_view, kEffects> kNames = {
      "light", "geometry", "surfaces", "slight effect", "no visible effect"};
  return kNames[index_of(effect)];
}

void Warnings::add(Warning warning) {
  const std::size_t effect = index_of(warning.kind.effect);
  const std::lock_guard lock(mutex_);
  ++counts_[effect];
  join(groups_[effect], group_of(warning));
  if (kept_[effect].size() < most_kept_) kept_[effect].push_back(std::move(warning));
}

void Warnings::add(const WarningKind& kind, const SourceLocation& where, std::string message,
                   std::string subject) {
  add({kind, where, std::move(message), std::move(subject)});
}

void Warnings::add_all(const Warnings& others) {
  const std::scoped_lock lock(mutex_, others.mutex_);
  for (std::size_t effect = 0; effect < kEffects; ++effect) {
    counts_[effect] += others.counts_[effect];
    for (const WarningGroup& group : others.groups_[effect]) join(groups_[effect], group);
    append(kept_[effect], others.kept_[effect], most_kept_);
  }
}

std::size_t Warnings::count() const {
  const std::lock_guard lock(mutex_);
  return std::accumulate(counts_.begin(), counts_.end(), std::size_t{0});
}

std::size_t Warnings::count(Effect effect) const {
  const std::lock_guard lock(mutex_);
  return counts_[index_of(effect)];
}

std::vector<Warning> Warnings::kept() const {
  const std::lock_guard lock(mutex_);
  std::vector<Warning> all;
  for (std::vector<Warning> of_effect : kept_) {
    sort_by_place(of_effect, [](const Warning& w) -> const SourceLocation& { return w.where; });
    append(all, of_effect, most_kept_);
  }
  return all;
}

std::vector<std::string> Warnings::messages() const {
  std::vector<std::string> texts;
  for (const Warning& warning : kept()) texts.push_back(warning.text());
  return texts;
}

std::vector<WarningGroup> Warnings::groups() const {
  const std::lock_guard lock(mutex_);
  std::vector<WarningGroup> all;
  for (std::vector<WarningGroup> of_effect : groups_) {
    sort_by_place(of_effect,
                  [](const WarningGroup& g) -> const SourceLocation& { return g.first.where; });
    append(all, of_effect, kAll);
  }
  return all;
}

}  // namespace ajar
