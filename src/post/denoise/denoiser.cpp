#include "post/denoise/denoiser.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "core/error.h"
#include "post/denoise/builtin_denoiser.h"
#include "post/denoise/oidn_denoiser.h"

namespace ajar {

namespace {

const std::array<std::string, 4> kNames = {"auto", "oidn", "builtin", "none"};

/// Null, with the reason, if there is none that works.
std::shared_ptr<const Denoiser> find_oidn_denoiser(std::string& why_not) {
  const std::shared_ptr<const OidnLibrary> library = find_oidn(&why_not);
  if (!library) return nullptr;
  try {
    return std::make_shared<OidnDenoiser>(library);
  } catch (const std::runtime_error& error) {
    why_not = error.what();
    return nullptr;
  }
}

}  // namespace

std::vector<float> finite_values(std::span<const float> values) {
  std::vector<float> result(values.begin(), values.end());
  std::replace_if(
      result.begin(), result.end(), [](float value) { return !std::isfinite(value); }, 0.F);
  return result;
}

std::span<const std::string> denoiser_names() { return kNames; }

std::shared_ptr<const Denoiser> find_denoiser(const std::string& name, std::string* note) {
  if (name == "none") return nullptr;
  if (name == "builtin") return std::make_shared<BuiltinDenoiser>();
  if (name != "auto" && name != "oidn") {
    throw UsageError(unknown_name_message("denoiser", name, kNames));
  }
  std::string why_not;
  std::shared_ptr<const Denoiser> found = find_oidn_denoiser(why_not);
  if (found) return found;
  const std::string complaint =
      "Open Image Denoise 2 is not found" + (why_not.empty() ? "" : " (" + why_not + ")");
  const std::string remedy =
      "./dev setup unpacks it, pip install pyoidn brings it, or AJAR_OIDN names its library";
  if (name == "oidn") throw UsageError(complaint + "; " + remedy);
  if (note != nullptr) {
    *note = complaint + ": the built-in filter takes its place, which leaves more noise; " + remedy;
  }
  return std::make_shared<BuiltinDenoiser>();
}

}  // namespace ajar
