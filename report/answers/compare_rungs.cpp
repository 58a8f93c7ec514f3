#include "report/answers/compare_rungs.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.h"
#include "report/answers/simulate_scene.h"

namespace thenar {
namespace {

std::string pad_name(const RungComparison& comparison, std::size_t pad) {
  const std::vector<MechanismBody>& bodies =
      comparison.runs.front().scene.built->scene.mechanism.bodies;
  const auto [a, b] = comparison.pads[pad];
  return bodies[static_cast<std::size_t>(a)].name + " - " +
         bodies[static_cast<std::size_t>(b)].name;
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
               "place_mm", "place_largest_mm", "turn_deg"},
              {}};
  for (const RungRun& run : comparison.runs) {
    const RungError& error = run.error;
    table.rows.push_back({run.rung, name_of(run.scene.run.status),
                          std::to_string(run.scene.run.cost.unsolved), shown(cpu_per_second(run)),
                          shown(100 * error.force_end), shown(100 * error.force_all),
                          shown(error.place_end / kMm), shown(error.place_largest / kMm),
                          shown(error.turn_end / kDegree)});
  }
  return table;
}

Table pad_table_of(const RungComparison& comparison) {
  Table table{{"pad", "rung", "force_N", "area_mm2", "sticks_%", "torsion_Nmm"}, {}};
  for (std::size_t pad = 0; pad < comparison.pads.size(); ++pad)
    for (const RungRun& run : comparison.runs) {
      const PadLoad load = end_loads(comparison, run)[pad];
      const bool soft = load.area > 0;
      table.rows.push_back({pad_name(comparison, pad), run.rung, shown(load.force),
                            soft ? shown(load.area / (kMm * kMm)) : "-",
                            soft ? shown(100 * load.stick) : "-",
                            soft ? shown(std::abs(load.torsion) / kMm) : "-"});
    }
  return table;
}

std::string text_of(const RungComparison& comparison) {
  return fmt::format("{}: {} of {} rungs of pads\n\n", comparison.name, comparison.runs.size(),
                     comparison.asked) +
         titled(finest_words(comparison) +
                    ": normal forces of all pads at the end and over all instants, bodies that "
                    "are no links",
                table_of(comparison)) +
         titled("Pads at the end", pad_table_of(comparison));
}

OrderedJson json_of(const RungComparison& comparison) {
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
  return {{"scene", comparison.name},
          {"asked", comparison.asked},
          {"finest", comparison.runs[comparison.finest].rung},
          {"runs", std::move(runs)},
          {"warnings", warnings_of(comparison)}};
}

std::vector<std::string> warnings_of(const RungComparison& comparison) {
  std::vector<std::string> all = comparison.runs.front().scene.built->warnings;
  for (const RungRun& run : comparison.runs) {
    // Of building it what the first had not, and all of the run.
    for (const std::string& warning : warnings_of(run.scene))
      if (std::find(all.begin(), all.end(), warning) == all.end())
        all.push_back(fmt::format("on {}: {}", run.rung, warning));
    if (const std::string refusal = refusal_of(run.scene); !refusal.empty())
      all.push_back(fmt::format("on {}: {}", run.rung, refusal));
  }
  return all;
}

std::string refusal_of(const RungComparison& comparison) {
  const RungRun& finest = comparison.runs[comparison.finest];
  const std::string refusal = refusal_of(finest.scene);
  return refusal.empty() ? ""
                         : fmt::format("on no rung was all solved; {}: {}", finest.rung, refusal);
}

}  // namespace thenar
