#include <cmath>

#include <fmt/format.h>

#include "base/units.h"
#include "report/answers/compare_rungs.h"
#include "report/answers/simulate_scene.h"
#include "report/pages/scene_run.h"
#include "report/provenance.h"

namespace thenar {
namespace {

using Eigen::Index;

constexpr Index kFilmInstants = 50;  // of each film
constexpr Index kCurveInstants = 500;

/// A point for each rung that was solved and is not the finest, whose error is 0.
template <typename Error>
Json error_chart(const RungComparison& comparison, const std::string& caption,
                 const std::string& label, const Error& error_of) {
  Json series = Json::array();
  for (std::size_t i = 0; i < comparison.runs.size(); ++i) {
    const RungRun& run = comparison.runs[i];
    const double error = error_of(run.error);
    if (i == comparison.finest || !refusal_of(run.scene).empty() || !(error > 0)) continue;
    series.push_back({{"name", run.rung},
                      {"x", Json::array({cpu_per_second(run)})},
                      {"y", Json::array({error})},
                      {"style", "points"}});
  }
  Json chart = lines_block(caption, "processor time for a simulated second [s]", label, series);
  chart["log_x"] = chart["log_y"] = true;
  return chart;
}

Json rung_table(const RungComparison& comparison) {
  Json rows = Json::array();
  for (const RungRun& run : comparison.runs)
    rows.push_back({run.rung, name_of(run.scene.run.status), run.scene.run.cost.unsolved,
                    cpu_per_second(run), 100 * run.error.force_end, 100 * run.error.force_all,
                    run.error.place_end / kMm, run.error.place_largest / kMm,
                    run.error.turn_end / kDegree});
  return table_block("Rungs: processor time for a simulated second, and errors",
                     {{"rung", ""},
                      {"status", ""},
                      {"unsolved", "", 0},
                      {"time", "s"},
                      {"forces, end", "%"},
                      {"forces, all", "%"},
                      {"places, end", "mm"},
                      {"places, most", "mm"},
                      {"turn", "deg", 2}},
                     std::move(rows));
}

/// Normal force of one pad over time, a curve for each rung.
Json force_chart(const RungComparison& comparison, std::size_t pad, const std::string& name) {
  Json series = Json::array();
  for (const RungRun& run : comparison.runs) {
    const std::vector<SceneSample>& samples = run.scene.run.samples;
    Json t = Json::array(), force = Json::array();
    for (const Index i : spread(static_cast<Index>(samples.size()), kCurveInstants)) {
      const SceneSample& sample = samples[static_cast<std::size_t>(i)];
      t.push_back(sample.t);
      force.push_back(pad_loads(comparison, sample)[pad].force);
    }
    series.push_back({{"name", run.rung}, {"x", std::move(t)}, {"y", std::move(force)}});
  }
  return lines_block(name, "time [s]", "normal force [N]", std::move(series));
}

Json rung_banner(const RungComparison& comparison) {
  const std::string refusal = refusal_of(comparison);
  const std::vector<std::string> warnings = warnings_of(comparison);
  if (!refusal.empty())
    return {{"type", "banner"},
            {"ok", false},
            {"title", "Do not use this comparison"},
            {"reasons", Json::array({refusal})}};
  return {{"type", "banner"},
          {"ok", true},
          {"caution", !warnings.empty()},
          {"title", fmt::format("On {} all contact problems were solved",
                                comparison.runs[comparison.finest].rung)},
          {"reasons", warnings}};
}

}  // namespace

Json page_of(const RungComparison& comparison) {
  const RungRun& finest = comparison.runs[comparison.finest];
  Json charts = Json::array(
      {rung_banner(comparison),
       row_block(Json::array(
           {error_chart(comparison, "Error of normal forces at the end", "error of forces [%]",
                        [](const RungError& error) { return 100 * error.force_end; }),
            error_chart(comparison, "Error of places at the end", "error of places [mm]",
                        [](const RungError& error) { return error.place_end / kMm; })})),
       rung_table(comparison), table_block("Pads at the end", pad_table_of(comparison))});
  Json sections = Json::array({section(
      "rungs", "What each rung costs",
      fmt::format("{}. {}, which costs {:.3g} s of a processor for a simulated second. Errors of "
                  "forces are those of the normal forces of all pads, root of the sum of squares "
                  "over that of the finest; places are those of bodies that are no links. Where a "
                  "body tumbles, small errors of forces become large ones of places.",
                  finest.scene.description, finest_words(comparison), cpu_per_second(finest)),
      std::move(charts))});
  Json curves = Json::array();
  const Table pads = pad_table_of(comparison);
  for (std::size_t pad = 0; pad < comparison.pads.size(); ++pad)
    curves.push_back(force_chart(comparison, pad, pads.rows[pad * comparison.runs.size()][0]));
  sections.push_back(section("forces", "Forces over time", "", std::move(curves)));
  MeshTable meshes;
  for (const RungRun& run : comparison.runs)
    sections.push_back(
        section("film-" + run.rung, "In motion on " + run.rung, "",
                Json::array({run_banner(run.scene), film_of(run.scene, kFilmInstants, meshes)})));
  return {{"title",
           fmt::format("Scene {} on {} rungs of pads", comparison.name, comparison.runs.size())},
          {"provenance", provenance_json(finest.scene.sources)},
          {"meshes", meshes.json()},
          {"sections", std::move(sections)}};
}

}  // namespace thenar
