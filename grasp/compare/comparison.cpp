#include "grasp/compare/comparison.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/lists.h"
#include "base/numbers.h"
#include "grasp/closing/closing_drives.h"
#include "grasp/closing/fingertip_paths.h"
#include "grasp/compare/grasp_type.h"

namespace thenar {
namespace {

/// Finds the largest load of a task over some grasps.
/// @param loads  member of BestGrasp that holds the loads
LoadFound max_load(const std::vector<BestGrasp>& grasps,
                   std::map<std::string, double> BestGrasp::*loads, GraspTask task) {
  LoadFound load;
  // Unknown margins are NaN, which fmax() ignores.
  for (const BestGrasp& grasp : grasps) {
    const auto found = (grasp.*loads).find(name_of(task));
    if (found == (grasp.*loads).end()) continue;
    ++load.total;
    if (!std::isnan(found->second)) ++load.known;
    load.max = std::fmax(load.max, found->second);
  }
  return load;
}

/// Finds the smallest force of some grasps; NaN without grasps.
double min_force(const std::vector<BestGrasp>& grasps, double BestGrasp::*force) {
  double least = kNaN;
  for (const BestGrasp& grasp : grasps) least = std::fmin(least, grasp.*force);
  return least;
}

}  // namespace

std::string load_key(GraspTask task) {
  switch (task) {
    case GraspTask::kHoldWeight:
      return "hold_weights";
    case GraspTask::kPull:
      return "pull_N";
    case GraspTask::kTurn:
      return "turn_Nm";
    case GraspTask::kForceClosure:
      break;
  }
  return "force_closure";
}

std::string structure_key(GraspTask task) {
  std::string key = load_key(task);
  return key.insert(key.rfind('_'), "_with_structure");
}

bool is_kapandji(const HandAbilities& abilities) {
  return abilities.opposition_scale.rfind("Kapandji", 0) == 0;
}

std::optional<std::size_t> count_grasp_types(const HandAbilities& abilities) {
  if (!any_of(abilities.types, is_pinch)) return {};
  return abilities.types.size();
}

double HandOnObject::quantile(double p) const {
  // Linear interpolation between order statistics.
  if (epsilon.size() == 0) return kNaN;
  const double at = p * static_cast<double>(epsilon.size() - 1);
  const auto below = static_cast<Eigen::Index>(std::floor(at));
  const Eigen::Index above = std::min(below + 1, epsilon.size() - 1);
  const double share = at - static_cast<double>(below);
  return (1 - share) * epsilon[below] + share * epsilon[above];
}

LoadFound HandOnObject::load(GraspTask task) const {
  return max_load(best, &BestGrasp::margin, task);
}

LoadFound HandOnObject::load_with_structure(GraspTask task) const {
  return max_load(best, &BestGrasp::with_structure, task);
}

LoadFound HandOnObject::best_hand_epsilon() const {
  LoadFound load;
  load.total = closures;
  load.known = static_cast<int>(hand_epsilon.size());
  if (load.known > 0) load.max = hand_epsilon[hand_epsilon.size() - 1];
  return load;
}

double HandOnObject::min_grasp_force() const {
  return min_force(best, &BestGrasp::min_grasp_force);
}

double HandOnObject::standing_grasp_force() const {
  return min_force(best, &BestGrasp::standing_grasp_force);
}

const HandOnObject* find_cell(const std::vector<HandOnObject>& cells, const std::string& hand,
                              const std::string& object) {
  return find_where(
      cells, [&](const HandOnObject& cell) { return cell.hand == hand && cell.object == object; });
}

double reach_of_digits(const Hand& hand) {
  const HandLayout& layout = hand.layout();
  const Eigen::Matrix3Xd tips = fingertip_positions(hand, open_posture(layout));
  double reach = 0;
  for (Eigen::Index t = 0; t < tips.cols(); ++t)
    reach = std::max(reach, (tips.col(t) - layout.approach.point).norm());
  return reach;
}

BodySpec scaled(BodySpec body, double scale) {
  require(scale > 0 && std::isfinite(scale), "an object's scale must be positive, got {}", scale);
  for (ShapeSpec& shape : body.shapes) {
    shape.size *= scale;
    shape.mesh.vertices *= scale;
    shape.mesh_scale *= scale;
    shape.X_BS.p *= scale;
  }
  // Mass is proportional to the cube of the scale, inertia to its fifth power.
  const double volume = std::pow(scale, 3);
  body.uniform_mass *= volume;
  if (body.mass) {
    body.mass->mass *= volume;
    body.mass->com *= scale;
    body.mass->inertia *= volume * scale * scale;
  }
  return body;
}

}  // namespace thenar
