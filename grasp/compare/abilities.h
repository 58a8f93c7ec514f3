#pragma once

/// What hands can do without an object.

#include <random>

#include "grasp/compare/comparison.h"

namespace thenar {

/// All of HandAbilities but `types`. Draws postures uniformly within limits from a generator of
/// options.seed. What a stop leaves is worth nothing.
[[nodiscard]] HandAbilities hand_abilities(const ComparedHand& hand, const CompareOptions& options,
                                           const Progress& progress = {});

/// Where tips go: postures drawn, tips noted in voxels of a grid. A tip that moves in fewer than
/// three dimensions (principal extent below two voxels) is measured in those alone. The estimate is
/// the voxels met less half of those at the rim (with a neighbour not met), +- that half; of voxels
/// of 1/4, 1/2, 1, 2 and 4 times `voxel`, those serve each tip that leave the least share. Too
/// large ones have a thick rim, too small ones holes that no draw met.
struct Workspaces {
  std::vector<DigitAbility> digits;  // forces are not filled in
  double overlap = 0;  // thumb's, or first digit's, with all others', voxels of 2 `voxel` [m^3]
};
[[nodiscard]] Workspaces workspaces(const Hand& hand, int draws, double voxel, std::mt19937& random,
                                    const Progress& progress = {});

/// The largest tip forces at a posture within what drives the hand, its stops included:
///   max d'f  over  L f = B u + R r + tau_0,  f = J s,  lower <= u <= upper,
///   L = J' + sum J_o' c_o c'
/// for the joints that move the tip, J (3, joints) [m/rad]; c its unit way in closing, and o other
/// tips that a coordinate which closes moves with it: these meet as much, c'f, along their own ways
/// c_o. So jaws of one motor pinch with half of its effort each, 2 r f = u. A tendon over several
/// joints of one digit, DriveCoupling::kCompliant, balances f at all of them at once.
///
/// Forces that structure bears without effort (J'f = 0) are left out, and so are joints that are
/// locked or, further in than the outermost held one, bear what it presses: hand_forces(). NaN: an
/// effort that matters is unknown.
struct TipForces {
  double closing = 0;  // d along the tip's way in closing: how hard the digit presses [N]
  double largest = 0;  // |f|, by ascent from 65 directions; infinite: stops bear one of them [N]
};
[[nodiscard]] TipForces tip_forces(const Hand& hand, const Eigen::VectorXd& q, int tip);

/// How the thumb opposes, on a scale of 0 to 10.
struct Opposition {
  double score = 0;  // NaN: a hand of fewer than two digits
  std::string scale;
  std::vector<std::string> reached;
};

/// With places: Kapandji's score, the highest place that the thumb's pad meets. Without: ten times
/// the share of other tips that the tip of the thumb meets, the best of all digits if none is
/// called thumb. Two points meet if some posture within the limits brings them within 10 mm,
/// middles of tips 20 mm; flesh may overlap on the way, and which way they face does not count.
/// Postures are searched from 12 drawn starts by damped least squares clamped to the limits.
/// Source: [Kapandji1986].
[[nodiscard]] Opposition opposition(const ComparedHand& hand, std::mt19937& random,
                                    const Progress& progress = {});

}  // namespace thenar
