#include "study/report/report_script.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "study/report/base64.h"

namespace ajar {

namespace {

// Keeps the order in which we write; the page's source is then easier to follow.
using Json = nlohmann::ordered_json;

Json number(double value) {
  if (std::isfinite(value)) return value;
  if (std::isnan(value)) return "NaN";
  return value > 0 ? "Infinity" : "-Infinity";
}

Json image_json(const ReportImage& image, std::size_t index) {
  Json layers = Json::array();
  for (std::size_t i = 0; i < image.layers.size(); ++i) {
    layers.push_back({{"name", image.layers[i].name},
                      {"channels", image.layers[i].channels},
                      {"file", layer_file(index, i)}});
  }
  Json metadata = Json::array();
  for (const auto& [key, value] : image.metadata) metadata.push_back(Json::array({key, value}));
  Json metrics = Json::object();
  for (const auto& [name, value] : image.metrics) metrics[name] = number(value);
  return {{"name", image.name},     {"width", image.width},
          {"height", image.height}, {"thumbnail", thumbnail_file(index)},
          {"layers", layers},       {"metadata", metadata},
          {"metrics", metrics}};
}

std::string ascii(const Json& json) {
  return json.dump(-1, ' ', true, nlohmann::detail::error_handler_t::replace);
}

}  // namespace

std::string layer_file(std::size_t image, std::size_t layer) {
  return std::to_string(image) + "-" + std::to_string(layer) + ".js";
}

std::string thumbnail_file(std::size_t image) { return std::to_string(image) + ".jpg"; }

std::string layer_script(std::size_t image, std::size_t layer, std::span<const std::byte> packed) {
  return "ajar.receive(\"" + layer_file(image, layer) + "\",\"" + base64(packed) + "\");\n";
}

std::string report_script(const Report& report, const ReportSize& size) {
  Json json{{"title", report.title}};
  json["images"] = Json::array();
  for (std::size_t i = 0; i < report.images.size(); ++i) {
    json["images"].push_back(image_json(report.images[i], i));
  }
  json["reference"] = report.reference ? Json(*report.reference) : Json(nullptr);
  json["metrics"] = Json::array();
  for (const ReportMetric& metric : report.metrics) {
    json["metrics"].push_back({{"name", metric.name},
                               {"description", metric.description},
                               {"moreIsBetter", metric.more_is_better}});
  }
  json["tables"] = Json::array();
  for (const ReportTable& table : report.tables) {
    json["tables"].push_back(
        {{"title", table.title}, {"header", table.header}, {"rows", table.rows}});
  }
  json["notes"] = report.notes;
  json["size"] = {{"page", size.page}, {"data", size.data}};
  return "ajar.report(" + ascii(json) + ");\n";
}

}  // namespace ajar
