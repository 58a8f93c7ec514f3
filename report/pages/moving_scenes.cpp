#include "report/pages/demo.h"

#include <cmath>

#include <fmt/format.h>

#include "base/units.h"
#include "report/answers/simulate_scene.h"
#include "report/pages/scene_run.h"

namespace thenar {
namespace {

constexpr Eigen::Index kFilmInstants = 100;  // of each film in a page of several

Json page_link(const char* file, const std::string& name) {
  return {{"type", "text"},
          {"text", "Played with more instants, places, contact forces and energies over time:"},
          {"link", {{"file", file}, {"text", name}}}};
}

/// What the text says of the glass is what the run says.
Json glass_section(const SimulatedScene& glass, MeshTable& meshes) {
  const Mechanism& mechanism = glass.built->scene.mechanism;
  const auto body = static_cast<std::size_t>(body_named(mechanism, "glass"));
  const Eigen::Vector3d com = mechanism.bodies[body].mass.com;
  const auto height = [&](const std::vector<Pose<double>>& X) { return (X[body] * com).z(); };
  const double fallen =
      height(glass.measures.X_WB.front()) - height(glass.measures.X_WB.back());  // [m]
  return section(
      "wine-glass", "Scenes in motion: a wine glass is squeezed out",
      fmt::format(
          "Figure 3 of [Miller2005]: a Barrett hand closes on a wine glass that lies on a table. "
          "Its bowl is tapered and slippery (friction 0.1), so that the fingers squeeze it out; it "
          "rolls, and its centre has fallen by {:.0f} mm at the end. The film can be played, "
          "turned, and saved as a video.",
          fallen / kMm),
      Json::array({run_banner(glass), film_of(glass, kFilmInstants, meshes),
                   page_link(kGlassPage, "The wine glass in full")}));
}

Json pad_series(const std::string& name, const std::vector<PadState>& states) {
  Json force = Json::array(), angle = Json::array();
  for (const PadState& state : states) {
    force.push_back(state.force);
    angle.push_back(state.angle / kDegree);
  }
  return {{"name", name}, {"x", std::move(force)}, {"y", std::move(angle)}, {"style", "both"}};
}

Json thumb_section(const DemoMotion& motion, MeshTable& meshes) {
  return section(
      "thumb-mug", "Scenes in motion: a thumb rolls towards its pad",
      "Figure 8 of [Miller2005]: a thumb meets a mug on its ulnar side, and the grip tightens to "
      "30 N. Muscles balance the force on ideal hinges, so that there the thumb stays as it is. "
      "Where joints give, by capsules around the skewed axes, it rolls towards its pad. Stiffness "
      "of joints is measured in part and assumed in part [ShaftelThumbMcp].",
      Json::array({run_banner(motion.thumb),
                   film_of(motion.thumb, kFilmInstants, meshes),
                   {{"type", "lines"},
                    {"caption",
                     "Angle between the normal of the thumb's pad and the direction to "
                     "the mug, over the force of the grip"},
                    {"x_label", "force [N]"},
                    {"y_label", "angle [deg]"},
                    {"series", Json::array({pad_series("joints that give", motion.pad),
                                            pad_series("pins", motion.pad_on_pins)})}},
                   page_link(kThumbPage, "The thumb on the mug in full")}));
}

/// One line of the chart and its rows of the table.
Json work_series(const std::vector<WorkPoint>& points, SteppingMethod method, Json& rows) {
  Json cpu = Json::array(), error = Json::array(), hints = Json::array();
  const std::string& name = stepping_names()[static_cast<std::size_t>(method)];
  for (const WorkPoint& point : points) {
    if (point.method != method) continue;
    const bool events = method == SteppingMethod::kEvents;
    const std::string setting = events ? fmt::format("tolerance {:g}", point.setting)
                                       : fmt::format("step {:g} ms", 1e3 * point.setting);
    rows.push_back({name, setting, name_of(point.status), point.steps, 1e3 * point.cpu_seconds,
                    point.error / kMm});
    // What was not solved has no point in the chart.
    if (point.status != SceneStatus::kDone) continue;
    cpu.push_back(1e3 * point.cpu_seconds);
    error.push_back(point.error / kMm);
    hints.push_back(setting);
  }
  return {{"name", name}, {"x", cpu}, {"y", error}, {"hints", hints}, {"style", "both"}};
}

Json work_section(const std::vector<WorkPoint>& points) {
  Json rows = Json::array(), series = Json::array();
  for (const SteppingMethod method : {SteppingMethod::kEvents, SteppingMethod::kTimeStepping})
    series.push_back(work_series(points, method, rows));
  return section(
      "work-precision", "Scenes in motion: accuracy over time",
      "A ball rolls off another for 0.25 s without slip; elliptic integrals give where it ends. "
      "The method events keeps the error of its steps below a tolerance by steps of high order; "
      "time-stepping takes steps of a fixed length and is of second order: ten times the work for "
      "a hundredth of the error. Times are of this machine, the least of five runs each.",
      Json::array({{{"type", "lines"},
                    {"caption", "Error of the ball's place at the end, over processor time"},
                    {"x_label", "processor time [ms]"},
                    {"y_label", "error [mm]"},
                    {"log_x", true},
                    {"log_y", true},
                    {"series", std::move(series)}},
                   table_block("Runs of the chart",
                               {{"method", ""},
                                {"setting", ""},
                                {"status", ""},
                                {"steps", "", 0},
                                {"processor time", "ms"},
                                {"error", "mm"}},
                               std::move(rows))}));
}

}  // namespace

Json moving_scene_sections(const DemoMotion& motion, MeshTable& meshes) {
  return Json::array({glass_section(motion.glass, meshes), thumb_section(motion, meshes),
                      work_section(motion.work)});
}

}  // namespace thenar
