#include "studies/pages/thumb_types_answer.h"

#include <utility>

#include <fmt/format.h>

#include "base/units.h"
#include "grasp/quality/robustness.h"

namespace thenar {
namespace {

// Keys stand in alphabetic order, as in earlier versions.

OrderedJson interval_json(int count, int draws) {
  const ConfidenceInterval interval = wilson_interval(count, draws);
  return OrderedJson::array({interval.lower, interval.upper});
}

Fields row_fields(const DhRow& row) {
  return {{"a", units::kMillimetre, row.a},
          {"alpha", units::kDegree, row.alpha},
          {"d", units::kMillimetre, row.d},
          {"theta", units::kDegree, row.theta}};
}

Fields type_fields(const ThumbTypes& types, const ThumbTypeShare& share) {
  // Mean and sd of the Denavit-Hartenberg parameters of every axis.
  std::vector<Fields> rows;
  for (std::size_t i = 0; i < share.rows.size(); ++i)
    rows.push_back({{"joint", types.variability.axes[i].joint},
                    {"mean", row_fields(share.rows[i].mean)},
                    {"sd", row_fields(share.rows[i].sd)}});
  return {{"dh", std::move(rows)},
          {"draws", share.count},
          {"interval_95", interval_json(share.count, types.draws)},
          {"meaning", describe_type(share.type, types.variability.second.toward)},
          {"share", static_cast<double>(share.count) / types.draws},
          {"type", share.type.index() + 1}};
}

Fields axis_fields(const AxisVariability& axis) {
  return {{"across_sd", units::kMillimetre, axis.across_sd},
          {"along", units::kMillimetre, axis.along},
          {"along_sd", units::kMillimetre, axis.along_sd},
          {"assumed", axis.assumed},
          {"joint", axis.joint},
          {"source", axis.source},
          {"tilt_sd", units::kDegree, axis.tilt_sd}};
}

Fields order_fields(const ThumbTypes& types) {
  return {{"draws", types.flexion_distal},
          {"interval_95", interval_json(types.flexion_distal, types.draws)},
          {"share", static_cast<double>(types.flexion_distal) / types.draws},
          {"share_by_places", types.flexion_distal_by_places},
          {"share_published", kPublishedFlexionDistal},
          {"source", "SantosValeroCuevas2006"}};
}

/// "12.3 +- 4.5"
std::string plus_minus(double mean, double sd) { return shown(mean, 1) + " +- " + shown(sd, 1); }

}  // namespace

Fields fields_of(const ThumbTypesResult& result) {
  // The distribution that was drawn from comes with the shares.
  const ThumbTypes& types = result.types;
  Fields fields{{"complete", types.complete}};
  fields.add_some("distribution", fields_of_each(types.variability.axes, axis_fields));
  fields.add("draws", types.draws);
  if (types.draws == 0) {
    fields.add("seed", result.seed);
    return fields;
  }
  // The order at the MCP joint, the ways of all common normals, and the four types.
  fields.add("mcp_flexion_distal", order_fields(types));
  fields.add_some("normals", fields_of_each(types.normals, [](const NormalShares& normal) {
                    return Fields{{"distal", normal.toward[0]},
                                  {"dorsal", normal.toward[1]},
                                  {"first", normal.first},
                                  {"radial", normal.toward[2]},
                                  {"second", normal.second}};
                  }));
  fields.add("seed", result.seed);
  fields.add("types", fields_of_each(types.types, [&](const ThumbTypeShare& share) {
               return type_fields(types, share);
             }));
  return fields;
}

FileDigests files_of(const ThumbTypesResult& result) {
  return source_digests({result.types.inputs.variability, result.types.inputs.subject});
}

Table share_table(const ThumbTypesResult& result) {
  Table table{{"type", "meaning", "draws", "share_percent", "from_percent", "to_percent"}};
  const ThumbTypes& types = result.types;
  if (types.draws == 0) return table;
  for (const ThumbTypeShare& share : types.types) {
    const ConfidenceInterval interval = wilson_interval(share.count, types.draws);
    table.add({fmt::format("{}", share.type.index() + 1),
               describe_type(share.type, types.variability.second.toward),
               fmt::format("{}", share.count), shown(100.0 * share.count / types.draws, 1),
               shown(100 * interval.lower, 1), shown(100 * interval.upper, 1)});
  }
  return table;
}

Table table_of(const ThumbTypesResult& result) {
  Table table{{"type", "joint", "theta_deg", "d_mm", "a_mm", "alpha_deg"}};
  for (const ThumbTypeShare& share : result.types.types)
    for (std::size_t i = 0; i < share.rows.size(); ++i) {
      const auto& [mean, sd] = share.rows[i];
      table.add({fmt::format("{}", share.type.index() + 1), result.types.variability.axes[i].joint,
                 plus_minus(degrees(mean.theta), degrees(sd.theta)),
                 plus_minus(1e3 * mean.d, 1e3 * sd.d), plus_minus(1e3 * mean.a, 1e3 * sd.a),
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
