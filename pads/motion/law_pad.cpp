#include "pads/motion/law_pad.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/units.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;

// Depth that the object must have beyond the deepest skin, over the overlap [1]
constexpr double kRoomShare = 0.1;

/// Projects the remembered friction on the present plane of the patch.
void lay_flat(const Vector3d& normal, std::array<ExponentialMemory, 4>& drag) {
  const auto project = [&](double& x, double& y, double& z) {
    const Vector3d f(x, y, z), flat = f - normal * normal.dot(f);
    x = flat[0];
    y = flat[1];
    z = flat[2];
  };
  project(drag[0].x, drag[1].x, drag[2].x);
  for (std::size_t j = 0; j < drag[0].terms.size(); ++j)
    project(drag[0].terms[j], drag[1].terms[j], drag[2].terms[j]);
}

/// Reduces the remembered friction in proportion as a patch shrinks and softens. Otherwise a soft
/// patch would return friction that a stiff patch gathered, and create energy.
/// @param spring  stiffness of what carries the friction; goes down to that of the patch
/// Source: [Elata1996].
void slacken(double patch, std::size_t first, std::size_t end, double& spring,
             std::array<ExponentialMemory, 4>& drag) {
  if (spring <= patch) return;
  for (std::size_t k = first; k < end; ++k) {
    drag[k].x *= patch / spring;
    for (double& term : drag[k].terms) term *= patch / spring;
  }
  spring = patch;
}

