#pragma once
#include <initializer_list>
#include <string_view>
#include <utility>

#include "import/mitsuba/context.h"
#include "scene/desc/models.h"

namespace ajar::mitsuba {

/// A node of our model `name`. Numbers and colours that the model does not allow are clamped to its
/// range, with a warning at `where`.
desc::Node make_node(Context& context, const SourceLocation& where, desc::ModelKind kind,
                     std::string_view name, desc::Node::Given given = {});
/// Sets one parameter in the same way.
void set_in_range(Context& context, const SourceLocation& where, desc::Node& node,
                  std::string_view name, desc::Value value);

}  // namespace ajar::mitsuba
