#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/warnings.h"
#include "import/common/file_access.h"
#include "import/pbrt/spectra.h"
#include "scene/desc/scene_desc.h"

namespace ajar::pbrt {

/// What every part of the importer works with.
struct Context {
  desc::SceneDesc& scene;
  Warnings& warnings;
  FileAccess& files;
  SpectrumReader& spectra;
};

/// The error for a type of thing that pbrt-v3 does not have; says so if pbrt-v4 does.
[[noreturn]] void fail_unknown(const SourceLocation& where, std::string_view what,
                               std::string_view name, const std::vector<std::string>& valid);

}  // namespace ajar::pbrt
