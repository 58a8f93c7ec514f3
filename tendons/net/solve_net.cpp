#include "tendons/net/solve_net.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "tendons/net/check_net.h"
#include "tendons/net/net_energy.h"
#include "tendons/net/node_contact.h"

namespace thenar {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Points = std::vector<Vector3d>;

constexpr double kCarried = 1e-9;  // gap of a start that counts as lying on the bone [m]
constexpr double kLongest = 0.02;  // longest move of a node in one step [m]
constexpr double kSmallPivot = 1e-13;

}  // namespace

struct NetSolver::Workspace {
  Workspace(const Net& net, const NetSolverOptions& wanted)
      : plan(net),
        options(wanted),
        at(plan),
        next(plan),
        reduced(plan.pattern),
        factor(plan.pattern),
        x(net.nodes.size()),
        x_next(net.nodes.size()),
        contact(plan.pattern.size()),
        contact_next(plan.pattern.size()),
        step(plan.pattern.size()) {}

  internal::NetPlan plan;
  NetSolverOptions options;
  internal::NetScene scene;
  internal::NetEnergy at, next;
  internal::BlockMatrix reduced;
  internal::BlockFactor factor;
  Points x, x_next;
  std::vector<internal::NodeContact> contact, contact_next;
  Points step;
  double residual = 0;

  int rows() const { return plan.pattern.size(); }

  /// Places all nodes and pushes those inside bones out.
  void place(const TreeState<double>& state, const Eigen::Matrix3Xd* start,
             std::vector<int>& pushed_out) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      const NetNode& node = plan.net.nodes[i];
      x[i] = node.free && start ? Vector3d(start->col(static_cast<Eigen::Index>(i)))
                                : moved(state, node.link, node.p);
    }
    for (int k = 0; k < rows(); ++k) {
      const int i = plan.node[k];
      const NetNode& node = plan.net.nodes[i];
      internal::NodeContact& touch = contact[k];
      touch.pressed = 0;
      double depth = 0;
      for (int s : node.surfaces) {
        const double gap = internal::probe_world(plan.net, scene, s, x[i]).gap;
        depth = std::min(depth, gap);
        if (std::abs(gap) <= kCarried && touch.pressed < 3) touch.surface[touch.pressed++] = s;
      }
      const Vector3d before = x[i];
      if (!internal::settle_node(plan.net, scene, node, x[i], touch)) {
        x[i] = before;
        touch.pressed = touch.touching = 0;
      }
      if (depth < -kCarried) pushed_out.push_back(i);
    }
  }

  void balance() {
    residual = 0;
    for (int k = 0; k < rows(); ++k) {
      internal::balance_node(plan.net, scene, x[plan.node[k]], at.g[k], options.tolerance,
                             contact[k]);
      residual = std::max(residual, contact[k].left.norm());
    }
  }

  /// H - sum force curvature, turned so that pressed normals come first, and these pinned.
  void reduce() {
    for (int k = 0; k < rows(); ++k) {
      const internal::NodeContact& c = contact[k];
      Matrix3d& D = reduced.diagonal[k];
      D = c.Q * (at.H.diagonal[k] - c.bend) * c.Q.transpose();
      step[k] = -(c.Q * at.g[k]);
      double scale = at.H.diagonal[k].trace();
      if (scale <= 0) scale = 1, D.setIdentity();  // nothing holds it: it stays
      for (int r = 0; r < c.pressed; ++r) {
        D.row(r).setZero();
        D.col(r).setZero();
        D(r, r) = scale;
        step[k](r) = 0;
      }
    }
    for (int s = 0; s < plan.pattern.blocks(); ++s) {
      const auto [i, j] = plan.pattern.rows_of(s);
      Matrix3d& B = reduced.off[s];
      B = contact[i].Q * at.H.off[s] * contact[j].Q.transpose();
      B.topRows(contact[i].pressed).setZero();
      B.leftCols(contact[j].pressed).setZero();
    }
  }

  /// Newton's direction, in world axes. @return whether the stiffness was positive definite
  bool direction() {
    reduce();
    double largest = 0;
    for (const Matrix3d& D : reduced.diagonal) largest = std::max(largest, D.cwiseAbs().maxCoeff());
    bool definite = factor.factorise(reduced, 0, kSmallPivot);
    double shift = std::max(residual / kLongest, 1e-9 * largest);
    for (bool done = definite; !done; shift *= 10)
      done = factor.factorise(reduced, shift, kSmallPivot);
    factor.solve(step);
    double longest = 0;
    for (int k = 0; k < rows(); ++k) {
      step[k] = contact[k].Q.transpose() * step[k].eval();
      longest = std::max(longest, step[k].norm());
    }
    if (longest > kLongest)
      for (Vector3d& d : step) d *= kLongest / longest;
    return definite;
  }

  /// Moves along the step by `part`, staying outside bones. @return slope of E along it [J]
  bool try_step(double part, double& slope) {
    x_next = x;
    slope = 0;
    for (int k = 0; k < rows(); ++k) {
      const int i = plan.node[k];
      contact_next[k] = contact[k];
      x_next[i] += part * step[k];
      const Vector3d wanted = x_next[i];
      if (plan.net.nodes[i].surfaces.empty()) {
        slope += at.g[k].dot(wanted - x[i]);
        continue;
      }
      if (!internal::settle_node(plan.net, scene, plan.net.nodes[i], x_next[i], contact_next[k]))
        return false;
      slope += contact_next[k].touching > contact[k].pressed ? at.g[k].dot(x_next[i] - x[i])
                                                             : part * at.g[k].dot(step[k]);
    }
    internal::evaluate(plan, scene, x_next, next);
    return true;
  }

  void accept() {
    x.swap(x_next);
    contact.swap(contact_next);
    std::swap(at, next);
  }

  /// Shortens the step until E falls. @return whether it did
  bool search() {
    const double noise = 1e-15 * (std::abs(at.energy) + 1e-12);
    for (double part = 1; part > 1e-12; part *= 0.5) {
      double slope = 0;
      if (!try_step(part, slope)) continue;
      if (next.energy <= at.energy + 1e-4 * std::min(slope, 0.0) + noise) {
        accept();
        return true;
      }
    }
    return false;
  }

  NetEquilibrium report() const;
};

