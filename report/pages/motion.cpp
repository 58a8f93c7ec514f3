
#include <fmt/format.h>

#include "base/units.h"
#include "report/pages/tendons.h"
#include "report/picture/digit_layers.h"
#include "report/picture/skin_layer.h"
#include "report/provenance.h"
#include "report/sweep_axes.h"

namespace thenar {
namespace {

using Eigen::Index;

/// One line a column over time.
Json lines(const std::string& caption, const std::string& label, const Trajectory& trajectory,
           const std::vector<std::string>& names, const Eigen::MatrixXd& values) {
  const Json time = to_json(trajectory.time);
  Json series = Json::array();
  for (Index j = 0; j < values.cols(); ++j)
    series.push_back(curve_json(nth(names, j), time, to_json(values.col(j))));
  return lines_block(caption, "time [s]", label, std::move(series));
}

/// The coordinate axis of the subject's frame that is nearest to the back of the digit: away from
/// where its first bone goes when its first joint flexes.
Eigen::Vector3d dorsal_axis(const TendonDigit& digit) {
  const TendonModel<double>& model = digit.model;
  const TreeState<double> state =
      pose_tree(model.tree, Eigen::VectorXd::Zero(model.coordinates).eval());
  if (state.empty()) return Eigen::Vector3d::UnitY();
  const Eigen::Vector3d tip = moved(state, model.tip_link, model.tip);
  return nearest_axis((tip - state.front().point).cross(state.front().axis));
}

Json scene(const DigitMotionResult& motion, MeshTable& meshes) {
  constexpr std::size_t kMaxInstants = 48;  // Most instants that are drawn
  const TendonDigit& digit = motion.tendons->digit();
  const Trajectory& trajectory = motion.trajectory;
  const Subject subject = parse_subject(motion.sources.front().text, motion.sources.front().path);
  Json layers = Json::array();
  const auto count = static_cast<std::size_t>(trajectory.time.size());
  for (const std::size_t at : drawn_rows(count, kMaxInstants)) {
    const auto i = static_cast<Index>(at);
    const Eigen::VectorXd q = trajectory.angle.row(i);
    Json bones = bone_layer(digit, q, "#b8a48a");
    bones["name"] = fmt::format("bones at {:.3g} s", trajectory.time[i]);
    Json tendons = tendon_layer(digit, q, fmt::format("tendons at {:.3g} s", trajectory.time[i]),
                                "#cc79a7", false);
    Json skin = skin_layer({subject, digit, pose_tree(digit.model.tree, q)}, meshes);
    for (Json* instant : {&bones, &tendons, &skin}) {
      if (instant->is_null()) continue;
      (*instant)["time"] = trajectory.time[i];
      layers.push_back(std::move(*instant));
    }
  }
  // The path of the tip over all instants.
  Json path = Json::array();
  for (Index i = 0; i < trajectory.tip.rows(); ++i)
    path.push_back(in_mm(trajectory.tip.row(i).transpose()));
  layers.push_back(layer("path of the tip", "#0072b2",
                         Json::array({{{"kind", "line"}, {"positions", path}, {"width", 2}}})));
  return {{"type", "scene"},
          {"caption", "The digit over time: bones, tendons, and the path of its tip"},
          {"up", numbers3(dorsal_axis(digit))},
          {"axes", axis_words(digit.model.tip_axes)},
          {"layers", layers}};
}

Json motion_section(const DigitMotionResult& motion, MeshTable& meshes) {
  const Trajectory& t = motion.trajectory;
  Json blocks =
      Json::array({scene(motion, meshes),
                   lines("Angles of the joints", "angle [deg]", t, t.joints, t.angle / kDegree),
                   lines("Position of the fingertip in the subject's frame", "position [mm]", t,
                         {"x", "y", "z"}, 1e3 * t.tip)});
  std::string text = "Fidelity: " + describe(t.fidelity) + ".";
  if (!t.warning.empty()) text += "\n\nWarning: " + t.warning + ".";
  return section("motion", "Motion", text, blocks);
}

Json muscle_section(const Trajectory& t) {
  Json blocks =
      Json::array({lines("Tension of the muscles", "tension [N]", t, t.muscles, t.tension),
                   lines("Activation", "activation [1]", t, t.muscles, t.activation),
                   lines("Lengthening of muscle and tendon since the reference posture",
                         "excursion [mm]", t, t.muscles, 1e3 * t.excursion)});
  if (t.fibre.size() > 0)
    blocks.push_back(lines("Length of the fibres over their optimal length", "fibre [1]", t,
                           t.muscles, t.fibre));
  if (!t.slips.isZero(0))
    blocks.push_back(lines("Tension in the slips of the extensor hood", "tension [N]", t,
                           {"central", "radial", "ulnar", "terminal"}, t.slips));
  return section("muscles", "Muscles", "", blocks);
}

Json energy_section(const Trajectory& t) {
  Eigen::MatrixXd energy(t.time.size(), 3);
  energy << (t.energy.array() - t.energy[0]).matrix(), t.work, t.dissipated;
  return section(
      "energy", "Energy",
      fmt::format(
          "The energy gained (of motion, weights, springs and joint stops) is the work of "
          "the tendons less what the joints dissipate. Energy error of the integration: "
          "{:.2g} mJ of {:.4g} mJ total energy exchanged, in {} steps to a tolerance of {:.2g}. "
          "Largest drift of an excursion from the length of its tendon: {}.{}",
          1e3 * t.balance.error, 1e3 * t.balance.turned_over, t.counts.steps, t.tolerance,
          t.drift ? fmt::format("{:.2g} mm", 1e3 * *t.drift) : "not measured",
          t.balance.holds() ? "" : " The error is too large: do not use this motion."),
      Json::array({lines("Energy gained, work of the tendons, and loss in the joints",
                         "energy [mJ]", t, {"gained", "work", "lost"}, 1e3 * energy)}));
}

}  // namespace

Json page_of(const DigitMotionResult& motion) {
  const Trajectory& t = motion.trajectory;
  MeshTable meshes;
  Json sections =
      Json::array({motion_section(motion, meshes), muscle_section(t), energy_section(t)});
  return {{"title", fmt::format("The {} of {} in motion", motion.digit, motion.subject)},
          {"subtitle", describe(t.fidelity)},
          {"provenance", provenance_json(motion.sources, t.fidelity)},
          {"meshes", meshes.json()},
          {"sections", std::move(sections)}};
}

}  // namespace thenar
