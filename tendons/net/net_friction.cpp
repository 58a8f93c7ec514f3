#include "tendons/net/net_friction.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/lists.h"
#include "tendons/net/net.h"
#include "tendons/net/node_contact.h"

namespace thenar {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr double kOnBoneGap = 1e-9;      // gap within which a node is in contact [m]
constexpr double kNudgeDistance = 1e-7;  // first displacement of a node that starts to slip [m]
// Distance within which a node has returned to its start [m]
constexpr double kReturnDistance = 2e-9;
constexpr int kMaxReturns = 10;  // returns of a node to its start after which rounds end

/// Node that may be in contact with a bone, with its friction.
struct FrictionNode {
  int node;
  Vector3d start;       // position at its start [m] (3)
  bool sticks = false;  // true: held at its start
  double pull = 0;      // tension of its band while it slips [N]
  Vector3d n{0, 0, 0};  // normal of the contact (3)
  double normal = 0;    // normal force of the bone [N]
  Vector3d f{0, 0, 0};  // friction force of the bone, along the surface [N] (3)
  int returns = 0;
};

/// Fixed-point iteration between the equilibrium of the net and the friction of its nodes.
class FrictionRounds {
 public:
  FrictionRounds(const Net& net, const TreeState<double>& state, NetDrive drive,
                 const Matrix3Xd* start, const NetFrictionOptions& options)
      : net_(net), state_(state), drive_(std::move(drive)), options_(options), mu_(net.friction) {
    net_.friction = 0;
    if (drive_.length.size() == 0) drive_.length.setConstant(drive_.tension.size(), std::nan(""));
    scene_ = internal::pose_scene(net_, state_, drive_);
    place(start);
  }

  /// Iterates to convergence.
  NetFrictionRest run() {
    // Solve with the present friction, then update it by the contact forces.
    for (out_.iterations = 1; out_.iterations <= options_.max_iterations; ++out_.iterations) {
      solve();
      const bool switched = update_friction();
      out_.settled = !switched && out_.change < options_.tolerance &&
                     out_.rest.residual <= options_.solver.tolerance;
      if (out_.settled || has_cycled()) break;
    }
    out_.iterations = std::min(out_.iterations, options_.max_iterations);
    report();
    return out_;
  }

 private:
  [[nodiscard]] Pose<double> frame(int s) const { return scene_.surface[s]; }
  [[nodiscard]] SurfaceProbe probe_at(int s, const Vector3d& x) const {
    return internal::probe_world(net_, scene_, s, x);
  }

  /// Places nodes on their bones; those in contact stick until their friction is exceeded.
  void place(const Matrix3Xd* start) {
    x_.resize(3, static_cast<Eigen::Index>(net_.nodes.size()));
    for (int i = 0; i < static_cast<int>(net_.nodes.size()); ++i) {
      const NetNode& node = net_.nodes[i];
      // Place the node, and test for contact.
      Vector3d x = moved(state_, node.link, node.p);
      if (start && node.free) x = start->col(i);
      FrictionNode friction{i, x};
      for (int s : node.free ? node.surfaces : std::vector<int>{}) {
        const BoneSurface& bone = net_.surfaces[s];
        if (probe_at(s, x).gap < 0) x = frame(s) * nearest_point(bone, frame(s).inverse() * x);
        friction.sticks |= probe_at(s, x).gap < kOnBoneGap;
      }
      // Let nodes in contact stick at first.
      friction.start = x;
      friction.sticks = friction.sticks && mu_ > 0;
      if (node.free && !node.surfaces.empty()) friction_nodes_.push_back(friction);
      x_.col(i) = x;
    }
  }

