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

constexpr double kOnBoneGap = 1e-9;  // Starts within this gap lie on the bone [m]
constexpr double kNudgeWay = 1e-7;   // First displacement of a node that starts to slip [m]
// A node within this distance of its start has returned [m]
constexpr double kReturnDistance = 2e-9;
constexpr int kMaxReturns = 10;  // Most returns of a node to its start before rounds are given up

/// A node that may rest on a bone.
struct Rub {
  int node;
  Vector3d seat;        // where it started [m]
  bool sticks = false;  // held there
  double pull = 0;      // of its band while it slips [N]
  Vector3d n{0, 0, 0};  // normal that it is pressed along
  double normal = 0;    // force of the bone [N]
  Vector3d f{0, 0, 0};  // along the surface [N]
  int returns = 0;
};

class Rounds {
 public:
  Rounds(const Net& net, const TreeState<double>& state, NetDrive drive, const Matrix3Xd* start,
         const NetFrictionOptions& options)
      : net_(net), state_(state), drive_(std::move(drive)), options_(options), mu_(net.friction) {
    net_.friction = 0;
    if (drive_.length.size() == 0) drive_.length.setConstant(drive_.tension.size(), std::nan(""));
    scene_ = internal::pose_scene(net_, state_, drive_);
    place(start);
  }

