#include "core/warning_digest.h"

#include <algorithm>
#include <utility>

namespace ajar {

namespace {

/// "7 triangles have no area, in 2 meshes".
std::string several(const WarningGroup& group) {
  const WarningKind& kind = group.first.kind;
  std::string text = std::to_string(group.amount) + " " + std::string(kind.several);
  if (!kind.holders.empty()) {
    text += ", in " + std::to_string(group.count) + " " + std::string(kind.holders);
  }
  return text;
}

std::string examples(const WarningGroup& group) {
  std::string text;
  for (const std::string& subject : group.subjects) text += (text.empty() ? "" : ", ") + subject;
  if (group.has_more_subjects) text += ", …";
  return text;
}

/// A warning that is alone says all that it has to say.
std::string line_of(const WarningGroup& group) {
  if (group.count == 1) return group.first.text();
  const std::string names = examples(group);
  return located(group.first.where, several(group) + (names.empty() ? "" : ": " + names));
}

/// Without examples.
std::string short_text(const WarningGroup& group) {
  if (group.count == 1) return group.first.text();
  const std::string place = group.first.where.to_string();
  return several(group) + (place.empty() ? "" : " (" + place + ")");
}

std::string join(const std::vector<WarningGroup>& groups) {
  std::string text;
  for (const WarningGroup& group : groups) text += (text.empty() ? "" : "; ") + short_text(group);
  return text;
}

}  // namespace

WarningDigest digest(const Warnings& warnings, std::size_t most_lines,
                     const std::string& where_all) {
  std::array<std::vector<WarningGroup>, kEffects> by_effect;
  std::vector<WarningGroup> all_groups = warnings.groups();
  const bool told_one_by_one = warnings.count() == all_groups.size();
  for (WarningGroup& group : all_groups) {
    by_effect[static_cast<std::size_t>(group.first.kind.effect)].push_back(std::move(group));
  }
  const std::vector<WarningGroup> unseen = std::move(by_effect.back());
  by_effect.back().clear();

  std::size_t count = 0;
  for (const auto& groups : by_effect) count += groups.size();
  std::array<bool, kEffects> shares{};
  for (std::size_t i = kEffects; i-- > 0 && count > most_lines;) {
    shares[i] = by_effect[i].size() > 1;
    if (shares[i]) count -= by_effect[i].size() - 1;
  }

  WarningDigest result;
  for (std::size_t i = 0; i < kEffects; ++i) {
    if (shares[i]) {
      result.lines.push_back(join(by_effect[i]));
      continue;
    }
    for (const WarningGroup& group : by_effect[i]) result.lines.push_back(line_of(group));
  }
  std::string all;
  if (!told_one_by_one && !where_all.empty()) {
    all = where_all + " lists all " + std::to_string(warnings.count()) + " warnings";
  }
  if (!unseen.empty()) {
    result.note =
        "without visible effect: " + (unseen.size() == 1 ? line_of(unseen.front()) : join(unseen)) +
        (all.empty() ? "" : "; " + all);
  } else {
    result.note = all;
  }
  return result;
}

}  // namespace ajar
