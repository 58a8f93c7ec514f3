#include "apps/tendon_answer.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.h"
#include "report/json.h"
#include "report/table.h"
#include "tendons/forces/posture_sensitivity.h"
#include "tendons/net/band_course.h"

namespace thenar {
namespace {

/// A band of the answer, in display units.
struct BandRow {
  std::string name, from, to, state;
  double length, slack, tension;  // [mm], [mm]; NaN for a muscle, [N]
};

std::vector<BandRow> band_rows(const TendonCase& at, const DigitPoint& point) {
  const Net& net = at.net->net().net;
  const TreeState<double> state = pose_tree(at.bones().model.tree, point.q);
  std::vector<BandRow> rows;
  for (std::size_t k = 0; k < net.bands.size(); ++k) {
    const NetBand& band = net.bands[k];
    const double tension = point.rest.tension[static_cast<Eigen::Index>(k)];
    const bool bent = band_course(net, state, point.rest, static_cast<int>(k)).bent;
    rows.push_back({band.name, net.nodes[static_cast<std::size_t>(band.a)].name,
                    net.nodes[static_cast<std::size_t>(band.b)].name,
                    std::string(tension > kTaut ? "taut" : "slack") + (bent ? ", on bone" : ""),
                    point.rest.length[static_cast<Eigen::Index>(k)] / kMm,
                    band.muscle < 0 ? band.slack / kMm : std::nan(""), tension});
  }
  return rows;
}

/// Terminal per central slip; NaN if the central one is slack.
double slip_ratio(const SlipTension& slips) {
  return slips.central > kTaut ? slips.terminal / slips.central : std::nan("");
}

void add_net(const TendonCase& at, const DigitPoint& point, nlohmann::ordered_json& json) {
  const Net& net = at.net->net().net;
  json["status"] = name_of(point.rest.status);
  json["residual_N"] = point.rest.residual;
  json["iterations"] = point.rest.iterations;
  json["bands"] = nlohmann::json::array();
  for (const BandRow& row : band_rows(at, point))
    json["bands"].push_back(nlohmann::ordered_json{{"name", row.name},
                                                   {"from", row.from},
                                                   {"to", row.to},
                                                   {"length_mm", row.length},
                                                   {"slack_mm", number_or_null(row.slack)},
                                                   {"tension_N", row.tension},
                                                   {"state", row.state}});
  json["nodes"] = nlohmann::json::array();
  for (std::size_t i = 0; i < net.nodes.size(); ++i)
    json["nodes"].push_back(nlohmann::ordered_json{
        {"name", net.nodes[i].name},
        {"floating", net.nodes[i].free},
        {"place_mm", to_json(point.rest.x.col(static_cast<Eigen::Index>(i)) / kMm)}});
  json["contacts"] = nlohmann::json::array();
  for (const NetContact& contact : point.rest.contacts)
    json["contacts"].push_back(nlohmann::ordered_json{
        {"node", net.nodes[static_cast<std::size_t>(contact.node)].name},
        {"surface", net.surfaces[static_cast<std::size_t>(contact.surface)].name},
        {"force_N", contact.force}});
}

void print_net(const TendonCase& at, const DigitPoint& point) {
  const Net& net = at.net->net().net;
  Table bands{{"band", "from", "to", "length_mm", "slack_mm", "tension_N", "state"}, {}};
  for (const BandRow& row : band_rows(at, point))
    bands.rows.push_back({row.name, row.from, row.to, shown(row.length, 3),
                          std::isfinite(row.slack) ? shown(row.slack, 3) : "-",
                          shown(row.tension, 4), row.state});
  fmt::print("{}", titled("Bands", bands));

  Table nodes{{"floating_node", "x_mm", "y_mm", "z_mm"}, {}};
  for (std::size_t i = 0; i < net.nodes.size(); ++i)
    if (net.nodes[i].free)
      nodes.rows.push_back(
          row({{net.nodes[i].name},
               cells((point.rest.x.col(static_cast<Eigen::Index>(i)) / kMm).eval(), 3)}));
  fmt::print("{}", titled("Where the net lies, subject's frame", nodes));

  Table contacts{{"node", "surface", "force_N"}, {}};
  for (const NetContact& contact : point.rest.contacts)
    contacts.rows.push_back({net.nodes[static_cast<std::size_t>(contact.node)].name,
                             net.surfaces[static_cast<std::size_t>(contact.surface)].name,
                             shown(contact.force, 4)});
  fmt::print("{}", titled("Nodes pressed on bone", contacts));
}

}  // namespace

std::string warning_of(const DigitPoint& point) { return point.pull.warning; }

std::string tip_note(const TipForce& tip) {
  constexpr double kNone = 1e-9;  // torque [N m]
  if (tip.rank < std::min<Eigen::Index>(3, tip.tau_residual.size()))
    return tip.tau_residual.cwiseAbs().maxCoeff() < kNone
               ? "singular posture: some force of the tip meets no torque, and the least one is "
                 "told"
               : "singular posture: torques are left that no force of the tip balances, and the "
                 "force of least size is told of all that leave them";
  if (tip.rank < 3)
    return "too few joints: some force of the tip meets no torque, the least is told";
  if (tip.condition < kNearlyStraight) return "";
  return fmt::format(
      "nearly singular posture (condition {:.3g}): the force changes much within a degree",
      tip.condition);
}

Eigen::Vector3d force_in_tip_axes(const TendonCase& at, const DigitPoint& point) {
  const TendonModel<double>& model = at.bones().model;
  Eigen::Matrix3d axes = model.tip_axes;
  if (model.tip_link >= 0)
    axes = pose_tree(model.tree, point.q)[static_cast<std::size_t>(model.tip_link)].X.R * axes;
  return axes.transpose() * point.tip.f_W;
}

nlohmann::ordered_json json_of(const TendonCase& at, const DigitPoint& point) {
  const TendonNames& names = at.bones().names;
  nlohmann::ordered_json json{{"posture_deg", to_json(names.coordinates, point.q / kDegree)}};
  if (at.net != nullptr) add_net(at, point, json);
  if (!warning_of(point).empty()) json["trouble"] = warning_of(point);
  const SlipTension& slips = point.pull.slips;
  json["slips_N"] = {{"central", slips.central},
                     {"radial", slips.radial},
                     {"ulnar", slips.ulnar},
                     {"terminal", slips.terminal}};
  json["terminal_to_central"] = number_or_null(slip_ratio(slips));
  json["torque_N_mm"] = to_json(names.coordinates, point.pull.tau / kNmm);
  for (std::size_t m = 0; m < names.muscles.size(); ++m)
    json["moment_arm_mm"][names.muscles[m]] = to_json(
        names.coordinates, point.pull.R.row(static_cast<Eigen::Index>(m)).transpose() / kMm);
  json["force_N"] = to_json(point.tip.f_W);
  json["force_tip_axes_N"] =
      to_json({"proximal", "dorsal", "radial"}, force_in_tip_axes(at, point));
  json["leftover_torque_N_mm"] = to_json(names.coordinates, point.tip.tau_residual / kNmm);
  json["condition"] = number_or_null(point.tip.condition);
  if (const std::string note = tip_note(point.tip); !note.empty()) json["note"] = note;
  return json;
}

void print_text(const TendonCase& at, const DigitPoint& point) {
  const TendonNames& names = at.bones().names;
  Table posture{names.coordinates, {cells((point.q / kDegree).eval(), 2)}};
  fmt::print("{}", titled("Posture [deg]", posture));
  if (at.net != nullptr) print_net(at, point);

  const SlipTension& slips = point.pull.slips;
  const double ratio = slip_ratio(slips);
  if (at.net != nullptr || at.bones().model.hood)
    fmt::print(
        "{}", titled("Slips of the hood",
                     {{"central_N", "radial_N", "ulnar_N", "terminal_N", "terminal/central"},
                      {{shown(slips.central, 4), shown(slips.radial, 4), shown(slips.ulnar, 4),
                        shown(slips.terminal, 4), std::isfinite(ratio) ? shown(ratio, 4) : "-"}}}));

  Table torque{{"joint", "N_mm", "left_N_mm"}, {}};
  for (std::size_t i = 0; i < names.coordinates.size(); ++i)
    torque.rows.push_back({names.coordinates[i],
                           shown(point.pull.tau[static_cast<Eigen::Index>(i)] / kNmm, 4),
                           shown(point.tip.tau_residual[static_cast<Eigen::Index>(i)] / kNmm, 4)});
  fmt::print(
      "{}",
      titled(
          "Joint torque of all tendons, flexion positive; left: what no force of the tip balances",
          torque));

  Table force{{"axes", "1_N", "2_N", "3_N", "magnitude_N"}, {}};
  const double size = point.tip.f_W.norm();
  force.rows.push_back(row({{"world x y z"}, cells(point.tip.f_W, 4), {shown(size, 4)}}));
  force.rows.push_back(
      row({{"proximal dorsal radial"}, cells(force_in_tip_axes(at, point), 4), {shown(size, 4)}}));
  fmt::print("{}", titled("Force of the tip on the world, hold pinned", force));
  fmt::print("condition: {:.4g}\n", point.tip.condition);
  if (const std::string note = tip_note(point.tip); !note.empty()) fmt::print("note: {}\n", note);
  if (at.net != nullptr)
    fmt::print("net: {}, {:.2g} N out of balance, {} steps\n", name_of(point.rest.status),
               point.rest.residual, point.rest.iterations);
}

}  // namespace thenar
