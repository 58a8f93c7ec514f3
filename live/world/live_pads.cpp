#include "live/world/live_pads.h"

#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "grasp/limits/grasp_force.h"
#include "pad_laws/foundation_bed.h"
#include "pad_laws/shear_shares.h"
#include "pad_laws/skin_columns.h"

namespace thenar {
namespace {

constexpr double kGravity = 9.81;     // gravitational acceleration [m/s^2]
constexpr int kPressBisections = 36;  // bisections of the depth of a press, down to picometres
constexpr double kMinForceRatio =
    0.98;  // ratio to the wanted force below which a warning is due [1]

/// Returns the constants of a pad's springs for its material; empty if the material is rigid.
std::optional<FoundationConstants> springs_of(const Material& material) {
  // Use the constants of a calibrated bed.
  if (material.bed != nullptr) {
    FoundationConstants bed = *material.bed;
    if (bed.thickness <= 0) bed.thickness = material.layer_thickness;
    return bed;
  }
  // Otherwise derive them from Young's modulus and the thickness of the layer.
  if (material.young <= 0 || material.layer_thickness <= 0) return std::nullopt;
  FoundationConstants plain;
  plain.modulus = material.young;
  plain.thickness = material.layer_thickness;
  plain.shear = material.young / 3;  // shear modulus of an incompressible material
  return plain;
}

Eigen::Vector3d mean_point(const ContactPatch& patch) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const HandContact& each : patch.contacts) sum += each.contact.p;
  return sum / static_cast<double>(patch.contacts.size());
}

Eigen::Vector3d mean_normal(const ContactPatch& patch) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const HandContact& each : patch.contacts) sum += each.contact.n;
  return sum.normalized();
}

/// Press of an object on a bed, in the frame P of the pad's link.
struct BedPress {
  const FoundationBed& bed;
  const Shape& object;
  Pose<double> X_PO;       // current pose of the object
  Eigen::Vector3d inward;  // unit direction in which the object presses the pad (3)
  double friction;         // coefficient of friction [1]

  /// Returns the pose of the object at a depth [m].
  [[nodiscard]] Pose<double> pose_at(double depth) const {
    return {X_PO.R, X_PO.p + depth * inward};
  }
};

/// Computes the depth at which the springs push with a force; less if they would reach through a
/// thin wall, or be pressed flat [m].
double depth_of_force(const BedPress& press, double force, double thickness) {
  double from = -thickness, to = thickness;
  for (int i = 0; i < kPressBisections; ++i) {
    const double middle = (from + to) / 2;
    const BedContact contact = press.bed.press(press.object, press.pose_at(middle));
    (contact.force < force && !contact.behind ? from : to) = middle;
  }
  return from;
}

/// Presses the bed to the depth of a pad, distributes a tangential load over its springs, and sets
/// the results of the pad.
void add_press(const BedPress& press, double load, const Pose<double>& X_WP, LoadedPad& pad) {
  // Press along the normal to the depth of the pad.
  BedState state;
  const BedContact contact =
      press.bed.step(press.object, press.pose_at(pad.depth), press.friction, 0, state);
  const FoundationColumns& columns = press.bed.columns();
  // Distribute the load: a column of area A and height h has the shear stiffness G A / h.
  const Eigen::VectorXd stiffness =
      press.bed.constants().shear * columns.area.cwiseQuotient(columns.thickness);
  const ShearShares shares = share_shear(state.normal_force, stiffness, press.friction, load);
  pad.force = contact.force;
  pad.area = contact.area;
  pad.tangential = shares.borne;
  // Keep the springs in contact, and sum the force on those that stick.
  double sticking = 0;
  for (Eigen::Index i = 0; i < columns.area.size(); ++i) {
    const double normal = state.normal_force[i];
    if (normal <= 0) continue;
    const bool sticks = shares.sticks[i];
    pad.points.push_back({X_WP * columns.skin.col(i), normal / columns.area[i], sticks});
    sticking += sticks ? normal : 0;
  }
  pad.stick = contact.force > 0 ? sticking / contact.force : 1;
}

/// Computes the minimum forces of all contact points that hold the object's weight in its current
/// pose, object frame [N]; empty, with a reason, if they are unknown.
std::vector<Eigen::Vector3d> weight_shares(const LiveWorld& live, const GraspResult& grasp,
                                           std::vector<std::string>& reasons) {
  const GraspBody& object = grasp.setting.setup.object;
  const StateBody& body = live.state().bodies[object_index(live.state(), object.name)];
  // Compute the mass; without it there is no load.
  double mass = 0;
  try {
    mass = body_mass(body.built->placed.body, grasp.setting.world.materials).mass;
  } catch (const InputError& unknown) {
    reasons.push_back(fmt::format("no load across the pads: {}", unknown.what()));
    return {};
  }
  // Minimize the sum of the contact forces that hold the weight.
  const ScaledWrench load{-kGravity * mass * object.X_WB.R.transpose().col(2), {0, 0, 0}};
  const GraspForce hold =
      minimum_grasp_force(free_forces(grasp.wrenches), load, GraspForceObjective::kSum);
  if (hold.status != Status::kSolved) {
    reasons.emplace_back("no load across the pads: no forces within friction hold the weight");
    return {};
  }
  std::vector<Eigen::Vector3d> shares;
  for (const ScaledWrench& wrench : hold.forces.wrenches) shares.push_back(wrench.force);
  return shares;
}

