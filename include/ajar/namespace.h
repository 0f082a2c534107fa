#pragma once

/// Everything here is in `ajar`. The inner namespace keeps it apart from what the library itself
/// calls by the same names; its number changes when programs must be compiled again.
#ifdef AJAR_IMPLEMENTATION
#define AJAR_INTERFACE v0
#else
#define AJAR_INTERFACE inline v0
#endif