  /// Solves the net with sticking nodes held and slipping ones pulled back.
  void solve() {
    Net net = net_;
    NetDrive drive = drive_;
    Matrix3Xd start = x_;
    const auto add_column = [&](const Vector3d& p) {
      start.conservativeResize(3, start.cols() + 1);
      start.col(start.cols() - 1) = p;
    };
    for (const FrictionNode& friction : friction_nodes_) {
      // Fix a sticking node in space.
      NetNode& node = net.nodes[friction.node];
      if (friction.sticks) node.free = false, node.link = -1, node.p = friction.start;
      if (friction.sticks || friction.pull <= 0) continue;
      // Pull a slipping node back by a band of constant tension.
      NetBand band{"friction of " + node.name, friction.node, static_cast<int>(net.nodes.size())};
      band.muscle = static_cast<int>(net.muscles.size());
      net.muscles.push_back(band.name);
      net.bands.push_back(band);
      net.nodes.push_back({band.name, false, -1, friction.start, {}});
      add_column(friction.start);
      drive.tension.conservativeResize(drive.tension.size() + 1);
      drive.length.conservativeResize(drive.tension.size());
      drive.tension.tail<1>()(0) = friction.pull;
      drive.length.tail<1>()(0) = std::nan("");
    }
    out_.rest = NetSolver(net, options_.solver).solve(state_, drive, &start);
    remove_friction_bands();
  }

  /// Removes friction bands and their nodes from the result.
  void remove_friction_bands() {
    NetEquilibrium& rest = out_.rest;
    // Reduce energy and arrays to the given net.
    const auto bands = static_cast<Eigen::Index>(net_.bands.size());
    for (Eigen::Index b = bands; b < rest.tension.size(); ++b)
      rest.energy -= rest.tension(b) * rest.length(b);
    rest.x = rest.x.leftCols(x_.cols()).eval();
    rest.length = rest.length.head(bands).eval();
    rest.tension = rest.tension.head(bands).eval();
    // Ignore collapsed friction bands.
    const auto foreign = [&](const CollapsedBand& collapsed) { return collapsed.band >= bands; };
    erase_where(rest.collapsed, foreign);
    if (rest.status == NetStatus::kNodeCollapsed && rest.collapsed.empty())
      rest.status = NetStatus::kBalanced;
    x_ = rest.x;
  }

  /// Computes the force of all bands on a node.
  [[nodiscard]] Vector3d band_force_on(int node) const {
    Vector3d f = Vector3d::Zero();
    for (std::size_t b = 0; b < net_.bands.size(); ++b) {
      const NetBand& band = net_.bands[b];
      if (band.a != node && band.b != node) continue;
      const WrappedString chord =
          internal::band_string(net_, scene_, static_cast<int>(b), x_.col(band.a), x_.col(band.b));
      const double T = out_.rest.tension(static_cast<Eigen::Index>(b));
      f -= T * (band.a == node ? chord.slope.head<3>() : chord.slope.tail<3>());
    }
    return f;
  }

  /// Decides by the contact forces which nodes stick and which slip.
  /// @return whether a node changed between the two
  bool update_friction() {
    out_.change = 0;
    bool switched = false;
    for (FrictionNode& friction : friction_nodes_)
      switched |= friction.sticks ? starts_to_slip(friction) : returns_to_start(friction);
    return switched;
  }

  /// Computes the bone's force on a sticking node, and returns whether it exceeds friction, so that
  /// the node starts to slip.
  bool starts_to_slip(FrictionNode& friction) {
    // Compute the force that the bone must balance.
    const Vector3d f = band_force_on(friction.node);
    friction.normal = 0;
    friction.f = -f;
    friction.n.setZero();
    // Take the normal force on the surface that is pressed most.
    for (int s : net_.nodes[friction.node].surfaces) {
      const SurfaceProbe seen = probe_at(s, friction.start);
      if (seen.gap > kOnBoneGap || -f.dot(seen.normal) <= friction.normal) continue;
      friction.normal = -f.dot(seen.normal);
      friction.n = seen.normal;
      friction.f = -(f + friction.normal * friction.n);
    }
    // Keep sticking within the friction cone.
    if (friction.f.norm() <= mu_ * friction.normal * (1 + 1e-12)) return false;
    // Otherwise start to slip, against the friction force.
    friction.sticks = false;
    friction.pull = mu_ * friction.normal;
    x_.col(friction.node) -= kNudgeDistance * friction.f.normalized();
    return true;
  }

