#include "pads/motion/law_pad.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/units.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;

// Depth that the object needs beyond the deepest skin, over the overlap [1]
constexpr double kExtraDepthShare = 0.1;

/// Projects the friction history on the present plane of the patch.
void project_friction(const Vector3d& normal, std::array<ExponentialMemory, 4>& friction) {
  const auto project = [&](double& x, double& y, double& z) {
    const Vector3d f(x, y, z), flat = f - normal * normal.dot(f);
    x = flat[0];
    y = flat[1];
    z = flat[2];
  };
  project(friction[0].x, friction[1].x, friction[2].x);
  for (std::size_t j = 0; j < friction[0].terms.size(); ++j)
    project(friction[0].terms[j], friction[1].terms[j], friction[2].terms[j]);
}

/// Reduces the friction history in proportion as a patch shrinks and softens. Otherwise a soft
/// patch would return friction that a stiff patch has stored, and create energy.
/// @param spring  stiffness that stores the friction, reduced to that of the patch
/// Source: [Elata1996].
void reduce_friction(double patch, std::size_t first, std::size_t end, double& spring,
                     std::array<ExponentialMemory, 4>& friction) {
  if (spring <= patch) return;
  for (std::size_t k = first; k < end; ++k) {
    friction[k].x *= patch / spring;
    for (double& term : friction[k].terms) term *= patch / spring;
  }
  spring = patch;
}

/// Sets the stiffness at which a changed force stores the energy of the force before,
/// f^2 / (2 spring), plus the work of its change c on a patch,  (f . c + c^2 / 2) / patch.
void set_spring(const Vector3d& force, const Vector3d& change, double patch, double& spring) {
  const double before = spring > 0 ? force.squaredNorm() / spring : 0;
  const double energy = before + (2 * force.dot(change) + change.squaredNorm()) / patch;
  spring = patch > 0 && energy > 0 ? std::min(patch, (force + change).squaredNorm() / energy) : 0;
}

}  // namespace

LawPad::LawPad(std::string name, const PadShape& shape, std::shared_ptr<const ContactLaw> law,
               RigidObject object, const Pose<double>& X_PO)
    : name_(std::move(name)),
      shape_(shape),
      chart_(std::make_shared<PadChart>(shape)),
      skin_(skin_solid(shape)),
      law_(std::move(law)),
      object_(std::move(object)) {
  require(law_ && object_.shape && object_.friction >= 0,
          "a pad in motion wants a law, and an object with a shape and a friction >= 0");
  require(law_->at_force({200, 100}, 1, 1).shear > 0,
          "the law '{}' has no stiffness across: a pad in motion would hold nothing", name_);
  kept_.X_PO = moved_.X_PO = X_PO;
  reach_ = reach_of(shape_);
}

std::unique_ptr<MovingPad> LawPad::clone() const {
  return std::make_unique<LawPad>(name_, shape_, law_, object_, kept_.X_PO);
}

