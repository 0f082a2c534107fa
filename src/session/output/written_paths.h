#pragma once
#include <set>
#include <string>
#include <vector>

namespace ajar {

/// Raises UsageError if two of these are the same file, by whatever name or link: one would be
/// lost.
void check_distinct(const std::vector<std::string>& written);
/// Raises UsageError if one of `written` is one of `read`, which it would replace.
void check_spares(const std::vector<std::string>& written, const std::set<std::string>& read);

/// Raises UsageError if something is there: a checkpoint of hours must not make room for the first
/// of another render. `resumed_from`: the one file that may be replaced, since the render goes on
/// with it; may be empty.
void check_new_checkpoint(const std::string& path, const std::string& resumed_from);

}  // namespace ajar
