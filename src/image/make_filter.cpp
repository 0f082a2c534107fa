#include "image/make_filter.h"

#include <variant>

namespace ajar {

namespace {
struct Maker {
  Vec2 radius;
  Filter operator()(const desc::BoxFilter&) const { return Filter::box(radius); }
  Filter operator()(const desc::TriangleFilter&) const { return Filter::triangle(radius); }
  Filter operator()(const desc::GaussianFilter& f) const {
    return Filter::gaussian(radius, f.alpha);
  }
  Filter operator()(const desc::MitchellFilter& f) const {
    return Filter::mitchell(radius, f.b, f.c);
  }
  Filter operator()(const desc::SincFilter& f) const { return Filter::sinc(radius, f.tau); }
};
}  // namespace

Filter make_filter(const desc::Filter& description, const SourceLocation& where) {
  try {
    return std::visit(Maker{description.radius}, description.node);
  } catch (const SceneError& error) {
    throw SceneError(where, error.what());
  }
}

}  // namespace ajar
