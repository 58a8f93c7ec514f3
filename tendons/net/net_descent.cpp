#include "tendons/net/net_descent.h"

#include <algorithm>
#include <utility>

#include "tendons/net/world_surface.h"

namespace thenar::internal {
namespace {

using Eigen::Vector3d;

constexpr double kCarried = 1e-9;  // gap of a start that counts as lying on the bone [m]
constexpr double kLying = 2e-5;    // gap of a start that is tried as lying on the bone [m]
constexpr double kHard = 10;       // pull at which taut nets swing freely [N]

}  // namespace

NetDescent::NetDescent(const Net& net, const NetSolverOptions& options)
    : plan_(net),
      options_(options),
      at_(plan_),
      next_(plan_),
      reduced_(plan_.pattern),
      factor_(plan_.pattern),
      x_(net.nodes.size()),
      x_next_(net.nodes.size()),
      step_(plan_.pattern.size()),
      contact_(plan_.pattern.size()),
      contact_next_(plan_.pattern.size()) {}

void NetDescent::settle_start(int k) {
  const int i = plan_.node[k];
  const NetNode& node = plan_.net.nodes[i];
  NodeContact& touch = contact_[k];
  touch.pressed = touch.touching = 0;
  touch.drawn = 0;
  double depth = 0;
  for (int s : node.surfaces) {
    const double gap = gap_world(plan_.net, scene_, s, x_[i]).gap;
    depth = std::min(depth, gap);
    if (std::abs(gap) <= kLying && touch.pressed < 3) touch.surface[touch.pressed++] = s;
  }
  const Vector3d before = x_[i];
  if (!settle_node(plan_.net, scene_, node, x_[i], touch)) {
    x_[i] = before;
    touch.pressed = touch.touching = 0;
  }
  if (depth < -kCarried) pushed_out_.push_back(i);
}

void NetDescent::place(const TreeState<double>& state, const Eigen::Matrix3Xd* start) {
  for (std::size_t i = 0; i < x_.size(); ++i) {
    const NetNode& node = plan_.net.nodes[i];
    x_[i] = node.free && start ? Vector3d(start->col(static_cast<Eigen::Index>(i)))
                               : moved(state, node.link, node.p);
  }
  pushed_out_.clear();
  for (int k = 0; k < rows(); ++k) settle_start(k);
  x_next_ = x_;
}

void NetDescent::accept() {
  x_.swap(x_next_);
  contact_.swap(contact_next_);
  std::swap(at_, next_);
}

NetStatus NetDescent::descend(int patience) {
  definite_ = false;
  radius_ = kLongest;
  for (iterations_ = 0;; ++iterations_) {
    balance();
    if (let_out()) {
      evaluate(plan_, scene_, x_, at_);
      balance();
    }
    if (residual_ <= options_.tolerance) {
      if (grip()) {
        evaluate(plan_, scene_, x_, at_);
        balance();
      } else if (steady()) {
        return NetStatus::kBalanced;
      } else if (!escape()) {
        return NetStatus::kUnstable;
      } else {
        continue;
      }
    }
    if (iterations_ >= patience) return NetStatus::kStalled;
    if (leave_ridge()) continue;
    if (!direction() || !search()) return NetStatus::kStalled;
  }
}

/// One descent from where the nodes are given.
NetStatus NetDescent::settle(const TreeState<double>& state, const NetDrive& drive,
                             const Eigen::Matrix3Xd* start, int patience) {
  scene_ = pose_scene(plan_.net, state, drive);
  draws_.assign(plan_.bands.size(), 0);
  place(state, start);
  evaluate(plan_, scene_, x_, at_);
  return descend(patience);
}

/// Weak pulls swing a taut net like a linkage, in steps as short as (8 pull L^2 / stiffness)^(1/3):
/// where that is too slow, the net is first pulled hard, and then ten times less each time.
NetStatus NetDescent::ease(const TreeState<double>& state, const NetDrive& drive) {
  const double most = drive.tension.size() > 0 ? drive.tension.maxCoeff() : 0;
  if (!(most > 0) || most > kHard) return NetStatus::kStalled;
  const std::vector<int> pushed_out = pushed_out_;
  int spent = iterations_;
  NetStatus status = NetStatus::kStalled;
  for (double times = kHard / most; times > 0; times = times == 1 ? 0 : std::max(times / 10, 1.0)) {
    Eigen::Matrix3Xd from(3, static_cast<Eigen::Index>(x_.size()));
    for (std::size_t i = 0; i < x_.size(); ++i) from.col(static_cast<Eigen::Index>(i)) = x_[i];
    const int patience = times == 1 ? options_.max_iterations : options_.max_iterations / 5;
    status = settle(state, {times * drive.tension, drive.length}, &from, patience);
    spent += iterations_;
  }
  iterations_ = spent;
  pushed_out_ = pushed_out;
  return status;
}

NetEquilibrium NetDescent::run(const TreeState<double>& state, const NetDrive& drive,
                               const Eigen::Matrix3Xd* start) {
  NetStatus status = settle(state, drive, start, options_.max_iterations / 2);
  if (status == NetStatus::kStalled && wound().empty()) status = ease(state, drive);
  if (status == NetStatus::kStalled && wound().empty()) status = descend(options_.max_iterations);
  return report(status);
}

}  // namespace thenar::internal