NetEquilibrium NetSolver::Workspace::report() const {
  NetEquilibrium out;
  out.energy = at.energy;
  out.residual = residual;
  const auto nodes = static_cast<Eigen::Index>(x.size());
  const auto bands = static_cast<Eigen::Index>(plan.bands.size());
  out.x.resize(3, nodes);
  for (Eigen::Index i = 0; i < nodes; ++i) out.x.col(i) = x[static_cast<std::size_t>(i)];
  out.length.resize(bands);
  out.tension.resize(bands);
  std::vector<bool> held(x.size(), false);
  for (int b = 0; b < bands; ++b) {
    const NetBand& band = plan.net.bands[static_cast<std::size_t>(b)];
    const internal::BandState now = internal::band_state(plan.net, scene, b, x[band.a], x[band.b]);
    out.length(b) = now.chord.length;
    out.tension(b) = now.pull.tension;
    if (now.pull.tension > 0) held[band.a] = held[band.b] = true;
  }
  for (int k = 0; k < rows(); ++k)
    for (int c = 0; c < contact[k].pressed; ++c)
      out.contacts.push_back({plan.node[k], contact[k].surface[c],
                              std::max(contact[k].force[c], 0.0), contact[k].normal[c]});
  for (std::size_t i = 0; i < x.size(); ++i)
    if (plan.row[i] >= 0 && !held[i]) out.loose.push_back(static_cast<int>(i));
  return out;
}

NetSolver::NetSolver(const Net& net, const NetSolverOptions& options)
    : work_(std::make_unique<Workspace>(net, options)) {}
NetSolver::~NetSolver() = default;
NetSolver::NetSolver(NetSolver&&) noexcept = default;
NetSolver& NetSolver::operator=(NetSolver&&) noexcept = default;

NetEquilibrium NetSolver::solve(const TreeState<double>& state, const NetDrive& drive,
                                const Eigen::Matrix3Xd* start) {
  Workspace& w = *work_;
  check_drive(w.plan.net, drive);
  check_state(w.plan.net, state);
  require(!start || start->cols() == static_cast<Eigen::Index>(w.x.size()),
          "net {} has {} nodes, start has {}", w.plan.net.name, w.x.size(),
          start ? start->cols() : 0);
  require(!start || start->allFinite(), "net {}: start is not finite", w.plan.net.name);
  w.scene = internal::pose_scene(w.plan.net, state, drive);
  std::vector<int> pushed_out;
  w.place(state, start, pushed_out);
  internal::evaluate(w.plan, w.scene, w.x, w.at);
  int iterations = 0;
  NetStatus status = NetStatus::kStalled;
  for (;; ++iterations) {
    w.balance();
    if (w.residual <= w.options.tolerance) {
      status = NetStatus::kBalanced;
      break;
    }
    if (iterations >= w.options.max_iterations) break;
    w.direction();
    if (!w.search()) break;
  }
  NetEquilibrium out = w.report();
  out.status = status;
  out.iterations = iterations;
  out.pushed_out = std::move(pushed_out);
  return out;
}

}  // namespace thenar
