#pragma once

/// Interface of all reduced laws of a soft pad at one contact with a rigid object.

#include <vector>

#include "geometry/collision/curvature.h"
#include "pad_laws/exponential_memory.h"
#include "pad_laws/soft_patch.h"

namespace thenar {

/// Least curvature of a gap [1/m]. Flatter gaps count as a ball of 0.1 m, because laws of patches
/// know no flat faces, whose edges bound the patch.
inline constexpr double kFlattestGap = 10;

/// One contact. All zero, but for `patch.depth`, where nothing touches.
struct LawContact {
  double force = 0;      // normal, >= 0 [N]
  double stiffness = 0;  // d force / d depth [N/m]; infinite: rigid
  double area = 0;       // of the patch [m^2]
  SoftPatch patch;       // semi-axes, approach, largest torque per normal force
  double shear = 0;      // stiffness across, while all of the patch sticks [N/m]
};

/// A law of contact between a pad and a rigid object whose surfaces are known where they touch.
///
/// Answers are those of a press that is so short that nothing relaxes; relaxed_contact() goes on in
/// time. Force rises with depth, and both ways of asking agree.
class ContactLaw {
 public:
  virtual ~ContactLaw() = default;
  /// @param gap       of both surfaces before they deform
  /// @param depth     approach since they touched; below 0: apart [m]
  /// @param friction  Coulomb's coefficient [1]
  /// @throws InputError unless the gap and the depth are finite, and friction is finite and >= 0.
  [[nodiscard]] virtual LawContact at_depth(const RelativeCurvatures& gap, double depth,
                                            double friction) const = 0;
  /// @param force  normal [N]
  /// @throws InputError unless the gap is finite, and force and friction are finite and >= 0.
  [[nodiscard]] virtual LawContact at_force(const RelativeCurvatures& gap, double force,
                                            double friction) const = 0;
  /// Returns the relaxation of force at a constant depth; empty: force does not relax.
  [[nodiscard]] virtual const std::vector<ExponentialTerm>& relaxation() const = 0;
};

/// A contact at the end of a step of time, exact where the elastic force runs straight:
///   force = integral of g(t - s) d F(depth(s)),  or 0 where the pad comes back more slowly than
/// the object leaves: then F is what keeps the pad's force at 0, and it may touch again.
/// The patch is that of the depth; `stiffness` is that of the step.
/// @param weights  of the step, memory_step(law.relaxation(), h)
/// @param memory   of the elastic force F [N]; goes on
[[nodiscard]] LawContact relaxed_contact(const ContactLaw& law, const RelativeCurvatures& gap,
                                         double depth, double friction, const MemoryStep& weights,
                                         ExponentialMemory& memory);

namespace internal {
/// Radius  1 / sqrt(k1 k2)  of a gap, and its ratio of radii, k1 / k2 >= 1.
struct GapRadius {
  double radius;  // [m]
  double ratio;   // [1]
};
/// @throws InputError unless k1 >= k2 are finite.
[[nodiscard]] GapRadius radius_of(const RelativeCurvatures& gap);
/// @throws InputError unless all are finite, and force and friction not negative.
void check_contact_load(double depth, double force, double friction);
}  // namespace internal

}  // namespace thenar
