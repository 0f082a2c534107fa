#pragma once
#include <optional>

#include "core/warnings.h"
#include "image/film.h"
#include "session/output/output.h"

namespace ajar {

/// Warning on the numbers of a picture; empty if there is none. A picture is made of
/// single-precision floats: light that is multiplied with a film's scale may be beyond them, and
/// light that is nearly nothing loses its digits there. `picture` is `film` developed with
/// `film_scale`.
std::optional<Warning> range_complaint(const Film& film, const Picture& picture, double film_scale);

}  // namespace ajar