PadContact LawPad::try_step(const Pose<double>& X_PO, double seconds) {
  moved_ = kept_;
  moved_.X_PO = X_PO;
  PadContact out;
  // Bound the gap by the distance to the pad's origin, which needs no search for a distant object.
  const Pose<double> X_OP = X_PO.inverse();
  const double apart = object_.shape->distance(X_OP.p) - reach_;
  const MemoryStep weights = memory_step(law_->relaxation(), seconds);
  DeepestSkin deepest;
  deepest.overlap = -apart;
  RelativeCurvatures gap{2 * kFlattestGap, kFlattestGap};
  if (apart <= 0) {
    // Search the whole skin again once another point may have become the deepest.
    const Eigen::Matrix<double, 6, 1> motion = motion_from(kept_.X_searched, X_PO);
    const double moved = motion.tail<3>().norm() + motion.head<3>().norm() * reach_;
    const bool knows = 2 * moved < kept_.lead;
    deepest = deepest_skin(*chart_, *object_.shape, X_PO,
                           knows ? std::optional(kept_.disc) : std::nullopt);
    moved_.disc = deepest.disc;
    if (!knows) {
      moved_.X_searched = X_PO;
      moved_.lead = deepest.lead;
    }
    if (deepest.overlap > 0) gap = skin_gap(*skin_, *object_.shape, X_PO, deepest.place);
  }
  // Compute the normal force by the law and its history. Without force, reset friction.
  const LawContact contact =
      relaxed_contact(*law_, gap, deepest.overlap, object_.friction, weights, moved_.normal);
  if (contact.force <= 0) {
    moved_.friction = {};
    moved_.spring = {};
    moved_.touched = false;
    moved_.energy = 0;
    out.gap = std::max(0.0, -deepest.overlap);
    return out;
  }
  moved_.touched = true;
  out.normal = X_PO.R * object_.shape->nearest(X_OP * deepest.place).normal;
  // Reject points on the far side or at the middle of a thin object, where depth is undefined.
  const Vector3d deeper = deepest.place - kExtraDepthShare * deepest.overlap * out.normal;
  if (out.normal.dot(skin_->nearest(deepest.place).normal) > 0 ||
      object_.shape->distance(X_OP * deeper) > -(1 + 0.5 * kExtraDepthShare) * deepest.overlap) {
    moved_ = kept_;
    return behind_object();
  }
  // Place the patch at the object's surface, and compute friction and torsion.
  out.centre = deepest.place + deepest.overlap * out.normal;
  out.force = contact.force;
  out.area = contact.area;
  bool sticks = true;
  const Vector4d friction = update_friction(contact, out.centre, out.normal, weights, sticks);
  // Sum the energy: a power n of depth stores  F depth / (n + 1)  with  n = slope depth / F.
  const double elastic = moved_.normal.x, slope = contact.stiffness / weights.now;
  moved_.energy =
      elastic > 0 ? elastic * deepest.overlap / (1 + slope * deepest.overlap / elastic) : 0;
  for (std::size_t k = 0; k < 4; ++k)
    if (const double spring = moved_.spring[k < 3 ? 0 : 1]; spring > 0)
      moved_.energy += 0.5 * moved_.friction[k].x * moved_.friction[k].x / spring;
  // Sum the wrench of normal force, friction and torsion.
  out.stick = sticks ? 1 : 0;
  out.push = wrench_of_force(out.centre, contact.force * out.normal + friction.head<3>());
  out.push.moment += friction[3] * out.normal;
  return out;
}

Vector4d LawPad::update_friction(const LawContact& contact, const Vector3d& at,
                                 const Vector3d& normal, const MemoryStep& weights, bool& sticks) {
  // Compute the motion of the object at the patch since the last step.
  const Pose<double> D = moved_.X_PO * kept_.X_PO.inverse();
  const Eigen::AngleAxisd turn(D.R);
  const Vector3d way = at - D.inverse() * at;
  // Project the friction history on the patch, and reduce it as the stiffness k of sliding or
  // k a b of twisting decreases.
  const double stiffness = contact.shear, twisted = stiffness * contact.patch.a * contact.patch.b;
  project_friction(normal, moved_.friction);
  reduce_friction(stiffness, 0, 3, moved_.spring[0], moved_.friction);
  reduce_friction(twisted, 3, 4, moved_.spring[1], moved_.friction);
  Vector4d elastic, past, stretch = Vector4d::Zero();
  // Stretch the friction springs, except on first touch.
  if (kept_.touched)
    stretch << stiffness * (way - normal * normal.dot(way)),
        twisted * turn.angle() * turn.axis().dot(normal);
  for (int k = 0; k < 4; ++k) {
    const ExponentialMemory& memory = moved_.friction[k];
    past[k] = history_of(weights, memory);
    elastic[k] = memory.x + stretch[k];
  }
  // Update the stiffness that stores the friction's energy.
  const std::array<ExponentialMemory, 4>& before = moved_.friction;
  set_spring({before[0].x, before[1].x, before[2].x}, stretch.head<3>(), stiffness,
             moved_.spring[0]);
  set_spring({before[3].x, 0, 0}, {stretch[3], 0, 0}, twisted, moved_.spring[1]);
  // Compute the trial force of a sticking patch.
  Vector4d trial = weights.now * elastic + past;
  const double bound = object_.friction * contact.force, torsion = contact.patch.torsion;
  // A patch without extent has no torque.
  if (torsion <= 0) trial[3] = elastic[3] = past[3] = 0;
  // If it slips, scale it back to the ellipsoid  |f|^2 + (torque / lever)^2 <= bound^2.
  const double lever = object_.friction > 0 ? torsion / object_.friction : 0;
  const double size = std::hypot(trial.head<3>().norm(), lever > 0 ? trial[3] / lever : 0);
  sticks = size <= bound;
  if (!sticks) {
    trial *= size > 0 ? bound / size : 0;
    elastic = (trial - past) / weights.now;
  }
  // Advance the history with the elastic friction of the result.
  for (std::size_t k = 0; k < 4; ++k) (void)remember(weights, elastic[k], moved_.friction[k]);
  return trial;
}

void LawPad::accept_step() { kept_ = moved_; }

}  // namespace thenar