/// The stiffness at which a force has the energy of the one before it, f^2 / (2 spring), and the
/// work of its change by a patch,  f . c + c^2 / 2  over its stiffness.
double spring_of(const Vector3d& force, const Vector3d& change, double patch, double spring) {
  const double before = spring > 0 ? force.squaredNorm() / spring : 0;
  const double energy = before + (2 * force.dot(change) + change.squaredNorm()) / patch;
  return patch > 0 && energy > 0 ? std::min(patch, (force + change).squaredNorm() / energy) : 0;
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

PadContact LawPad::move(const Pose<double>& X_PO, double seconds) {
  moved_ = kept_;
  moved_.X_PO = X_PO;
  PadContact out;
  // Distance to the pad's origin, which gives the gap of a far object without a search.
  const Pose<double> X_OP = X_PO.inverse();
  const double apart = object_.shape->distance(X_OP.p) - reach_;
  const MemoryStep weights = memory_step(law_->relaxation(), seconds);
  DeepestSkin deepest;
  deepest.overlap = -apart;
  RelativeCurvatures gap{2 * kFlattestGap, kFlattestGap};
  if (apart <= 0) {
    // Search all of the skin again once another place may have become the deepest.
    const Eigen::Matrix<double, 6, 1> way = motion_from(kept_.X_look, X_PO);
    const double moved = way.tail<3>().norm() + way.head<3>().norm() * reach_;
    const bool knows = 2 * moved < kept_.lead;
    deepest = deepest_skin(*chart_, *object_.shape, X_PO,
                           knows ? std::optional(kept_.disc) : std::nullopt);
    moved_.disc = deepest.disc;
    if (!knows) {
      moved_.X_look = X_PO;
      moved_.lead = deepest.lead;
    }
    if (deepest.overlap > 0) gap = skin_gap(*skin_, *object_.shape, X_PO, deepest.place);
  }
  // Normal force by the law and its memory. Without force nothing is remembered of friction.
  const LawContact contact =
      relaxed_contact(*law_, gap, deepest.overlap, object_.friction, weights, moved_.normal);
  if (contact.force <= 0) {
    moved_.drag = {};
    moved_.spring = {};
    moved_.touched = false;
    moved_.energy = 0;
    out.gap = std::max(0.0, -deepest.overlap);
    return out;
  }
  moved_.touched = true;
  out.normal = X_PO.R * object_.shape->nearest(X_OP * deepest.place).normal;
  // Refuse the far side of a thin object and its middle, where depth tells nothing.
  const Vector3d deeper = deepest.place - kRoomShare * deepest.overlap * out.normal;
  if (out.normal.dot(skin_->nearest(deepest.place).normal) > 0 ||
      object_.shape->distance(X_OP * deeper) > -(1 + 0.5 * kRoomShare) * deepest.overlap) {
    moved_ = kept_;
    return behind_object();
  }
  // Patch at the object's surface, with friction and torsion.
  out.centre = deepest.place + deepest.overlap * out.normal;
  out.force = contact.force;
  out.area = contact.area;
  bool sticks = true;
  const Vector4d rubbed = rub(contact, out.centre, out.normal, weights, sticks);
  // A power n of depth stores  F depth / (n + 1)  with  n = slope depth / F.
  const double elastic = moved_.normal.x, slope = contact.stiffness / weights.now;
  moved_.energy =
      elastic > 0 ? elastic * deepest.overlap / (1 + slope * deepest.overlap / elastic) : 0;
  for (std::size_t k = 0; k < 4; ++k)
    if (const double spring = moved_.spring[k < 3 ? 0 : 1]; spring > 0)
      moved_.energy += 0.5 * moved_.drag[k].x * moved_.drag[k].x / spring;
  // Push with friction, and torsion about the normal.
  out.stick = sticks ? 1 : 0;
  out.push = wrench_of_force(out.centre, contact.force * out.normal + rubbed.head<3>());
  out.push.moment += rubbed[3] * out.normal;
  return out;
}

Vector4d LawPad::rub(const LawContact& contact, const Vector3d& at, const Vector3d& normal,
                     const MemoryStep& weights, bool& sticks) {
  // Motion of the object at the patch since the last step.
  const Pose<double> D = moved_.X_PO * kept_.X_PO.inverse();
  const Eigen::AngleAxisd turn(D.R);
  const Vector3d way = at - D.inverse() * at;
  // Stiffness k of sliding and k a b of twisting. Remembered friction is laid flat on the patch
  // and reduced as the patch softens.
  const double stiffness = contact.shear, twisted = stiffness * contact.patch.a * contact.patch.b;
  lay_flat(normal, moved_.drag);
  slacken(stiffness, 0, 3, moved_.spring[0], moved_.drag);
  slacken(twisted, 3, 4, moved_.spring[1], moved_.drag);
  Vector4d elastic, past, stretch = Vector4d::Zero();
  // Stretch of friction's springs, none on first touch.
  if (kept_.touched)
    stretch << stiffness * (way - normal * normal.dot(way)),
        twisted * turn.angle() * turn.axis().dot(normal);
  for (int k = 0; k < 4; ++k) {
    const ExponentialMemory& memory = moved_.drag[static_cast<std::size_t>(k)];
    past[k] = history_of(weights, memory);
    elastic[k] = memory.x + stretch[k];
  }
  // Springs that hold the energy of the friction.
  const auto set_spring = [&](const Vector3d& force, const Vector3d& change, double patch,
                              double& spring) { spring = spring_of(force, change, patch, spring); };
  const std::array<ExponentialMemory, 4>& before = moved_.drag;
  set_spring({before[0].x, before[1].x, before[2].x}, stretch.head<3>(), stiffness,
             moved_.spring[0]);
  set_spring({before[3].x, 0, 0}, {stretch[3], 0, 0}, twisted, moved_.spring[1]);
  // Trial: the patch sticks.
  Vector4d drag = weights.now * elastic + past;
  const double bound = object_.friction * contact.force, torsion = contact.patch.torsion;
  // A patch without extent has no torque.
  if (torsion <= 0) drag[3] = elastic[3] = past[3] = 0;
  // Slip: back to the ellipsoid |f|^2 + (torque / lever)^2 <= bound^2, straight towards 0.
  const double lever = object_.friction > 0 ? torsion / object_.friction : 0;
  const double size = std::hypot(drag.head<3>().norm(), lever > 0 ? drag[3] / lever : 0);
  sticks = size <= bound;
  if (!sticks) {
    drag *= size > 0 ? bound / size : 0;
    elastic = (drag - past) / weights.now;
  }
  // Memory takes the elastic friction that fits.
  for (std::size_t k = 0; k < 4; ++k) {
    ExponentialMemory& memory = moved_.drag[k];
    (void)remember(weights, elastic[static_cast<Eigen::Index>(k)], memory);
  }
  return drag;
}

void LawPad::keep() { kept_ = moved_; }

}  // namespace thenar
