#include "report/pages/motion.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/units.h"
#include "report/scene/digit_layers.h"

namespace thenar {
namespace {

using Eigen::Index;

Json numbers(const Eigen::VectorXd& values) {
  Json list = Json::array();
  for (Index i = 0; i < values.size(); ++i) list.push_back(values[i]);
  return list;
}

/// One line a column over time.
Json lines(const std::string& caption, const std::string& label, const Trajectory& trajectory,
           const std::vector<std::string>& names, const Eigen::MatrixXd& values) {
  const Json time = numbers(trajectory.time);
  Json series = Json::array();
  for (Index j = 0; j < values.cols(); ++j)
    series.push_back(
        {{"name", names[static_cast<std::size_t>(j)]}, {"x", time}, {"y", numbers(values.col(j))}});
  return {{"type", "lines"},
          {"caption", caption},
          {"x_label", "time [s]"},
          {"y_label", label},
          {"series", series}};
}

/// Instants at equal ways of the tip, the first and the last among them.
std::vector<Index> instants_along(const Eigen::MatrixX3d& tip, int count) {
  Eigen::VectorXd way = Eigen::VectorXd::Zero(tip.rows());
  for (Index i = 1; i < tip.rows(); ++i) way[i] = way[i - 1] + (tip.row(i) - tip.row(i - 1)).norm();
  std::vector<Index> instants{0};
  for (int k = 1; k < count; ++k) {
    const double wanted = way[way.size() - 1] * k / (count - 1) * (1 - 1e-9);
    const Index i = std::lower_bound(way.data(), way.data() + way.size(), wanted) - way.data();
    if (i > instants.back()) instants.push_back(std::min(i, tip.rows() - 1));
  }
  return instants;
}

Json scene(const TendonDigit& digit, const Trajectory& trajectory) {
  constexpr int kShown = 6;
  const std::vector<Index> instants = instants_along(trajectory.tip, kShown);
  Json layers = Json::array();
  for (std::size_t k = 0; k < instants.size(); ++k) {
    const Eigen::VectorXd q = trajectory.angle.row(instants[k]);
    const bool last = k + 1 == instants.size();
    Json bones = bone_layer(digit, q, last ? "#b8a48a" : "#d9cfc0");
    bones["name"] = fmt::format("{:.3g} s", trajectory.time[instants[k]]);
    layers.push_back(bones);
    if (last) layers.push_back(tendon_layer(digit, q, "tendons at the end", "#cc79a7", false));
  }
  Json way = Json::array();
  for (Index i = 0; i < trajectory.tip.rows(); ++i)
    way.push_back(in_mm(trajectory.tip.row(i).transpose()));
  layers.push_back(
      {{"name", "way of the tip"},
       {"color", "#0072b2"},
       {"items", Json::array({{{"kind", "line"}, {"positions", way}, {"width", 2}}})}});
  return {{"type", "scene"},
          {"caption", "The digit at instants that part the way of its tip equally"},
          {"layers", layers}};
}

Json motion_section(const DigitTendons& tendons, const Trajectory& t) {
  Json blocks =
      Json::array({scene(tendons.digit(), t),
                   lines("Angles of the joints", "angle [deg]", t, t.joints, t.angle / kDegree),
                   lines("Place of the tip in the subject's frame", "tip [mm]", t, {"x", "y", "z"},
                         1e3 * t.tip)});
  std::string text = "Fidelity: " + describe(t.fidelity) + ".";
  if (!t.warning.empty()) text += "\n\nTrouble: " + t.warning + ".";
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
      fmt::format("Energy of motion, weights, springs and stops is what tendons put in less what "
                  "joints take out; the integration made {:.2g} mJ of nothing, of {:.4g} mJ turned "
                  "over, in {} steps to a tolerance of {:.2g}.{}",
                  1e3 * t.balance.error, 1e3 * t.balance.turned_over, t.counts.steps, t.tolerance,
                  t.balance.holds() ? "" : " That is too much: do not believe this motion."),
      Json::array({lines("Energy gained, work of the tendons, and loss in the joints",
                         "energy [mJ]", t, {"gained", "work", "lost"}, 1e3 * energy)}));
}

}  // namespace

Json motion_page(const DigitTendons& tendons, const Trajectory& trajectory) {
  return Json::array({motion_section(tendons, trajectory), muscle_section(trajectory),
                      energy_section(trajectory)});
}

}  // namespace thenar
