#include "report/pages/tendons.h"

namespace thenar {
namespace {

/// Paths of a rung in words, where two rungs differ in nothing else.
std::string rung_name(const HoodRung& rung) {
  return rung.name + (rung.path == Path::kWrapped ? ", wrapped" : "");
}

Json error_table(const std::vector<HoodComparison>& comparisons) {
  // Errors over all trials, and over those of muscles of the hood alone.
  Json rows = Json::array();
  for (const HoodComparison& comparison : comparisons)
    for (const HoodRung& rung : comparison.rungs)
      rows.push_back({comparison.experiment, rung_name(rung),
                      rung.prediction.calibrated_on_specimen ? "yes" : "no",
                      rung.prediction.error.relative, rung.hood_muscles.relative,
                      rung.relative_to_finest, 1e6 * rung.seconds, rung.warning.size()});
  return table_block(
      "Errors of predicted fingertip forces, nothing fitted here (the subject may have been "
      "calibrated on the specimen before): of all trials, of those whose muscles pull on the hood "
      "alone, and the distance from the finest rung, each relative to the forces; time for one "
      "posture under one load, a net started where it rests.",
      {"specimen", "hood", "subject has seen it", "error [1]:3", "error, hood muscles [1]:3",
       "off finest [1]:3", "time [\u00b5s]:1", "trials in trouble:0"},
      rows);
}

/// A measure of every rung over its time, one point a rung.
template <typename Measure>
Json time_chart(const HoodComparison& comparison, const std::string& caption,
                const std::string& y_label, Measure measure) {
  // Each model is one point: its error over its cost.
  Json series = Json::array();
  for (const HoodRung& rung : comparison.rungs)
    series.push_back(curve_json(rung_name(rung), Json::array({1e6 * rung.seconds}),
                                Json::array({measure(rung)}), "points"));
  return with(lines_block(caption + " of " + comparison.experiment +
                              " over the time for one posture. Lower left is better.",
                          "time [\u00b5s]", y_label, series),
              {{"log_x", true}});
}

/// Error against the measurements, and distance from the finest rung, for every specimen.
Json time_charts(const std::vector<HoodComparison>& comparisons) {
  Json errors = Json::array(), distances = Json::array();
  for (const HoodComparison& comparison : comparisons) {
    errors.push_back(time_chart(comparison, "Error of the predicted forces", "relative error [1]",
                                [](const HoodRung& r) { return r.prediction.error.relative; }));
    distances.push_back(time_chart(comparison, "Distance from the forces of the finest rung, those",
                                   "off finest [1]",
                                   [](const HoodRung& r) { return r.relative_to_finest; }));
  }
  return {row_block(errors), row_block(distances)};
}

}  // namespace

Json hood_page(const TendonSweepResult& sweep, const std::vector<HoodComparison>& comparisons,
               MeshTable& meshes) {
  Json blocks = joined(net_scenes(sweep, 2, meshes), slip_charts(sweep));
  blocks.push_back(error_table(comparisons));
  return section(
      "hood", "The extensor mechanism as a floating net",
      "The net hangs between bones and muscles, and finds its own shape: how the "
      "extensor's pull is shared between central and terminal slip follows from posture "
      "and geometry. Bands are coloured by tension; slack ones are dashed.\n\n"
      "Below, the same experiments predicted with separate tendons, with fixed fractions, "
      "and with nets.",
      joined(std::move(blocks), time_charts(comparisons)));
}

}  // namespace thenar
