#pragma once
#include <string>

#include "image/film.h"
#include "session/output.h"

namespace ajar {

/// What is wrong with the numbers of a picture, in one sentence; empty if nothing is. A picture is
/// made of single-precision floats: light that is multiplied with a film's scale may be beyond
/// them, and light that is nearly nothing loses its digits there. `picture` is `film` developed
/// with `film_scale`.
std::string range_complaint(const Film& film, const Picture& picture, double film_scale);

}  // namespace ajar