  NetFrictionRest run() {
    // Solve with the present friction, then judge it by the forces found.
    for (out_.iterations = 1; out_.iterations <= options_.max_iterations; ++out_.iterations) {
      solve();
      const bool switched = judge();
      out_.settled = !switched && out_.change < options_.tolerance &&
                     out_.rest.residual <= options_.solver.tolerance;
      if (out_.settled || gives_up()) break;
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

  /// Seats nodes on their bones; those that touch one stick until they are seen to give way.
  void place(const Matrix3Xd* start) {
    x_.resize(3, static_cast<Eigen::Index>(net_.nodes.size()));
    for (int i = 0; i < static_cast<int>(net_.nodes.size()); ++i) {
      const NetNode& node = net_.nodes[i];
      // Place of the node, and whether it touches a bone.
      Vector3d x = moved(state_, node.link, node.p);
      if (start && node.free) x = start->col(i);
      Rub rub{i, x};
      for (int s : node.free ? node.surfaces : std::vector<int>{}) {
        const BoneSurface& bone = net_.surfaces[s];
        if (probe_at(s, x).gap < 0) x = frame(s) * nearest_point(bone, frame(s).inverse() * x);
        rub.sticks |= probe_at(s, x).gap < kOnBoneGap;
      }
      // Nodes at bones stick at first.
      rub.seat = x;
      rub.sticks = rub.sticks && mu_ > 0;
      if (node.free && !node.surfaces.empty()) rubs_.push_back(rub);
      x_.col(i) = x;
    }
  }

  /// Brings the net to rest with nodes that stick held and those that slip pulled back.
  void solve() {
    Net net = net_;
    NetDrive drive = drive_;
    Matrix3Xd start = x_;
    const auto add_column = [&](const Vector3d& p) {
      start.conservativeResize(3, start.cols() + 1);
      start.col(start.cols() - 1) = p;
    };
    for (const Rub& rub : rubs_) {
      // A sticking node is fixed in space.
      NetNode& node = net.nodes[rub.node];
      if (rub.sticks) node.free = false, node.link = -1, node.p = rub.seat;
      if (rub.sticks || rub.pull <= 0) continue;
      // A slipping node is drawn back by a band of constant pull.
      NetBand band{"friction of " + node.name, rub.node, static_cast<int>(net.nodes.size())};
      band.muscle = static_cast<int>(net.muscles.size());
      net.muscles.push_back(band.name);
      net.bands.push_back(band);
      net.nodes.push_back({band.name, false, -1, rub.seat, {}});
      add_column(rub.seat);
      drive.tension.conservativeResize(drive.tension.size() + 1);
      drive.length.conservativeResize(drive.tension.size());
      drive.tension.tail<1>()(0) = rub.pull;
      drive.length.tail<1>()(0) = std::nan("");
    }
    out_.rest = NetSolver(net, options_.solver).solve(state_, drive, &start);
    forget_friction();
  }

  /// Leaves the given net's own nodes and bands in the answer.
  void forget_friction() {
    NetEquilibrium& rest = out_.rest;
    // Energy and arrays of the given net alone.
    const auto bands = static_cast<Eigen::Index>(net_.bands.size());
    for (Eigen::Index b = bands; b < rest.tension.size(); ++b)
      rest.energy -= rest.tension(b) * rest.length(b);
    rest.x = rest.x.leftCols(x_.cols()).eval();
    rest.length = rest.length.head(bands).eval();
    rest.tension = rest.tension.head(bands).eval();
    // A friction band that collapsed is no finding about the net.
    const auto foreign = [&](const CollapsedBand& collapsed) { return collapsed.band >= bands; };
    erase_where(rest.collapsed, foreign);
    if (rest.status == NetStatus::kNodeCollapsed && rest.collapsed.empty())
      rest.status = NetStatus::kBalanced;
    x_ = rest.x;
  }

  /// Force of all bands on a node.
  [[nodiscard]] Vector3d pull_on(int node) const {
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

  /// Decides by the forces found which nodes stick and which slip.
  /// @return whether a node changed sides
  bool judge() {
    out_.change = 0;
    bool switched = false;
    for (Rub& rub : rubs_) switched |= rub.sticks ? gives_way(rub) : comes_back(rub);
    return switched;
  }

  /// Computes the bone's force on a node that sticks, and returns whether it exceeds friction, so
  /// that the node starts to slip.
  bool gives_way(Rub& rub) {
    // Force that the bone must balance.
    const Vector3d f = pull_on(rub.node);
    rub.normal = 0;
    rub.f = -f;
    rub.n.setZero();
    // Its normal part: on the surface that is pressed most.
    for (int s : net_.nodes[rub.node].surfaces) {
      const SurfaceProbe seen = probe_at(s, rub.seat);
      if (seen.gap > kOnBoneGap || -f.dot(seen.normal) <= rub.normal) continue;
      rub.normal = -f.dot(seen.normal);
      rub.n = seen.normal;
      rub.f = -(f + rub.normal * rub.n);
    }
    // Within the friction cone it sticks.
    if (rub.f.norm() <= mu_ * rub.normal * (1 + 1e-12)) return false;
    // Otherwise it starts to slip, against the friction force.
    rub.sticks = false;
    rub.pull = mu_ * rub.normal;
    x_.col(rub.node) -= kNudgeWay * rub.f.normalized();
    return true;
  }

  /// Computes the bone's force on a node that slips, and returns whether the node is back at its
  /// start. Its band runs aslant into the bone: of its pull t, t cos(angle) = mu N is friction, and
  /// t sin(angle) is part of the bone's normal force.
  bool comes_back(Rub& rub) {
    const Vector3d way = rub.seat - x_.col(rub.node);
    // Normal force and normal of the contacts.
    double pressed = 0;
    rub.n.setZero();
    for (const NetContact& contact : out_.rest.contacts)
      if (contact.node == rub.node && contact.force > 0) {
        pressed += contact.force;
        rub.n += contact.force * contact.normal;
      }
    // Back at its start: it sticks, unless it has returned too often.
    if (rub.pull > 0 && way.norm() < kReturnDistance) {
      rub.sticks = ++rub.returns <= kMaxReturns;
      x_.col(rub.node) = rub.seat;
      return true;
    }
    // Friction along the surface, and the normal force without the band's part.
    const Vector3d u = way.norm() > 0 ? Vector3d(way.normalized()) : Vector3d::Zero();
    if (pressed > 0) rub.n.normalize();
    const double into = -u.dot(rub.n), along = (u + into * rub.n).norm();
    rub.normal = std::max(pressed - rub.pull * into, 0.0);
    rub.f = rub.pull * (u + into * rub.n);
    // Pull that Coulomb's law asks for.
    const double wanted = along > 0 ? mu_ * rub.normal / along : 0;
    out_.change = std::max(out_.change, std::abs(wanted - rub.pull));
    rub.pull = wanted;
    return false;
  }

  [[nodiscard]] bool gives_up() const {
    return any_of(rubs_, [](const Rub& rub) { return rub.returns > kMaxReturns; });
  }

  /// Writes what bones do to nodes, in place of contacts that hold what friction bands pull
  /// inwards.
  void report() {
    for (const Rub& rub : rubs_) {
      // Nodes that are pressed.
      if (rub.normal <= 0) continue;
      const double slip = (rub.seat - x_.col(rub.node)).norm();
      out_.nodes.push_back({rub.node, rub.sticks, rub.normal, rub.f, slip});
      // The contact shows the normal force without friction.
      auto& contacts = out_.rest.contacts;
      const auto mine = [&](const NetContact& contact) { return contact.node == rub.node; };
      const auto first = std::find_if(contacts.begin(), contacts.end(), mine);
      if (first == contacts.end())
        contacts.push_back({rub.node, surface_of(rub), rub.normal, rub.n});
      else if (std::count_if(contacts.begin(), contacts.end(), mine) == 1)
        first->force = rub.normal;
    }
  }

  /// The surface that it sticks on.
  [[nodiscard]] int surface_of(const Rub& rub) const {
    for (int s : net_.nodes[rub.node].surfaces)
      if (probe_at(s, rub.seat).normal == rub.n) return s;
    return -1;
  }

  Net net_;  // without friction
  const TreeState<double>& state_;
  NetDrive drive_;
  NetFrictionOptions options_;
  double mu_;
  internal::NetScene scene_;
  std::vector<Rub> rubs_;
  Matrix3Xd x_;
  NetFrictionRest out_;
};

}  // namespace

NetFrictionRest solve_net_friction(const Net& net, const TreeState<double>& state,
                                   const NetDrive& drive, const Matrix3Xd* start,
                                   const NetFrictionOptions& options) {
  // Input, checked as for a net without friction.
  require(net.friction >= 0 && std::isfinite(net.friction),
          "net {}: friction must be finite and >= 0, got {}", net.name, net.friction);
  Net smooth = net;
  smooth.friction = 0;
  check_net(smooth);
  check_drive(smooth, drive);
  check_state(smooth, state);
  const auto nodes = static_cast<Eigen::Index>(net.nodes.size());
  require(start == nullptr || start->cols() == nodes, "net {} has {} nodes, start has {}", net.name,
          nodes, start ? start->cols() : 0);
  require(start == nullptr || start->allFinite(), "net {}: start is not finite", net.name);
  return Rounds(net, state, drive, start, options).run();
}

}  // namespace thenar
