#pragma once

/// Contact problem of one time step, in impulses and velocities.

#include <utility>
#include <vector>

#include <Eigen/Core>

#include "base/numbers.h"

namespace thenar {

/// Complementarity law of the impulse f and the velocity u of a block of rows.
enum class ConstraintLaw {
  kBilateral,   // f free, u = 0: loops, couplings, locked joints
  kUnilateral,  // 0 <= f _|_ u >= 0: joint limits, contacts without friction
  kBox,         // lower <= f <= upper; u >= 0 at lower, <= 0 at upper, 0 between: dry friction of
                // joints, motors with limits
  kCoulomb,     // point contact with the exact friction cone: normal, two tangents
  kSoftFinger   // point contact with torsional friction: normal, two tangents, torsion
};

/// Rows of one constraint.
///
/// A contact with friction obeys, with f = (fn, ft) and u = (un, ut), for soft fingers with
/// ft = (force, torque / e) and ut = (velocity, e spin):
///   0 <= fn _|_ un >= 0,   |ft| <= mu fn,   ft . ut = -mu fn |ut|,
/// which is  K contains f _|_ (un + mu |ut|, ut) in K*,  K = {|ft| <= mu fn}. The last condition is
/// maximum dissipation: no force of the disc |ft| <= mu fn takes more power from the slip. For soft
/// fingers that disc is the limit ellipsoid  |force|^2 / mu^2 + torque^2 / (mu e)^2 <= fn^2.
/// Source: [DeSaxce1998] for the form, [Howe1996] for the ellipsoid.
struct ContactBlock {
  ConstraintLaw law = ConstraintLaw::kUnilateral;
  double lower = 0;           // kBox: [N s] or [N m s]
  double upper = 0;           // kBox: [N s] or [N m s]
  double friction = 0;        // kCoulomb, kSoftFinger: mu [1]
  double torsion_radius = 0;  // kSoftFinger: e, largest torque over largest tangential force [m]
};

/// Returns a block of one bilateral row.
[[nodiscard]] ContactBlock bilateral_block();
/// Returns a block of one unilateral row.
[[nodiscard]] ContactBlock unilateral_block();
/// Returns a block of one row with bounds of its impulse [N s] or [N m s].
/// @throws InputError unless lower <= upper, and a finite impulse lies between them.
[[nodiscard]] ContactBlock box_block(double lower, double upper);
/// Returns a block of a point contact with this coefficient of friction [1].
/// @throws InputError unless friction is finite and >= 0.
[[nodiscard]] ContactBlock coulomb_block(double friction);
/// Returns a block of a soft-finger contact.
/// @param friction        coefficient of friction mu [1]
/// @param torsion_radius  e [m]; `torsion` of a SoftPatch over its friction
/// @throws InputError unless both are finite and >= 0.
[[nodiscard]] ContactBlock soft_finger_block(double friction, double torsion_radius);

/// Returns the number of rows of a law: 1, 3 (normal, tangents) or 4 (normal, tangents, torsion).
[[nodiscard]] int row_count(ConstraintLaw law);

/// Contact problem for the impulses f and velocities  u = W f + b  of all rows.
///
/// W = J M^-1 J' is symmetric positive semidefinite, and singular if contacts are redundant. b is
/// the velocity J v without impulses, to which a time stepper adds restitution and corrections.
struct ContactProblem {
  std::vector<ContactBlock> blocks;  // blocks in the order of their rows
  Eigen::MatrixXd W;                 // Delassus matrix [1/kg], [1/(kg m)] or [1/(kg m^2)] (n, n)
  Eigen::VectorXd b;                 // velocities at f = 0 [m/s] or [rad/s] (n)
};

/// Checks a contact problem.
/// @throws InputError unless shapes fit, all numbers are finite, W is symmetric, and the blocks
/// satisfy the conditions of coulomb_block() and the like.
void check_contact_problem(const ContactProblem& problem);

/// Residuals of impulses, computed from W, b and f alone.
///
/// `natural` is the norm of the natural map, independent of units. With the scale s of a block's
/// rows, 1 / sqrt(mean of its diagonal of W) (torsion rows times e first), f' = f / s and u' = s u
/// have the unit sqrt(J), and
///   natural = max |f' - P_K(f' - û')| / scale,   û' = u' + mu |u_t'| n,
/// where scale is the maximum of |s b| and of |P(0) / s|, and P(0) the impulse of a box that is
/// nearest to 0. It is 0 at solutions only. `rounding` is the part of it that may be due to
/// rounding, 4 eps sum |f_j| sqrt(W_jj) / scale, which is large where a heavy body rests on a light
/// one. All other residuals are in the units of the problem, and 0 at a solution.
struct ContactResidual {
  double natural = kInfinity;  // natural map, relative [1]
  double scale = 0;            // scale of `natural` [sqrt(J)]
  double rounding = 0;         // rounding error of `natural` [1]
  double outside = 0;          // excess of f over its cone or box: |ft| - mu fn, -fn, ... [N s]
  double approach = 0;         // approach velocity -un of contacts and limits [m/s]
  double complementarity = 0;  // |fn un|; for boxes u times the distance of f to its bound [J]
  double alignment = 0;        // missing dissipation ft . ut + mu fn |ut| [J]
  double bilateral = 0;        // |u| of bilateral rows [m/s]

  /// Returns true if `natural` is at most the tolerance, or at most `rounding` up to 1e-8.
  [[nodiscard]] bool is_within(double tolerance) const;
};

/// Computes the residuals of impulses.
/// @param f  impulses [N s] or [N m s] (n)
/// @throws InputError if f does not have n entries
[[nodiscard]] ContactResidual contact_residual(const ContactProblem& problem,
                                               const Eigen::Ref<const Eigen::VectorXd>& f);

namespace internal {

// Factor of the machine epsilon in ContactResidual::rounding [1]
inline constexpr double kRoundingUnits = 4;
// Largest ContactResidual::rounding that is accepted in place of the tolerance [1]
inline constexpr double kMaxRounding = 1e-8;

/// Returns the lower and upper bound of the impulse of a law with one row.
[[nodiscard]] std::pair<double, double> impulse_bounds(const ContactBlock& block);

/// Computes contact_residual() for callers that already know the velocities.
/// @param u  W f + b (n)
[[nodiscard]] ContactResidual contact_residual_at(const ContactProblem& problem,
                                                  const Eigen::Ref<const Eigen::VectorXd>& f,
                                                  const Eigen::Ref<const Eigen::VectorXd>& u);

/// Returns the scale s of a block's rows without the torsion radius, see ContactResidual.
/// @param start    first row of the block
/// @param minimum  mean diagonal below which a block counts as immobile, min_diagonal()
[[nodiscard]] double block_scale(const ContactProblem& problem, const ContactBlock& block,
                                 Eigen::Index start, double minimum);

/// Returns the smallest mean diagonal of a mobile block: 1e-16 of the largest diagonal entry of W.
[[nodiscard]] double min_diagonal(const ContactProblem& problem);

}  // namespace internal

}  // namespace thenar
