#pragma once

/// Abilities of hands without an object: workspaces, tip forces, opposition.

#include <random>

#include "grasp/compare/comparison.h"

namespace thenar {

/// Computes all of HandAbilities but `types`. Samples postures uniformly within limits from a
/// generator with options.seed. A stopped computation leaves nothing of use.
[[nodiscard]] HandAbilities hand_abilities(const ComparedHand& hand, const CompareOptions& options,
                                           const Progress& progress = {});

/// Workspaces of the tips: postures are sampled and the tips counted in voxels of a grid. A tip
/// that moves in fewer than three dimensions (principal extent below two voxels) is measured in
/// these only. The estimate is the number of voxels met less half of those at the rim (with a
/// neighbour not met), +- that half. Of voxels of 1/4, 1/2, 1, 2 and 4 times `voxel`, the size with
/// the smallest relative error serves each tip: large voxels have a thick rim, small ones holes.
struct Workspaces {
  std::vector<DigitAbility> digits;  // without forces
  double overlap =
      0;  // of the thumb's (or first digit's) with all others', voxels of 2 `voxel` [m^3]
};
/// @param draws  number of postures;  @param voxel  edge [m]
[[nodiscard]] Workspaces workspaces(const Hand& hand, int draws, double voxel, std::mt19937& random,
                                    const Progress& progress = {});

/// Largest tip forces at a posture within the actuation of the hand and its joint limits:
///   max d'f  over  L f = B u + R r + tau_0,  f = J s,  lower <= u <= upper,
///   L = J' + sum J_o' c_o c'
/// for the joints that move the tip, J (3, joints) [m/rad]; c is the tip's unit direction in
/// closing, and o are other tips that a closing coordinate moves with it: these meet the same force
/// c'f along their own directions c_o. So jaws of one motor pinch with half of its effort each, 2 r
/// f = u. A tendon over several joints of one digit, DriveCoupling::kCompliant, balances f at all
/// of them.
///
/// Left out are forces that structure supports without effort (J'f = 0), and joints that are locked
/// or, nearer to the base than the outermost non-backdrivable one, bear what it presses: see
/// hand_forces(). NaN: an effort that matters is unknown.
struct TipForces {
  double closing = 0;  // largest force along the tip's direction in closing: pressing force [N]
  double largest = 0;  // |f|, by ascent from 65 directions; infinite: joint limits support one [N]
};
/// @param q  (coordinates) [rad];  @param tip  entry of HandLayout::tip_points
[[nodiscard]] TipForces tip_forces(const Hand& hand, const Eigen::VectorXd& q, int tip);

/// Opposition of the thumb, on a scale of 0 to 10.
struct Opposition {
  double score = 0;                  // NaN: a hand of fewer than two digits
  std::string scale;                 // name of the scale
  std::vector<std::string> reached;  // places or digits that the thumb meets
};

/// With places: Kapandji's score, the highest place that the thumb's pad meets. Without: ten times
/// the share of other tips that the tip of the thumb meets, the best over all digits if none is
/// called thumb. Two points meet if some posture within the limits brings them within 10 mm,
/// centres of tips 20 mm; flesh may overlap on the way, and orientations do not count. Postures are
/// searched from 12 random starts by damped least squares clamped to the limits. Source:
/// [Kapandji1986].
[[nodiscard]] Opposition opposition(const ComparedHand& hand, std::mt19937& random,
                                    const Progress& progress = {});

}  // namespace thenar
