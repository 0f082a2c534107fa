#pragma once

namespace ajar::bench {

/// Prints how much longer a sample takes with 10 000 emitters than with 10, and how much of the
/// variance of choosing by power is left.
void measure_many_lights();

}  // namespace ajar::bench
