#include "pads/motion/law_pad.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

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
/// @param spring  stiffness that stores the friction
/// @return that stiffness, at most that of the patch
/// Source: [Elata1996].
double reduce_friction(double patch, std::size_t first, std::size_t end, double spring,
                       std::array<ExponentialMemory, 4>& friction) {
  if (spring <= patch) return spring;
  for (std::size_t k = first; k < end; ++k) {
    friction[k].x *= patch / spring;
    for (double& term : friction[k].terms) term *= patch / spring;
  }
  return patch;
}

/// Returns the stiffness at which a changed force stores the energy of the force before,
/// f^2 / (2 spring), plus the work of its change c on a patch,  (f . c + c^2 / 2) / patch.
double changed_spring(const Vector3d& force, const Vector3d& change, double patch, double spring) {
  const double before = spring > 0 ? force.squaredNorm() / spring : 0;
  const double energy = before + (2 * force.dot(change) + change.squaredNorm()) / patch;
  return patch > 0 && energy > 0 ? std::min(patch, (force + change).squaredNorm() / energy) : 0;
}

/// Returns whether the deepest skin is at the middle of a thin object or beyond it, where depth is
/// undefined.
/// @param normal  outward normal of the object there, in the pad's frame, unit (3)
bool is_behind(const DeepestSkin& deepest, const Shape& skin, const Shape& object,
               const Pose<double>& X_OP, const Vector3d& normal) {
  // On the near side the normals oppose each other, and depth increases along the normal.
  const Vector3d deeper = deepest.place - kExtraDepthShare * deepest.overlap * normal;
  return normal.dot(skin.nearest(deepest.place).normal) > 0 ||
         object.distance(X_OP * deeper) > -(1 + 0.5 * kExtraDepthShare) * deepest.overlap;
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
  // Compute the normal force by the law and its history. Without force, reset friction.
  const Pose<double> X_OP = X_PO.inverse();
  const MemoryStep weights = memory_step(law_->relaxation(), seconds);
  const DeepestSkin deepest = find_deepest(X_OP);
  RelativeCurvatures gap{2 * kFlattestGap, kFlattestGap};
  if (deepest.overlap > 0) gap = skin_gap(*skin_, *object_.shape, X_PO, deepest.place);
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
  if (is_behind(deepest, *skin_, *object_.shape, X_OP, out.normal)) {
    moved_ = kept_;
    return behind_object();
  }
  // Place the patch at the object's surface, and compute friction and torsion.
  out.centre = deepest.place + deepest.overlap * out.normal;
  out.force = contact.force;
  out.area = contact.area;
  const Friction friction = update_friction(contact, out.centre, out.normal, weights);
  moved_.energy = stored_energy(deepest.overlap, contact.stiffness / weights.now);
  // Sum the wrench of normal force, friction and torsion.
  out.stick = friction.sticks ? 1 : 0;
  out.push = wrench_of_force(out.centre, contact.force * out.normal + friction.force.head<3>());
  out.push.moment += friction.force[3] * out.normal;
  return out;
}

DeepestSkin LawPad::find_deepest(const Pose<double>& X_OP) {
  // Bound the overlap by the distance to the pad's origin, without a search for a distant object.
  DeepestSkin deepest;
  deepest.overlap = reach_ - object_.shape->distance(X_OP.p);
  if (!(deepest.overlap >= 0)) return deepest;
  // Search the whole skin again once another point may have become the deepest.
  const Eigen::Matrix<double, 6, 1> motion = motion_from(kept_.X_searched, moved_.X_PO);
  const double moved = motion.tail<3>().norm() + motion.head<3>().norm() * reach_;
  const bool stays_near = 2 * moved < kept_.lead;
  deepest = deepest_skin(*chart_, *object_.shape, moved_.X_PO,
                         stays_near ? std::optional(kept_.disc) : std::nullopt);
  moved_.disc = deepest.disc;
  if (!stays_near) {
    moved_.X_searched = moved_.X_PO;
    moved_.lead = deepest.lead;
  }
  return deepest;
}

double LawPad::stored_energy(double depth, double slope) const {
  // A power n of depth stores  F depth / (n + 1)  with  n = slope depth / F.
  const double force = moved_.normal.x;
  double energy = force > 0 ? force * depth / (1 + slope * depth / force) : 0;
  // Add the energy of the springs of friction.
  for (std::size_t k = 0; k < 4; ++k)
    if (const double spring = moved_.spring[k < 3 ? 0 : 1]; spring > 0)
      energy += 0.5 * moved_.friction[k].x * moved_.friction[k].x / spring;
  return energy;
}

LawPad::Friction LawPad::update_friction(const LawContact& contact, const Vector3d& at,
                                         const Vector3d& normal, const MemoryStep& weights) {
  // Compute the motion of the object at the patch since the last step.
  const Pose<double> D = moved_.X_PO * kept_.X_PO.inverse();
  const Eigen::AngleAxisd turn(D.R);
  const Vector3d displacement = at - D.inverse() * at;
  // Project the friction history on the patch, and reduce it as the stiffness k of sliding or
  // k a b of twisting decreases.
  const double stiffness = contact.shear, twisted = stiffness * contact.patch.a * contact.patch.b;
  auto& [sliding, twisting] = moved_.spring;
  project_friction(normal, moved_.friction);
  sliding = reduce_friction(stiffness, 0, 3, sliding, moved_.friction);
  twisting = reduce_friction(twisted, 3, 4, twisting, moved_.friction);
  Vector4d elastic, past, stretch = Vector4d::Zero();
  // Stretch the friction springs, except on first touch.
  if (kept_.touched)
    stretch << stiffness * (displacement - normal * normal.dot(displacement)),
        twisted * turn.angle() * turn.axis().dot(normal);
  for (int k = 0; k < 4; ++k) {
    const ExponentialMemory& memory = moved_.friction[k];
    past[k] = history_of(weights, memory);
    elastic[k] = memory.x + stretch[k];
  }
  // Update the stiffness that stores the friction's energy.
  const auto& [fx, fy, fz, torque] = moved_.friction;
  sliding = changed_spring({fx.x, fy.x, fz.x}, stretch.head<3>(), stiffness, sliding);
  twisting = changed_spring({torque.x, 0, 0}, {stretch[3], 0, 0}, twisted, twisting);
  // Compute the trial force of a sticking patch.
  Vector4d trial = weights.now * elastic + past;
  const double bound = object_.friction * contact.force, torsion = contact.patch.torsion;
  // A patch without extent has no torque.
  if (torsion <= 0) trial[3] = elastic[3] = past[3] = 0;
  // If it slips, scale it back to the ellipsoid  |f|^2 + (torque / lever)^2 <= bound^2.
  const double lever = object_.friction > 0 ? torsion / object_.friction : 0;
  const double size = std::hypot(trial.head<3>().norm(), lever > 0 ? trial[3] / lever : 0);
  const bool sticks = size <= bound;
  if (!sticks) {
    trial *= size > 0 ? bound / size : 0;
    elastic = (trial - past) / weights.now;
  }
  // Advance the history with the elastic friction of the result.
  for (std::size_t k = 0; k < 4; ++k) (void)remember(weights, elastic[k], moved_.friction[k]);
  return {trial, sticks};
}

void LawPad::accept_step() { kept_ = moved_; }

}  // namespace thenar
