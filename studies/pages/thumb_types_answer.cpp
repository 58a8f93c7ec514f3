#include "studies/pages/thumb_types_answer.h"

#include <fmt/format.h>

#include "base/units.h"
#include "grasp/quality/robustness.h"

namespace thenar {
namespace {

Json interval_json(int count, int draws) {
  const ConfidenceInterval interval = wilson_interval(count, draws);
  return Json::array({interval.lower, interval.upper});
}

Json row_json(const DhRow& row) {
  return {{"theta_deg", degrees(row.theta)},
          {"d_mm", 1e3 * row.d},
          {"a_mm", 1e3 * row.a},
          {"alpha_deg", degrees(row.alpha)}};
}

Json type_json(const ThumbTypes& types, const ThumbTypeShare& share) {
  Json out{{"type", share.type.index() + 1},
           {"meaning", describe_type(share.type, types.variability.second.toward)},
           {"draws", share.count},
           {"share", static_cast<double>(share.count) / types.draws},
           {"interval_95", interval_json(share.count, types.draws)},
           {"dh", Json::array()}};
  for (std::size_t i = 0; i < share.rows.size(); ++i)
    out["dh"].push_back({{"joint", types.variability.axes[i].joint},
                         {"mean", row_json(share.rows[i].mean)},
                         {"sd", row_json(share.rows[i].sd)}});
  return out;
}

Json axis_json(const AxisVariability& axis) {
  return {{"joint", axis.joint},
          {"along_mm", 1e3 * axis.along},
          {"along_sd_mm", 1e3 * axis.along_sd},
          {"across_sd_mm", 1e3 * axis.across_sd},
          {"tilt_sd_deg", degrees(axis.tilt_sd)},
          {"source", axis.source},
          {"assumed", axis.assumed}};
}

Json order_json(const ThumbTypes& types) {
  return {{"draws", types.flexion_distal},
          {"share", static_cast<double>(types.flexion_distal) / types.draws},
          {"interval_95", interval_json(types.flexion_distal, types.draws)},
          {"share_by_places", types.flexion_distal_by_places},
          {"share_published", kPublishedFlexionDistal},
          {"source", "SantosValeroCuevas2006"}};
}

/// "12.3 +- 4.5"
std::string plus_minus(double mean, double sd) { return shown(mean, 1) + " +- " + shown(sd, 1); }

}  // namespace

OrderedJson json_of(const ThumbTypesResult& result) {
  const ThumbTypes& types = result.types;
  Json out{{"draws", types.draws}, {"seed", result.seed}, {"complete", types.complete}};
  for (const AxisVariability& axis : types.variability.axes)
    out["distribution"].push_back(axis_json(axis));
  if (types.draws == 0) return OrderedJson(out);
  // The order at the MCP joint, the four types, and the ways of all common normals.
  out["mcp_flexion_distal"] = order_json(types);
  for (const ThumbTypeShare& share : types.types) out["types"].push_back(type_json(types, share));
  for (const NormalShares& normal : types.normals)
    out["normals"].push_back({{"first", normal.first},
                              {"second", normal.second},
                              {"distal", normal.toward[0]},
                              {"dorsal", normal.toward[1]},
                              {"radial", normal.toward[2]}});
  return OrderedJson(out);
}

Table share_table(const ThumbTypesResult& result) {
  Table table{{"type", "meaning", "draws", "share_percent", "from_percent", "to_percent"}, {}};
  const ThumbTypes& types = result.types;
  if (types.draws == 0) return table;
  for (const ThumbTypeShare& share : types.types) {
    const ConfidenceInterval interval = wilson_interval(share.count, types.draws);
    table.rows.push_back({fmt::format("{}", share.type.index() + 1),
                          describe_type(share.type, types.variability.second.toward),
                          fmt::format("{}", share.count),
                          shown(100.0 * share.count / types.draws, 1),
                          shown(100 * interval.lower, 1), shown(100 * interval.upper, 1)});
  }
  return table;
}

Table table_of(const ThumbTypesResult& result) {
  Table table{{"type", "joint", "theta_deg", "d_mm", "a_mm", "alpha_deg"}, {}};
  for (const ThumbTypeShare& share : result.types.types)
    for (std::size_t i = 0; i < share.rows.size(); ++i) {
      const auto& [mean, sd] = share.rows[i];
      table.rows.push_back(
          {fmt::format("{}", share.type.index() + 1), result.types.variability.axes[i].joint,
           plus_minus(degrees(mean.theta), degrees(sd.theta)), plus_minus(1e3 * mean.d, 1e3 * sd.d),
           plus_minus(1e3 * mean.a, 1e3 * sd.a),
           plus_minus(degrees(mean.alpha), degrees(sd.alpha))});
    }
  return table;
}

std::string order_words(const ThumbTypesResult& result) {
  const ThumbTypes& types = result.types;
  if (types.draws == 0) return "";
  const ConfidenceInterval interval = wilson_interval(types.flexion_distal, types.draws);
  return fmt::format(
      "MCP flexion axis distal of the abduction axis in {} % ({} .. {}) of {} draws; published: {} "
      "% [SantosValeroCuevas2006]; {} % if places along the bone alone decided",
      shown(100.0 * types.flexion_distal / types.draws, 1), shown(100 * interval.lower, 1),
      shown(100 * interval.upper, 1), types.draws, shown(100 * kPublishedFlexionDistal, 1),
      shown(100 * types.flexion_distal_by_places, 1));
}

std::string assumed_words(const ThumbTypesResult& result) {
  std::string assumed;
  for (const AxisVariability& axis : result.types.variability.axes)
    for (const std::string& key : axis.assumed)
      assumed += (assumed.empty() ? "" : ", ") + axis.joint + " " + key;
  return assumed.empty() ? "" : "Assumed, not measured: " + assumed;
}

std::string text_of(const ThumbTypesResult& result) {
  return titled("Types of thumbs drawn from the spread of their axes", share_table(result)) +
         order_words(result) + "\n" + assumed_words(result) + "\n" +
         titled("\nDenavit-Hartenberg parameters, mean and sd, normals outwards (a >= 0)",
                table_of(result));
}

}  // namespace thenar
