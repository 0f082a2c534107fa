#include "integrator/selective/chain_fraction.h"

#include <algorithm>
#include <numeric>

#include "image/pixel_at.h"
#include "integrator/montecarlo/weighted_errors.h"

namespace ajar {

namespace {

/// Pixels across. Over the whole picture, fireflies of the pilot would make the share 100 % of
/// pool.
constexpr int kCell = 16;

struct Cell {
  double light = 0.0;
  double of_chains = 0.0;
  double fraction() const { return light > 0.0 ? std::clamp(of_chains / light, 0.0, 1.0) : 0.0; }
};

/// Scale from sums of contributions to indirect light to pixel values.
DevelopScale scale_of_found(const PilotView& view) {
  const auto layers = view.film.layers();
  const auto indirect = std::find_if(layers.begin(), layers.end(), [](const LayerSpec& layer) {
    return layer.name == "indirect";
  });
  return view.omc.develop_scale(*indirect, view.samples, std::nullopt);
}

}  // namespace

double chain_fraction(const PilotView& view, const Divisions& divisions) {
  const Box2i& crop = view.prepared.config.settings.crop;
  const int width = view.regions().size.x;
  const int columns = (width + kCell - 1) / kCell;
  const int rows = (view.regions().size.y + kCell - 1) / kCell;
  std::vector<Cell> cells(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  const auto cell_at = [&](std::size_t pixel) -> Cell& {
    const int x = static_cast<int>(pixel) % width / kCell;
    const int y = static_cast<int>(pixel) / width / kCell;
    return cells[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
                 static_cast<std::size_t>(x)];
  };
  const std::vector<float> picture = replicate_mean(
      develop_layers(view.film, view.omc, view.samples, {"direct", "indirect", kWeakLayer}));
  for (std::size_t i = 0; 3 * i < picture.size(); ++i) {
    cell_at(i).light += static_cast<double>(
        luminance(Spectrum(picture[3 * i], picture[3 * i + 1], picture[3 * i + 2])));
  }
  const DevelopScale scale = scale_of_found(view);
  const auto lowest = static_cast<float>(view.prepared.lowest_threshold());
  for (const PilotPath& found : view.found) {
    const std::size_t pixel = pixel_at(crop, found.raster);
    Cell& cell = cell_at(pixel);
    const double light = scale.at(pixel) * static_cast<double>(luminance(found.value));
    if (found.whole) continue;
    const float left = divisions.of(found.replicate).omc_fraction(found.strength, found.raster);
    cell.of_chains += light * static_cast<double>((1.F - left) /
                                                  Division::chain_fraction(found.strength, lowest));
  }
  const double sum =
      std::accumulate(cells.begin(), cells.end(), 0.0,
                      [](double s, const Cell& cell) { return s + cell.fraction(); });
  return sum / static_cast<double>(cells.size());
}

}  // namespace ajar
