#pragma once

/// Everything here is in `ajar`. The inner namespace avoids clashes with the library's own names;
/// its number changes when programs must be compiled again.
#ifdef AJAR_IMPLEMENTATION
#define AJAR_INTERFACE v0
#else
#define AJAR_INTERFACE inline v0
#endif
