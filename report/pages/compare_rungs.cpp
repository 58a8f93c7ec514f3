#include "report/pages/compare_rungs.h"

#include <cmath>

#include <fmt/format.h>

#include "base/units.h"
#include "report/answers/simulate_scene.h"
#include "report/pages/scene_run.h"
#include "report/provenance.h"

namespace thenar {
namespace {

constexpr Eigen::Index kRungInstants = 50;  // instants of each film [1]
constexpr Eigen::Index kCurveInstants = 500;

/// A point for each rung that was solved and is not the finest, whose error is 0.
template <typename Error>
Json error_chart(const RungComparison& comparison, const std::string& caption,
                 const std::string& label, const Error& error_of) {
  // Runs that are refused, and the finest itself, have no error to draw.
  Json series = Json::array();
  for (std::size_t i = 0; i < comparison.runs.size(); ++i) {
    const RungRun& run = comparison.runs[i];
    const double error = error_of(run.error);
    if (i == comparison.finest || !refusal_of(run.scene).empty() || !(error > 0)) continue;
    series.push_back(
        curve_json(run.rung, Json::array({cpu_per_second(run)}), Json::array({error}), "points"));
  }
  return with(lines_block(caption, "processor time per simulated second [s]", label, series),
              {{"log_x", true}, {"log_y", true}});
}

Json rung_table(const RungComparison& comparison) {
  // Times are per simulated second; errors are against the finest.
  Json rows = Json::array();
  for (const RungRun& run : comparison.runs)
    rows.push_back({run.rung, name_of(run.scene.run.status), run.scene.run.cost.unsolved,
                    cpu_per_second(run), 100 * run.error.force_end, 100 * run.error.force_all,
                    run.error.place_end / kMm, run.error.place_largest / kMm,
                    run.error.turn_end / kDegree});
  return table_block("Rungs: processor time per simulated second, and errors",
                     {"rung", "status", "unsolved:0", "time [s]", "forces, end [%]",
                      "forces, all [%]", "places, end [mm]", "places, most [mm]", "turn [deg]:2"},
                     std::move(rows));
}

/// Normal force of one pad over time, a curve for each rung.
Json force_chart(const RungComparison& comparison, std::size_t pad, const std::string& name) {
  const auto curve = [&](const RungRun& run) {
    const std::vector<SceneSample>& samples = run.scene.run.samples;
    return curve_of_each(
        run.rung, spread(static_cast<Eigen::Index>(samples.size()), kCurveInstants),
        [&](Eigen::Index i) { return nth(samples, i).t; },
        [&](Eigen::Index i) { return pad_loads(comparison, nth(samples, i))[pad].force; });
  };
  return lines_block(name, "time [s]", "normal force [N]", list_of_each(comparison.runs, curve));
}

Json rung_banner(const RungComparison& comparison) {
  // A comparison without a sound finest run is not to be used.
  const std::string refusal = refusal_of(comparison);
  if (!refusal.empty()) return banner_block("Do not use this comparison", Json::array({refusal}));
  return used_banner(fmt::format("On the rung {} all contact problems were solved",
                                 comparison.runs[comparison.finest].rung),
                     comparison.outcome.warnings);
}

std::string pad_name(const RungComparison& comparison, std::size_t pad) {
  const std::vector<MechanismBody>& bodies =
      comparison.runs.front().scene.built->scene.mechanism.bodies;
  const auto [a, b] = comparison.pads[pad];
  return nth(bodies, a).name + " - " + nth(bodies, b).name;
}

std::vector<PadLoad> end_loads(const RungComparison& comparison, const RungRun& run) {
  return pad_loads(comparison, run.scene.run.samples.back());
}

}  // namespace

double cpu_per_second(const RungRun& run) {
  return run.scene.run.cost.cpu_seconds / run.scene.run.samples.back().t;
}

std::string finest_words(const RungComparison& comparison) {
  const RungRun& finest = comparison.runs[comparison.finest];
  return fmt::format("Errors are against {}{}", finest.rung,
                     refusal_of(finest.scene).empty() ? "" : ", which was not solved");
}

Table table_of(const RungComparison& comparison) {
  Table table{{"rung", "status", "unsolved", "cpu_s_per_s", "force_error_%", "force_error_all_%",
               "place_mm", "place_largest_mm", "turn_deg"}};
  for (const RungRun& run : comparison.runs) {
    const RungError& error = run.error;
    table.add({run.rung, name_of(run.scene.run.status), std::to_string(run.scene.run.cost.unsolved),
               shown(cpu_per_second(run)), shown(100 * error.force_end),
               shown(100 * error.force_all), shown(error.place_end / kMm),
               shown(error.place_largest / kMm), shown(error.turn_end / kDegree)});
  }
  return table;
}

Table pad_table_of(const RungComparison& comparison) {
  Table table{{"pad", "rung", "force_N", "area_mm2", "sticks_%", "torsion_Nmm"}};
  for (std::size_t pad = 0; pad < comparison.pads.size(); ++pad)
    for (const RungRun& run : comparison.runs) {
      const PadLoad load = end_loads(comparison, run)[pad];
      const bool soft = load.area > 0;
      table.add({pad_name(comparison, pad), run.rung, shown(load.force),
                 soft ? shown(load.area / (kMm * kMm)) : "-", soft ? shown(100 * load.stick) : "-",
                 soft ? shown(std::abs(load.torsion) / kMm) : "-"});
    }
  return table;
}

std::string text_of(const RungComparison& comparison) {
  return fmt::format("{}: {} of {} rungs of pads\n\n", comparison.name, comparison.runs.size(),
                     comparison.outcome.asked) +
         titled(finest_words(comparison) +
                    ": normal forces of all pads at the end and over all instants, bodies other "
                    "than links",
                table_of(comparison)) +
         titled("Pads at the end", pad_table_of(comparison));
}

OrderedJson json_of(const RungComparison& comparison) {
  // Loads of every pad at the end, on every rung.
  OrderedJson runs = OrderedJson::array();
  for (const RungRun& run : comparison.runs) {
    const RungError& error = run.error;
    OrderedJson pads = OrderedJson::array();
    const std::vector<PadLoad> loads = end_loads(comparison, run);
    for (std::size_t pad = 0; pad < loads.size(); ++pad)
      pads.push_back({{"pad", pad_name(comparison, pad)},
                      {"force_N", loads[pad].force},
                      {"area_m2", loads[pad].area},
                      {"stick", loads[pad].stick},
                      {"torsion_Nm", loads[pad].torsion}});
    runs.push_back({{"rung", run.rung},
                    {"status", name_of(run.scene.run.status)},
                    {"unsolved", run.scene.run.cost.unsolved},
                    {"cpu_s_per_simulated_s", number_or_null(cpu_per_second(run))},
                    {"force_error_end", error.force_end},
                    {"force_error_all", error.force_all},
                    {"place_error_end_m", error.place_end},
                    {"place_error_largest_m", error.place_largest},
                    {"turn_error_end_rad", error.turn_end},
                    {"pads", std::move(pads)}});
  }
  // Errors refer to the finest rung, which is named.
  return {{"scene", comparison.name},
          {"asked", comparison.outcome.asked},
          {"finest", comparison.runs[comparison.finest].rung},
          {"runs", std::move(runs)},
          {"warnings", comparison.outcome.warnings}};
}

std::string refusal_of(const RungComparison& comparison) {
  const RungRun& finest = comparison.runs[comparison.finest];
  const std::string refusal = refusal_of(finest.scene);
  return refusal.empty() ? ""
                         : fmt::format("no rung solved everything; {}: {}", finest.rung, refusal);
}

Json page_of(const RungComparison& comparison) {
  const RungRun& finest = comparison.runs[comparison.finest];
  // The cost of each rung, then forces over time, then the motion on every rung.
  Json charts = Json::array(
      {rung_banner(comparison),
       row_block(Json::array(
           {error_chart(comparison, "Error of normal forces at the end", "error of forces [%]",
                        [](const RungError& error) { return 100 * error.force_end; }),
            error_chart(comparison, "Error of positions at the end", "error of positions [mm]",
                        [](const RungError& error) { return error.place_end / kMm; })})),
       rung_table(comparison), table_block("Pads at the end", pad_table_of(comparison))});
  Json sections = Json::array({section(
      "rungs", "What each rung costs",
      fmt::format(
          "{}. {}, which takes {:.3g} s of processor time for each simulated second. "
          "Errors of forces are those of the normal forces of all pads, root of the sum of "
          "squares over that of the finest; positions are those of bodies other than links. "
          "Where a body tumbles, small errors of forces become large errors of positions.",
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
                Json::array({run_banner(run.scene), film_of(run.scene, kRungInstants, meshes)})));
  return {{"title",
           fmt::format("Scene {} on {} rungs of pads", comparison.name, comparison.runs.size())},
          {"provenance", provenance_json(finest.scene.sources)},
          {"meshes", meshes.json()},
          {"sections", std::move(sections)}};
}

}  // namespace thenar
