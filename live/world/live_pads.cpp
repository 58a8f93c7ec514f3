#include "live/world/live_pads.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "grasp/contact/soft_pads.h"
#include "grasp/limits/grasp_force.h"
#include "pad_laws/foundation_bed.h"

namespace thenar {
namespace {

constexpr double kPieceOfSkin = 7e-4;   // longest side of a spring's piece of skin [m]
constexpr double kReachOfBed = 10e-3;   // of the springs around a contact [m]
constexpr double kWeightOfMass = 9.81;  // [m/s^2]
constexpr int kPressBisections = 36;    // of a press, down to picometres
constexpr int kShearBisections = 60;    // of a way across, which costs nothing
constexpr double kNearForce = 0.98;     // of the force that was asked for [1]

/// Returns the constants of the pad's springs by its material; empty if the pad is rigid.
std::optional<FoundationConstants> springs_of(const Material& material) {
  // A calibrated bed has its own constants; otherwise take Young's modulus over the thickness of
  // the layer.
  if (material.bed != nullptr) {
    FoundationConstants bed = *material.bed;
    if (bed.thickness <= 0) bed.thickness = material.layer_thickness;
    return bed;
  }
  if (material.young <= 0 || material.layer_thickness <= 0) return std::nullopt;
  FoundationConstants plain;
  plain.modulus = material.young;
  plain.thickness = material.layer_thickness;
  plain.shear = material.young / 3;  // of an incompressible layer
  return plain;
}

/// Pieces of the triangles that lie near a point, none of them longer than kPieceOfSkin.
std::vector<Eigen::Matrix3d> pieces_near(const TriangleMesh& mesh, const Eigen::Vector3d& p) {
  // Begin with all triangles of the link.
  std::vector<Eigen::Matrix3d> todo, pieces;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    Eigen::Matrix3d corners;
    for (int i = 0; i < 3; ++i) corners.col(i) = mesh.vertices.col(mesh.triangles(i, t));
    todo.push_back(corners);
  }
  // Halve triangles until they are small; drop those out of reach.
  while (!todo.empty()) {
    const Eigen::Matrix3d corners = todo.back();
    todo.pop_back();
    const double size = std::max({(corners.col(0) - corners.col(1)).norm(),
                                  (corners.col(1) - corners.col(2)).norm(),
                                  (corners.col(2) - corners.col(0)).norm()});
    if ((corners.rowwise().mean() - p).norm() > kReachOfBed + size) continue;
    if (size <= kPieceOfSkin) {
      pieces.push_back(corners);
      continue;
    }
    for (const Eigen::Matrix3d& half : internal::halves(corners)) todo.push_back(half);
  }
  return pieces;
}

/// Springs under the skin near a point. @param p  the link's frame [m] (3)
FoundationColumns columns_near(const TriangleMesh& skin, const Eigen::Vector3d& p,
                               double thickness) {
  // Integrate the pressure over the pieces: each stands for a spring of its area.
  const std::vector<Eigen::Matrix3d> pieces = pieces_near(skin, p);
  const auto count = static_cast<Eigen::Index>(pieces.size());
  FoundationColumns columns;
  columns.skin.resize(3, count);
  columns.normal.resize(3, count);
  columns.thickness = Eigen::VectorXd::Constant(count, thickness);
  columns.area.resize(count);
  // One spring for each piece, along its normal.
  Eigen::Index kept = 0;
  for (const Eigen::Matrix3d& corners : pieces) {
    const Eigen::Vector3d n =
        (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0));
    if (n.norm() < 1e-14) continue;  // a sliver bears nothing [m^2]
    columns.skin.col(kept) = corners.rowwise().mean();
    columns.normal.col(kept) = n.normalized();
    columns.area[kept++] = n.norm() / 2;
  }
  columns.skin.conservativeResize(3, kept);
  columns.normal.conservativeResize(3, kept);
  columns.thickness.conservativeResize(kept);
  columns.area.conservativeResize(kept);
  return columns;
}

