#include "integrator/make_filter.h"

#include <fmt/format.h>

#include <string>
#include <variant>

namespace ajar {

namespace {
struct Maker {
  Vec2 radius;
  Filter operator()(const desc::BoxFilter&) const { return Filter::box(radius); }
  Filter operator()(const desc::TriangleFilter&) const { return Filter::triangle(radius); }
  Filter operator()(const desc::GaussianFilter& f) const {
    return Filter::gaussian(radius, f.falloff);
  }
  Filter operator()(const desc::MitchellFilter& f) const {
    return Filter::mitchell(radius, f.b, f.c);
  }
  Filter operator()(const desc::SincFilter& f) const { return Filter::sinc(radius, f.lobes); }
};

/// Makes a filter of each kind that is neither zero nor infinite.
struct Allowed {
  std::string operator()(const desc::BoxFilter&) const { return {}; }
  std::string operator()(const desc::TriangleFilter&) const { return {}; }
  std::string operator()(const desc::GaussianFilter& f) const {
    return fmt::format("; its falloff must be above 0, usually 0.5 to 8, and is {:g}", f.falloff);
  }
  std::string operator()(const desc::MitchellFilter& f) const {
    return fmt::format("; B and C are usually 0 to 1, and are {:g} and {:g}", f.b, f.c);
  }
  std::string operator()(const desc::SincFilter& f) const {
    return fmt::format("; its number of lobes must be above 0, usually 1 to 8, and is {:g}",
                       f.lobes);
  }
};
}  // namespace

Filter make_filter(const desc::Filter& description) {
  try {
    return std::visit(Maker{description.radius}, description.node);
  } catch (const SceneError& error) {
    throw SceneError(description.where,
                     fmt::format("{}{}; it reaches {:g} x {:g} pixels, usually 0.5 to 4",
                                 error.what(), std::visit(Allowed{}, description.node),
                                 description.radius.x, description.radius.y));
  }
}

}  // namespace ajar