  /// Computes the bone's force on a slipping node, and returns whether the node is back at its
  /// start. Its band runs obliquely into the bone: of its pull t, t cos(angle) = mu N is friction,
  /// and t sin(angle) is part of the bone's normal force.
  bool returns_to_start(FrictionNode& friction) {
    const Vector3d way = friction.start - x_.col(friction.node);
    // Sum normal force and normal over the contacts.
    double pressed = 0;
    friction.n.setZero();
    for (const NetContact& contact : out_.rest.contacts)
      if (contact.node == friction.node && contact.force > 0) {
        pressed += contact.force;
        friction.n += contact.force * contact.normal;
      }
    // Let a node back at its start stick, unless it has returned too often.
    if (friction.pull > 0 && way.norm() < kReturnDistance) {
      friction.sticks = ++friction.returns <= kMaxReturns;
      x_.col(friction.node) = friction.start;
      return true;
    }
    // Compute friction along the surface, and the normal force without the band's part.
    const Vector3d u = way.norm() > 0 ? Vector3d(way.normalized()) : Vector3d::Zero();
    if (pressed > 0) friction.n.normalize();
    const double into = -u.dot(friction.n), along = (u + into * friction.n).norm();
    friction.normal = std::max(pressed - friction.pull * into, 0.0);
    friction.f = friction.pull * (u + into * friction.n);
    // Set the pull required by Coulomb's law.
    const double wanted = along > 0 ? mu_ * friction.normal / along : 0;
    out_.change = std::max(out_.change, std::abs(wanted - friction.pull));
    friction.pull = wanted;
    return false;
  }

  [[nodiscard]] bool has_cycled() const {
    return any_of(friction_nodes_,
                  [](const FrictionNode& friction) { return friction.returns > kMaxReturns; });
  }

  /// Reports the forces of bones on nodes, in place of contacts that include the pull of friction
  /// bands.
  void report() {
    for (const FrictionNode& friction : friction_nodes_) {
      // Report nodes under a normal force.
      if (friction.normal <= 0) continue;
      const double slip = (friction.start - x_.col(friction.node)).norm();
      out_.nodes.push_back({friction.node, friction.sticks, friction.normal, friction.f, slip});
      // Correct the contact to the normal force without friction.
      auto& contacts = out_.rest.contacts;
      const auto mine = [&](const NetContact& contact) { return contact.node == friction.node; };
      const auto first = std::find_if(contacts.begin(), contacts.end(), mine);
      if (first == contacts.end())
        contacts.push_back({friction.node, surface_of(friction), friction.normal, friction.n});
      else if (std::count_if(contacts.begin(), contacts.end(), mine) == 1)
        first->force = friction.normal;
    }
  }

  /// Returns the surface on which a node sticks.
  [[nodiscard]] int surface_of(const FrictionNode& friction) const {
    for (int s : net_.nodes[friction.node].surfaces)
      if (probe_at(s, friction.start).normal == friction.n) return s;
    return -1;
  }

  Net net_;  // the net with zero friction
  const TreeState<double>& state_;
  NetDrive drive_;
  NetFrictionOptions options_;
  double mu_;
  internal::NetScene scene_;
  std::vector<FrictionNode> friction_nodes_;
  Matrix3Xd x_;
  NetFrictionRest out_;
};

}  // namespace

NetFrictionRest solve_net_friction(const Net& net, const TreeState<double>& state,
                                   const NetDrive& drive, const Matrix3Xd* start,
                                   const NetFrictionOptions& options) {
  // Check the input as for a net without friction.
  require(net.friction >= 0 && std::isfinite(net.friction),
          "net {}: friction must be finite and >= 0, got {}", net.name, net.friction);
  Net smooth = net;
  smooth.friction = 0;
  check_net(smooth);
  check_drive(smooth, drive);
  check_state(smooth, state);
  check_start(net, start);
  return FrictionRounds(net, state, drive, start, options).run();
}

}  // namespace thenar
