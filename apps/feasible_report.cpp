#include "apps/feasible_report.h"

#include <fmt/format.h>

#include "base/units.h"
#include "report/json.h"
#include "report/table.h"
#include "tendons/forces/posture_sensitivity.h"

namespace thenar {
namespace {

constexpr double kNoForce = 1e-6;  // below the rounding of what the tendons make [N]

/// What a status means to whoever asked for a force.
std::string meaning(Status status) {
  switch (status) {
    case Status::kSolved:
      return "";
    case Status::kInfeasible:
      return "no tensions make any force this way with every joint in balance";
    case Status::kUnbounded:
      return "the bones alone carry any force this way (a singular posture)";
    case Status::kLimit:
      return "the numerical method reached its limit of steps";
    case Status::kStopped:
      return "stopped";
    case Status::kStalled:
      return "the numerical method gave up";
  }
  return "";
}

std::string status_line(Status status) {
  const std::string words = meaning(status);
  return words.empty() ? "" : fmt::format("{}: {}\n", name_of(status), words);
}

Table vertex_table(const ForceAxes& axes, const FeasibleForceSet& set) {
  Table table{{"vertex", axes.names[0] + "_N", axes.names[1] + "_N", axes.names[2] + "_N"}, {}};
  const Eigen::MatrixX3d vertices = set.vertices * axes.to_world;
  for (Eigen::Index k = 0; k < vertices.rows(); ++k)
    table.rows.push_back(row({{std::to_string(k + 1)}, cells(vertices.row(k), 3)}));
  return table;
}

std::string axis_name(const ForceAxes& axes, std::size_t k) {
  return (k % 2 == 0 ? "+" : "-") + axes.names[k / 2];
}

}  // namespace

Eigen::VectorXd magnitude_change(const DigitAtPosture& at, const ForceAxes& axes,
                                 const MaxTipForce& largest) {
  if (largest.status != Status::kSolved || largest.magnitude < kNoForce || !at.map.empty())
    return {};
  return max_tip_force_gradient(at.statics, at.slopes, largest,
                                axes.name == "tip" ? DirectionFrame::kTip : DirectionFrame::kWorld);
}

WholeSet whole_set(const DigitAtPosture& at, const ForceAxes& axes) {
  WholeSet whole{feasible_force_set(at.statics), {}};
  for (int k = 0; k < 6; ++k)
    whole.along.push_back(
        max_tip_force(at.statics, (k % 2 == 0 ? 1 : -1) * axes.to_world.col(k / 2)));
  return whole;
}

nlohmann::ordered_json json_of(const DigitAtPosture& at, const ForceAxes& axes,
                               const MaxTipForce& largest) {
  nlohmann::ordered_json json{{"status", name_of(largest.status)},
                              {"axes", axes.name},
                              {"force_N", to_json(axes.to_world.transpose() * largest.force)},
                              {"magnitude_N", largest.magnitude},
                              {"certificate",
                               {{"gap_N", largest.check.gap},
                                {"outside_cone_N", largest.check.outside},
                                {"imbalance_N_mm", 1e3 * largest.check.imbalance}}},
                              {"activation", to_json(at.statics.muscles, largest.activation)},
                              {"tension_N", to_json(at.statics.muscles, largest.tension)}};
  const Eigen::VectorXd change = magnitude_change(at, axes, largest);
  if (change.size() > 0) json["magnitude_change_N_per_deg"] = to_json(at.rows, change * kDegree);
  const std::string note = posture_note(at, at.condition, change);
  if (!note.empty()) json["note"] = note;
  return json;
}

nlohmann::ordered_json json_of(const ForceAxes& axes, const WholeSet& whole) {
  const FeasibleForceSet& set = whole.set;
  nlohmann::ordered_json largest;
  for (std::size_t k = 0; k < whole.along.size(); ++k)
    largest[axis_name(axes, k)] = whole.along[k].magnitude;
  return {{"set",
           {{"status", name_of(set.status)},
            {"axes", axes.name},
            {"dimension", set.dimension},
            {"volume", set.volume},
            {"vertices_N", to_json(set.vertices * axes.to_world)},
            {"triangles", to_json(set.triangles)},
            {"excess", set.excess},
            {"imbalance_N_mm", 1e3 * set.imbalance},
            {"carried_by_bones", to_json(set.carried.transpose() * axes.to_world)},
            {"largest_N", largest}}}};
}

std::string text_of(const DigitAtPosture& at, const ForceAxes& axes, const MaxTipForce& largest) {
  if (largest.status != Status::kSolved) return status_line(largest.status) + "\n";
  if (largest.magnitude < kNoForce)
    return "Largest force: none; " + meaning(Status::kInfeasible) + "\n\n";
  const Eigen::Vector3d force = axes.to_world.transpose() * largest.force;
  Table muscles{{"muscle", "activation", "tension_N", "F0_N"}, {}};
  for (Eigen::Index i = 0; i < largest.tension.size(); ++i)
    muscles.rows.push_back({at.statics.muscles[static_cast<std::size_t>(i)],
                            shown(largest.activation[i], 4), shown(largest.tension[i], 2),
                            shown(at.statics.max_tension[i], 2)});
  const Eigen::VectorXd change = magnitude_change(at, axes, largest);
  const std::string note = posture_note(at, at.condition, change);
  std::string text =
      fmt::format("Largest force: {} N along the direction\nas ({}) = ({}) N in {} axes\n",
                  shown(largest.magnitude, 3), fmt::join(axes.names, ", "),
                  fmt::join(cells(force, 3), ", "), axes.name);
  if (change.size() > 0) text += change_line(at, change) + "\n";
  if (!note.empty()) text += "note: " + note + "\n";
  return text + "\n" + aligned(muscles) + "\n";
}

std::string text_of(const ForceAxes& axes, const WholeSet& whole) {
  const FeasibleForceSet& set = whole.set;
  Table along{{"direction", "largest_N", "status"}, {}};
  for (std::size_t k = 0; k < whole.along.size(); ++k)
    along.rows.push_back(
        {axis_name(axes, k), shown(whole.along[k].magnitude, 3), name_of(whole.along[k].status)});
  std::string text =
      fmt::format("All forces the tip can make: dimension {}, volume {:.5g} {}, {} vertices\n",
                  set.dimension, set.volume,
                  set.dimension > 0 ? fmt::format("N^{}", set.dimension) : "(a point)",
                  set.vertices.rows()) +
      status_line(set.status);
  for (Eigen::Index c = 0; c < set.carried.cols(); ++c)
    text += fmt::format(
        "plus any force along ({}), which the bones carry alone; vertices are across it\n",
        fmt::join(cells(axes.to_world.transpose() * set.carried.col(c), 3), ", "));
  return text +
         fmt::format("\nLargest pure force along each of the {} axes\n{}\n", axes.name,
                     aligned(along)) +
         (set.vertices.rows() == 0 ? "" : "Vertices\n" + aligned(vertex_table(axes, set)) + "\n");
}

}  // namespace thenar
