#include "grasp/compare/abilities.h"

namespace thenar {
namespace {

Eigen::VectorXd middle_posture(const HandLayout& layout) {
  return (layout.lower + layout.upper) / 2;
}

}  // namespace

HandAbilities hand_abilities(const ComparedHand& hand, const CompareOptions& options,
                             const Progress& progress) {
  std::mt19937 random(options.seed);
  HandAbilities abilities;
  abilities.hand = hand.name;
  abilities.reach = reach_of_digits(*hand.hand);
  // Workspaces first: all draws come from one generator, in a fixed order.
  Workspaces spaces =
      workspaces(*hand.hand, options.workspace_draws, options.workspace_voxel, random, progress);
  abilities.overlap = spaces.overlap;
  abilities.digits = std::move(spaces.digits);
  // Tip forces with all joints in the middle of their ranges.
  const Eigen::VectorXd q = middle_posture(hand.hand->layout());
  for (std::size_t tip = 0; tip < abilities.digits.size() && !progress.stop(); ++tip) {
    const TipForces forces = tip_forces(*hand.hand, q, static_cast<int>(tip));
    abilities.digits[tip].closing_force = forces.closing;
    abilities.digits[tip].max_tip_force = forces.largest;
  }
  const Opposition opposed = opposition(hand, random, progress);
  abilities.opposition = opposed.score;
  abilities.opposition_scale = opposed.scale;
  abilities.reached = opposed.reached;
  return abilities;
}

}  // namespace thenar