Eigen::Vector3d mean_place(const ContactPatch& patch) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const HandContact& each : patch.contacts) sum += each.contact.p;
  return sum / static_cast<double>(patch.contacts.size());
}

Eigen::Vector3d mean_normal(const ContactPatch& patch) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const HandContact& each : patch.contacts) sum += each.contact.n;
  return sum.normalized();
}

/// A pad under an object, in the link's frame.
struct BedPress {
  const FoundationBed& bed;
  const Shape& object;
  Pose<double> X_PO;       // of the object as it stands
  Eigen::Vector3d inward;  // unit: the way in which the object presses the pad (3)
  double friction;

  [[nodiscard]] Pose<double> moved(double depth) const { return {X_PO.R, X_PO.p + depth * inward}; }
};

/// Depth at which the springs push with a force; less where they would reach through a thin wall,
/// or be pressed flat.
double depth_of_force(const BedPress& press, double force, double thickness) {
  double from = -thickness, to = thickness;
  for (int i = 0; i < kPressBisections; ++i) {
    const double middle = (from + to) / 2;
    const BedContact contact = press.bed.press(press.object, press.moved(middle));
    (contact.force < force && !contact.behind ? from : to) = middle;
  }
  return from;
}

/// Presses the bed, shares the load across among its springs, and adds what presses to the pad.
void add_press(const BedPress& press, double load, const Pose<double>& X_WP, PadOnObject& pad) {
  // Press along the normal; depth was chosen to give the force.
  BedState state;
  const BedContact contact =
      press.bed.step(press.object, press.moved(pad.depth), press.friction, 0, state);
  const FoundationColumns& columns = press.bed.columns();
  // A column of area A and height h that is sheared by s bears G A s / h.
  const Eigen::VectorXd stiffness =
      press.bed.constants().shear * columns.area.cwiseQuotient(columns.thickness);
  const ShearShares shares = share_shear(state.normal_force, stiffness, press.friction, load);
  pad.force = contact.force;
  pad.area = contact.area;
  pad.tangential = shares.borne;
  // Keep the springs that press, and the share of the force on those that stick.
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

/// Forces of all contact points that hold the object's weight as it stands, object's frame [N];
/// none, with a reason, where they are not known.
std::vector<Eigen::Vector3d> weight_shares(const LiveWorld& live, const GraspResult& grasp,
                                           std::vector<std::string>& reasons) {
  const GraspBody& object = grasp.setting.setup.object;
  const StateBody& body = live.state().bodies[object_index(live.state(), object.name)];
  // The mass may be unknown: then there is no load.
  double mass = 0;
  try {
    mass = body_mass(body.built->placed.body, grasp.setting.world.materials).mass;
  } catch (const InputError& unknown) {
    reasons.push_back(fmt::format("no load across the pads: {}", unknown.what()));
    return {};
  }
  // Find the least contact forces that hold the weight.
  const ScaledWrench load{-kWeightOfMass * mass * object.X_WB.R.transpose().col(2), {0, 0, 0}};
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

/// A patch pressed, and pushed across by a load. @param load  on the object, its frame [N] (3)
std::optional<PadOnObject> pressed_pad(const GraspResult& grasp, const ContactPatch& patch,
                                       double force, const Eigen::Vector3d& load) {
  // A pad is soft only if its material states a layer.
  const GraspBody& object = grasp.setting.setup.object;
  const int s = patch.contacts[0].surface;
  const Hand& hand = *grasp.collision_hand.hand;
  const LinkSurface& surface = hand.surfaces()[s];
  const std::optional<FoundationConstants> springs =
      springs_of(grasp.setting.setup.materials.at(surface.material));
  if (!springs) return std::nullopt;
  // The bed in the link's frame, under the object.
  const PosedCollisionHand posed{grasp.collision_hand, grasp.grasp.approached.X_WH,
                                 hand.pose(grasp.grasp.closed.q)};
  const Pose<double> X_WP = posed.surface_pose(s), X_PO = X_WP.inverse() * object.X_WB;
  const Eigen::Vector3d n = X_PO.R * mean_normal(patch);
  const FoundationBed bed(
      columns_near(surface.solid->visual, X_PO * mean_place(patch), springs->thickness), *springs);
  const double friction = patch.contacts[0].contact.friction;
  const BedPress press{bed, *object.solid.shape, X_PO, -n, friction};
  // Press to the force, then share the load across the normal.
  PadOnObject pad;
  pad.link = surface.name;
  pad.material = surface.material;
  pad.depth = depth_of_force(press, force, springs->thickness);
  const Eigen::Vector3d across = load - mean_normal(patch) * mean_normal(patch).dot(load);
  add_press(press, across.norm(), X_WP, pad);
  return pad;
}

/// Adds warnings about a pad that does not reach its force, or slips.
void tell_pad(const PadOnObject& pad, double force, const std::string& object,
              std::vector<std::string>& reasons) {
  if (pad.force < kNearForce * force)
    reasons.push_back(fmt::format(
        "{} presses with {:.2g} N, not {:.2g} N: deeper, its springs are flat or reach through {}",
        pad.link, pad.force, force, object));
  if (pad.stick == 0) reasons.push_back(fmt::format("all of {} slips on {}", pad.link, object));
}

}  // namespace

ShearShares share_shear(const Eigen::VectorXd& normal, const Eigen::VectorXd& stiffness,
                        double friction, double load) {
  // Each spring bears friction times its normal force at most, then slips.
  const Eigen::VectorXd most = friction * normal.cwiseMax(0);
  const auto borne = [&](double way) { return (way * stiffness).cwiseMin(most).sum(); };
  // The way at which the last spring slips.
  double from = 0, to = 0;
  for (Eigen::Index i = 0; i < most.size(); ++i)
    if (most[i] > 0) to = std::max(to, most[i] / stiffness[i]);
  // Below the largest load, find the way across at which the springs bear it.
  if (load < borne(to))
    for (int i = 0; i < kShearBisections; ++i) {
      const double middle = (from + to) / 2;
      (borne(middle) < load ? from : to) = middle;
    }
  ShearShares shares;
  shares.borne = borne(to);
  for (Eigen::Index i = 0; i < most.size(); ++i)
    shares.sticks.push_back(most[i] > 0 && to * stiffness[i] < most[i]);
  return shares;
}

LivePads press_pads(const LiveWorld& live, const LivePair& pair, double force) {
  require(std::isfinite(force) && force > 0, "wanted a force on pads above 0 N, got {}", force);
  const GraspResult grasp = standing_grasp(live, pair);
  LivePads out;
  if (grasp.grasp.outcome != GraspOutcome::kGrasped) {
    out.reasons.push_back(fmt::format("hand '{}' does not touch '{}'",
                                      grasp.setting.hand.named.name,
                                      grasp.setting.setup.object.name));
    return out;
  }
  // The load across comes from the object's weight, shared among contacts.
  const std::vector<Eigen::Vector3d> shares = weight_shares(live, grasp, out.reasons);
  // Contacts of a patch follow each other.
  std::size_t first = 0;
  for (const ContactPatch& patch : group_into_patches(grasp.grasp.contacts)) {
    Eigen::Vector3d load = Eigen::Vector3d::Zero();
    for (std::size_t i = first; i < first + patch.contacts.size() && i < shares.size(); ++i)
      load += shares[i];
    first += patch.contacts.size();
    // A patch without a soft layer has no pad, and says so.
    std::optional<PadOnObject> pad = pressed_pad(grasp, patch, force, load);
    if (pad) {
      tell_pad(*pad, force, grasp.setting.setup.object.name, out.reasons);
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
