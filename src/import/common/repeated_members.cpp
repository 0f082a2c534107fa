#include "import/common/repeated_members.h"

#include "core/printable_text.h"

namespace ajar {

namespace {
constexpr WarningKind kRepeated{Effect::Slight, "members stand twice: one of them counts"};
}  // namespace

void warn_of_repeated_members(const LocatedJson& root, const std::string& which,
                              Warnings& warnings) {
  constexpr std::size_t kMost = 100;
  for (const LocatedJson::Repeated& repeated : root.repeated(kMost)) {
    const std::string name = printable(repeated.name);
    warnings.add(kRepeated, repeated.where,
                 "\"" + name + "\" stands twice in this object: the " + which + " counts", name);
  }
  if (const std::size_t count = root.repeated_count(); count > kMost) {
    warnings.add(kRepeated, root.where(),
                 std::to_string(count - kMost) + " more members stand twice: the " + which +
                     " of each counts");
  }
}

}  // namespace ajar
