#pragma once

/// The whole interface of the library.
#include "ajar/compare.h"   // IWYU pragma: export
#include "ajar/error.h"     // IWYU pragma: export
#include "ajar/info.h"      // IWYU pragma: export
#include "ajar/picture.h"   // IWYU pragma: export
#include "ajar/render.h"    // IWYU pragma: export
#include "ajar/scene.h"     // IWYU pragma: export
#include "ajar/settings.h"  // IWYU pragma: export
