#pragma once

/// The contact problem of one time step, in impulses and velocities.

#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "base/numbers.h"

namespace thenar {

/// Law that the impulse f and the velocity u of a block of rows obey.
enum class ConstraintLaw {
  kBilateral,   // f free, u = 0: loops, couplings, locked joints
  kUnilateral,  // 0 <= f _|_ u >= 0: joint limits, contacts without friction
  kBox,         // lower <= f <= upper; u >= 0 at lower, <= 0 at upper, 0 between: dry friction of
                // joints, motors with limits
  kCoulomb,     // point contact with the exact cone: normal, two tangents
  kSoftFinger   // the same, and torsion about the normal
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
  double upper = 0;           // kBox
  double friction = 0;        // kCoulomb, kSoftFinger: mu [1]
  double torsion_radius = 0;  // kSoftFinger: e, largest torque over largest tangential force [m]
};

[[nodiscard]] ContactBlock bilateral_block();
[[nodiscard]] ContactBlock unilateral_block();
/// @throws InputError unless lower <= upper; both may be infinite.
[[nodiscard]] ContactBlock box_block(double lower, double upper);
/// @throws InputError unless friction is finite and >= 0.
[[nodiscard]] ContactBlock coulomb_block(double friction);
/// @param torsion_radius  e [m]; `torsion` of a SoftPatch over its friction
/// @throws InputError unless both are finite and >= 0.
[[nodiscard]] ContactBlock soft_finger_block(double friction, double torsion_radius);

/// 1, 3 (normal, tangents) or 4 (normal, tangents, torsion).
[[nodiscard]] int rows_of(ConstraintLaw law);

/// Impulses f and velocities u of all rows:  u = W f + b.
///
/// W = J M^-1 J' is symmetric positive semidefinite, singular where contacts are redundant. b is
/// the velocity J v without impulses, to which a time stepper adds restitution and corrections.
struct ContactProblem {
  std::vector<ContactBlock> blocks;  // of rows in this order
  Eigen::MatrixXd W;                 // [1/kg], [1/(kg m)] or [1/(kg m^2)] (n, n)
  Eigen::VectorXd b;                 // [m/s] or [rad/s] (n)
};

/// @throws InputError unless shapes fit, all is finite and blocks are as their makers ask.
void check_contact_problem(const ContactProblem& problem);

/// Distance of impulses from an answer, computed from W, b and f alone.
///
/// `natural` does not depend on units. With the scale s of a block's rows, 1 / sqrt(mean of its
/// diagonal of W) (torsion rows times e first), f' = f / s and u' = s u have the unit sqrt(J), and
///   natural = max |f' - P_K(f' - û')| / scale,   û' = u' + mu |u_t'| n,
/// scale = max of |s b| and of |P(0) / s|, P(0) the impulse of a box that is nearest to 0. It is 0
/// at answers only. `rounding` is what of it doubles may hide, 4 eps sum |f_j| sqrt(W_jj) / scale,
/// large where a heavy body rests on a light one. All others are in the units of the problem, and 0
/// at an answer.
struct ContactResidual {
  double natural = kInfinity;  // [1]
  double scale = 0;            // of `natural` [sqrt(J)]
  double rounding = 0;         // of `natural` [1]
  double outside = 0;          // f outside its cone or box: |ft| - mu fn, -fn, ... [N s]
  double approach = 0;         // -un of contacts and limits: bodies come closer [m/s]
  double complementarity = 0;  // |fn un|; of boxes what u takes from an impulse off its bound [J]
  double alignment = 0;        // ft . ut + mu fn |ut|: dissipation that is missing [J]
  double bilateral = 0;        // |u| of bilateral rows [m/s]

  /// Returns whether `natural` is at most the tolerance, or the rounding where that is larger (up
  /// to 1e-8).
  [[nodiscard]] bool is_within(double tolerance) const;
};

/// @param f  impulses (n)
[[nodiscard]] ContactResidual contact_residual(const ContactProblem& problem,
                                               const Eigen::Ref<const Eigen::VectorXd>& f);

namespace internal {

// Roundings of a double that ContactResidual::rounding counts [1]
inline constexpr double kRoundings = 4;
// Largest rounding with which a residual still counts as an answer [1]
inline constexpr double kMostRounding = 1e-8;

/// Ends of the interval of a law with one row.
[[nodiscard]] std::pair<double, double> ends_of(const ContactBlock& block);

/// Computes contact_residual() for callers that already know the velocities.
/// @param u  W f + b (n)
[[nodiscard]] ContactResidual contact_residual_at(const ContactProblem& problem,
                                                  const Eigen::Ref<const Eigen::VectorXd>& f,
                                                  const Eigen::Ref<const Eigen::VectorXd>& u);

/// Scale s of a block's rows, but for the radius of torsion (ContactResidual).
/// @param start  its first row;  @param least  smallest mean diagonal that counts
[[nodiscard]] double block_scale(const ContactProblem& problem, const ContactBlock& block,
                                 Eigen::Index start, double least);

/// Smallest mean diagonal of a block that counts: 1e-16 of the largest entry of W's diagonal.
[[nodiscard]] double least_diagonal(const ContactProblem& problem);

}  // namespace internal

}  // namespace thenar
