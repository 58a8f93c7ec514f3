#include "live/world/hand_tendons.h"

#include <utility>

#include "hand_versions/tendon_hand.h"

namespace thenar {
namespace {

/// Returns true if a list has a strand of the same name and digit: digits share tendons of the
/// wrist.
bool is_drawn(const std::vector<HandTendon>& tendons, const HandTendon& tendon) {
  for (const HandTendon& each : tendons)
    if (each.name == tendon.name && each.digit == tendon.digit) return true;
  return false;
}

}  // namespace

std::vector<HandTendon> hand_tendons(const Hand& hand) {
  std::vector<HandTendon> tendons;
  const auto* pulled = dynamic_cast<const TendonHand*>(&hand);
  if (pulled == nullptr) return tendons;
  // Collect the strands of all digits, each once.
  for (std::size_t d = 0; d < pulled->digits().size(); ++d) {
    const TendonDigit& digit = pulled->digits()[d]->digit();
    const std::string name = digit_name(digit);
    for (StrandPath& path : strand_paths(digit)) {
      HandTendon tendon{std::move(path.name), name, d, std::move(path.nodes)};
      if (!is_drawn(tendons, tendon)) tendons.push_back(std::move(tendon));
    }
  }
  return tendons;
}

std::vector<Eigen::Vector3d> tendon_points(const Hand& hand, const std::vector<HandTendon>& tendons,
                                           const Eigen::VectorXd& q) {
  std::vector<Eigen::Vector3d> points;
  const auto* pulled = dynamic_cast<const TendonHand*>(&hand);
  if (pulled == nullptr) return points;
  // Compute the link poses of every digit.
  std::vector<TreeState<double>> poses;
  for (std::size_t d = 0; d < pulled->digits().size(); ++d) {
    const Eigen::VectorXd own = q(pulled->places()[d].coordinates);
    poses.push_back(pose_tree(pulled->digits()[d]->digit().model.tree, own));
  }
  // Transform the nodes of every tendon.
  for (const HandTendon& tendon : tendons)
    for (const PathNode<double>& node : tendon.nodes)
      points.push_back(moved(poses[tendon.digit_index], node.link, node.p));
  return points;
}

}  // namespace thenar
