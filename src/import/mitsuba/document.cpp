#include "import/mitsuba/document.h"

#include "core/printable_text.h"

namespace ajar::mitsuba {

const Element& Document::resolve(const Child& child) const {
  if (child.element) return *child.element;
  const auto found = by_id.find(child.id);
  if (found != by_id.end()) return *found->second;
  std::vector<std::string> valid;
  for (const auto& entry : by_id) valid.push_back(entry.first);
  throw SceneError(child.where, unknown_name_message("id", printable(child.id), valid));
}

}  // namespace ajar::mitsuba
