#include "studies/demo/demo.h"

#include <fmt/format.h>

#include "base/units.h"
#include "report/pages/scene_run.h"
#include "studies/demo/demo_findings.h"

namespace thenar {
namespace {

Json pad_series(const std::string& name, const std::vector<PadState>& states) {
  const auto angle = [](const PadState& state) { return state.angle / kDegree; };
  return curve_of_each(name, states, &PadState::force, angle, "both");
}

/// The angle of the pad over the force of the grip.
Json pad_chart(const DemoMotion& motion) {
  return lines_block(
      "Angle between the normal of the thumb's pad and the direction to the mug, over the force of "
      "the grip",
      "force [N]", "angle [deg]",
      Json::array(
          {pad_series("joints that give", motion.pad), pad_series("pins", motion.pad_on_pins)}));
}

Json pad_section(const DemoMotion& motion) {
  return section(
      "pad-angle", "How the pad turns",
      "On ideal hinges the muscles balance the force, and the thumb stays as it is. Where the "
      "joints give way within capsules around their skewed axes, it rolls towards its pad. Joint "
      "stiffness is partly measured and partly assumed [ShaftelThumbMcp].",
      Json::array({pad_chart(motion)}));
}

/// One line of the chart and its rows of the table.
Json work_series(const std::vector<WorkPoint>& points, SteppingMethod method, Json& rows) {
  // One point per setting: processor time [ms] and error [mm].
  Json cpu = Json::array(), error = Json::array(), hints = Json::array();
  const std::string name = name_in(kSteppingMethodNames, method);
  for (const WorkPoint& point : points) {
    if (point.method != method) continue;
    const bool events = method == SteppingMethod::kEvents;
    const std::string setting = events ? fmt::format("tolerance {:g}", point.setting)
                                       : fmt::format("step {:g} ms", 1e3 * point.setting);
    rows.push_back({name, setting, name_of(point.status), point.steps, 1e3 * point.cpu_seconds,
                    point.error / kMm});
    // Runs that were not solved have no point in the chart.
    if (point.status != SceneStatus::kDone && point.status != SceneStatus::kUnbalanced) continue;
    cpu.push_back(1e3 * point.cpu_seconds);
    error.push_back(point.error / kMm);
    hints.push_back(setting);
  }
  return with(curve_json(name, cpu, error, "both"), {{"hints", hints}});
}

Json work_section(const std::vector<WorkPoint>& points) {
  // Events choose their steps by a tolerance, time-stepping takes them as given.
  Json rows = Json::array(), series = Json::array();
  for (const SteppingMethod method : {SteppingMethod::kEvents, SteppingMethod::kTimeStepping})
    series.push_back(work_series(points, method, rows));
  return section(
      "work-precision", "Accuracy over time",
      "A ball rolls off another for 0.25 s without slip; elliptic integrals give where it ends. "
      "The method \"events\" keeps the error of each step below a tolerance, with steps of high "
      "order; \"time-stepping\" takes steps of a fixed length and is of second order: ten times "
      "the work for a hundredth of the error. Times were measured on this machine, each the least "
      "of five runs.",
      Json::array({with(lines_block("Error of the ball's place at the end, over processor time",
                                    "processor time [ms]", "error [mm]", std::move(series)),
                        {{"log_x", true}, {"log_y", true}}),
                   table_block("Runs of the chart",
                               {"method", "setting", "status", "steps:0", "processor time [ms]",
                                "error [mm]"},
                               std::move(rows))}));
}

}  // namespace

std::vector<SetPage> moving_scene_pages(const DemoMotion& motion) {
  const char* const title = "How accurate is a motion in steps?";
  SetPage thumb = page_for("thumb_mug.html", "A thumb rolls onto its pad",
                           thumb_mug_finding(motion), page_of(motion.thumb), "");
  thumb.page["sections"].insert(thumb.page["sections"].begin(), pad_section(motion));
  thumb.figure = pad_chart(motion);
  return {page_for("wine_glass.html", "A wine glass is squeezed out", glass_finding(motion.glass),
                   page_of(motion.glass), "scene"),
          std::move(thumb),
          page_for("stepping.html", title, stepping_finding(motion.work),
                   {{"title", title}, {"sections", Json::array({work_section(motion.work)})}}, "")};
}

}  // namespace thenar