/// Presses one patch to a force, and loads it tangentially; empty if it has no soft layer.
/// @param load  load on the object, object frame [N] (3)
std::optional<LoadedPad> pressed_pad(const GraspResult& grasp, const ContactPatch& patch,
                                     double force, const Eigen::Vector3d& load) {
  // Find the springs of the surface; a pad is soft only if its material has a layer.
  const GraspBody& object = grasp.setting.setup.object;
  const int s = patch.contacts[0].surface;
  const Hand& hand = *grasp.collision_hand.hand;
  const LinkSurface& surface = hand.surfaces()[s];
  const std::optional<FoundationConstants> springs =
      springs_of(grasp.setting.setup.materials.at(surface.material));
  if (!springs) return std::nullopt;
  // Build the bed in the link's frame P, under the object.
  const PosedCollisionHand posed{grasp.collision_hand, grasp.grasp.approached.X_WH,
                                 hand.pose(grasp.grasp.closed.q)};
  const Pose<double> X_WP = posed.surface_pose(s), X_PO = X_WP.inverse() * object.X_WB;
  const Eigen::Vector3d n = X_PO.R * mean_normal(patch);
  const FoundationBed bed(
      skin_columns(surface.solid->visual, X_PO * mean_point(patch), springs->thickness), *springs);
  const double friction = patch.contacts[0].contact.friction;
  const BedPress press{bed, *object.solid.shape, X_PO, -n, friction};
  // Press to the force, then apply the tangential part of the load.
  LoadedPad pad;
  pad.link = surface.name;
  pad.material = surface.material;
  pad.depth = depth_of_force(press, force, springs->thickness);
  const Eigen::Vector3d tangential = load - mean_normal(patch) * mean_normal(patch).dot(load);
  add_press(press, tangential.norm(), X_WP, pad);
  return pad;
}

/// Adds warnings about a pad that does not reach its force, or slips.
void add_pad_warnings(const LoadedPad& pad, double force, const std::string& object,
                      std::vector<std::string>& reasons) {
  if (pad.force < kMinForceRatio * force)
    reasons.push_back(fmt::format(
        "{} presses with {:.2g} N, not {:.2g} N: deeper, its springs are flat or reach through {}",
        pad.link, pad.force, force, object));
  if (pad.stick == 0) reasons.push_back(fmt::format("all of {} slips on {}", pad.link, object));
}

}  // namespace

LivePads press_pads(const LiveWorld& live, const LivePair& pair, double force) {
  require(std::isfinite(force) && force > 0, "wanted a force on pads above 0 N, got {}", force);
  const GraspResult grasp = current_grasp(live, pair);
  LivePads out;
  if (grasp.grasp.outcome != GraspOutcome::kGrasped) {
    out.reasons.push_back(fmt::format("hand '{}' does not touch '{}'",
                                      grasp.setting.hand.named.name,
                                      grasp.setting.setup.object.name));
    return out;
  }
  // Distribute the object's weight over the contact points.
  const std::vector<Eigen::Vector3d> shares = weight_shares(live, grasp, out.reasons);
  // Press every patch; the contact points of a patch are consecutive.
  std::size_t first = 0;
  for (const ContactPatch& patch : group_into_patches(grasp.grasp.contacts)) {
    Eigen::Vector3d load = Eigen::Vector3d::Zero();
    for (std::size_t i = first; i < first + patch.contacts.size() && i < shares.size(); ++i)
      load += shares[i];
    first += patch.contacts.size();
    // Keep the pad, or the reason why there is none.
    std::optional<LoadedPad> pad = pressed_pad(grasp, patch, force, load);
    if (pad) {
      add_pad_warnings(*pad, force, grasp.setting.setup.object.name, out.reasons);
      out.pads.push_back(std::move(*pad));
      continue;
    }
    const LinkSurface& surface = grasp.collision_hand.hand->surfaces()[patch.contacts[0].surface];
    out.reasons.push_back(fmt::format("{} is of {}, which has no soft layer: it has no pad",
                                      surface.name, surface.material));
  }
  return out;
}

}  // namespace thenar
