#pragma once

/// Interface of reduced laws of a soft pad at one contact with a rigid object.

#include <vector>

#include "geometry/collision/curvature.h"
#include "pad_laws/exponential_memory.h"
#include "pad_laws/soft_patch.h"

namespace thenar {

/// Least curvature of a gap [1/m]. Flatter gaps count as a ball of 0.1 m radius, because the laws
/// do not describe flat faces, whose edges bound the patch.
inline constexpr double kFlattestGap = 10;

/// One contact. All members but `patch.depth` are zero where nothing touches.
struct LawContact {
  double force = 0;      // normal force, >= 0 [N]
  double stiffness = 0;  // d force / d depth [N/m]; infinite: rigid
  double area = 0;       // area of the patch [m^2]
  SoftPatch patch;       // semi-axes, approach, largest torque per normal force
  double shear = 0;      // tangential stiffness while the whole patch sticks [N/m]
};

/// Contact law between a pad and a rigid object, given the curvatures of their gap.
///
/// Contacts are instantaneous: nothing relaxes; relaxed_contact() advances a law in time. Force
/// increases with depth, and at_depth() and at_force() are inverse to each other.
class ContactLaw {
 public:
  virtual ~ContactLaw() = default;
  /// Returns the contact at a depth.
  /// @param gap       curvatures of the gap between the undeformed surfaces
  /// @param depth     approach since they touched; below 0: apart [m]
  /// @param friction  Coulomb's coefficient [1]
  /// @throws InputError unless the gap and the depth are finite, and friction is finite and >= 0.
  [[nodiscard]] virtual LawContact at_depth(const RelativeCurvatures& gap, double depth,
                                            double friction) const = 0;
  /// Returns the contact at a normal force.
  /// @param force  normal force [N]
  /// @throws InputError unless the gap is finite, and force and friction are finite and >= 0.
  [[nodiscard]] virtual LawContact at_force(const RelativeCurvatures& gap, double force,
                                            double friction) const = 0;
  /// Returns the relaxation of force at a constant depth; empty: force does not relax.
  [[nodiscard]] virtual const std::vector<ExponentialTerm>& relaxation() const = 0;
};

/// Computes the contact at the end of a time step, exactly if the elastic force F is linear in
/// time:
///   force = integral of g(t - s) d F(depth(s)),
/// or 0 if the pad recovers more slowly than the object leaves. In that case F is the value that
/// keeps the force at 0, and the pad may touch again later. The patch is that at the depth;
/// `stiffness` is that of the step.
/// @param weights  weights of the step, memory_step(law.relaxation(), h)
/// @param memory   history of the elastic force F [N], advanced by the step
[[nodiscard]] LawContact relaxed_contact(const ContactLaw& law, const RelativeCurvatures& gap,
                                         double depth, double friction, const MemoryStep& weights,
                                         ExponentialMemory& memory);

namespace internal {
/// Radius  1 / sqrt(k1 k2)  of a gap, and its ratio of radii, k1 / k2 >= 1.
struct GapRadius {
  double radius = 0;  // [m]
  double ratio = 0;   // [1]
};
/// Returns the radius of a gap. @throws InputError unless k1 >= k2 are finite.
[[nodiscard]] GapRadius radius_of(const RelativeCurvatures& gap);
/// Checks a contact, and returns the radius of its gap.
/// @throws InputError as radius_of(), or unless the load is finite, and force and friction not
///         negative.
GapRadius checked_gap(const RelativeCurvatures& gap, double depth, double force, double friction);
/// Returns the contact without force at a depth [m].
[[nodiscard]] LawContact no_contact(double depth);
}  // namespace internal

}  // namespace thenar
