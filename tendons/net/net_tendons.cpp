#include "tendons/net/net_tendons.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/ranges.h>

#include "base/error.h"
#include "base/lists.h"
#include "tendons/net/net_derivatives.h"
#include "tendons/net/net_follower.h"
#include "tendons/net/net_pull.h"
#include "tendons/net/net_statics.h"
#include "tendons/path.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Sums the tensions of some bands.
double sum_of(const VectorXd& tension, const std::vector<int>& bands) {
  double sum = 0;
  for (int b : bands) sum += tension[b];
  return sum;
}

/// Describes the overstrained band with the largest tension.
std::string overstrained(const Net& net, const NetEquilibrium& rest) {
  const int worst =
      *std::max_element(rest.overstrained.begin(), rest.overstrained.end(),
                        [&](int a, int b) { return rest.tension[a] < rest.tension[b]; });
  const NetBand& band = net.bands[worst];
  double pull = 0;
  for (std::size_t b = 0; b < net.bands.size(); ++b)
    if (net.bands[b].muscle >= 0) pull += rest.tension[b];
  return fmt::format(
      "net '{}' is balanced only by bands that carry more than tissue can: '{}' has {:.3g} N under "
      "pulls of {:.3g} N, and a strain of {:.2g} %",
      net.name, band.name, rest.tension[worst], pull, 100 * (rest.length[worst] / band.slack - 1));
}

/// Describes the first band in tension that ends inside the bone over which it bends; empty: none.
std::string buried_band(const Net& net, const TreeState<double>& state,
                        const NetEquilibrium& rest) {
  constexpr double kInsideDepth = 1e-8;  // depth inside a bone above the solver's rounding [m]
  for (std::size_t b = 0; b < net.bands.size(); ++b) {
    const NetBand& band = net.bands[b];
    const double slack = band.EA * net.blend / 2;  // tension at the slack length [N]
    // Test the ends of taut bands.
    if (band.over < 0 || rest.tension[b] <= slack) continue;
    const BoneSurface& bone = net.surfaces[band.over];
    const Pose<double> X = surface_pose(bone, state);
    for (int end : {band.a, band.b})
      if (probe(bone, X.inverse() * Eigen::Vector3d(rest.x.col(end))).gap < -kInsideDepth)
        return fmt::format("band '{}' of net '{}' ends inside '{}', over which it bends", band.name,
                           net.name, bone.name);
  }
  return "";
}

}  // namespace

void add_warning(const std::string& more, TendonTorque& pull) {
  if (!pull.warning.empty() && !more.empty()) pull.warning += "; ";
  pull.warning += more;
}

std::string drawn_band_names(const Net& net, const std::vector<int>& bands) {
  if (bands.empty()) return "";
  std::vector<std::string> which;
  for (const int b : bands) {
    const NetBand& band = net.bands[b];
    which.push_back(fmt::format("'{}' has drawn in '{}'", band.name, net.nodes[band.a].name));
  }
  return fmt::format("net '{}' does not hold: {}", net.name, fmt::join(which, ", "));
}

VectorXd muscle_band_length(const Net& net, const NetEquilibrium& rest) {
  VectorXd length = VectorXd::Zero(static_cast<Eigen::Index>(net.muscles.size()));
  for (std::size_t b = 0; b < net.bands.size(); ++b)
    if (net.bands[b].muscle >= 0) length[net.bands[b].muscle] += rest.length[b];
  return length;
}

SlipTension slip_tension(const BuiltNet& net, const NetEquilibrium& rest) {
  return {sum_of(rest.tension, net.central), sum_of(rest.tension, net.radial),
          sum_of(rest.tension, net.ulnar), sum_of(rest.tension, net.terminal)};
}

TendonStatus net_status(const Net& net, const TreeState<double>& state,
                        const NetEquilibrium& rest) {
  switch (rest.status) {
    case NetStatus::kStalled:
    case NetStatus::kFarSideWrap:
      return TendonStatus::kUnbalanced;
    case NetStatus::kUnstable:
      return TendonStatus::kUnstable;
    case NetStatus::kOverstrained:
      return TendonStatus::kOverstrained;
    case NetStatus::kNodeCollapsed:
      return TendonStatus::kNodeCollapsed;
    case NetStatus::kBalanced:
      break;
  }
  return buried_band(net, state, rest).empty() ? TendonStatus::kValid
                                               : TendonStatus::kBandInsideBone;
}

NetEquilibrium NetSolverPool::solve(const Net& net, const NetSolverOptions& options,
                                    const TreeState<double>& state, const NetDrive& drive,
                                    const Eigen::Matrix3Xd* start) {
  // Take an idle solver, or build one.
  std::unique_ptr<NetSolver> solver;
  {
    const std::lock_guard<std::mutex> hold(lock_);
    if (!idle_.empty()) {
      solver = std::move(idle_.back());
      idle_.pop_back();
    }
  }
  if (!solver) solver = std::make_unique<NetSolver>(net, options);
  NetEquilibrium rest = solver->solve(state, drive, start);
  // Return it to the pool.
  const std::lock_guard<std::mutex> hold(lock_);
  idle_.push_back(std::move(solver));
  return rest;
}

std::string net_warning(const Net& net, const TreeState<double>& state,
                        const NetEquilibrium& rest) {
  switch (rest.status) {
    case NetStatus::kStalled:
      return fmt::format("net '{}' is not balanced: {:.2g} N are left", net.name, rest.residual);
    case NetStatus::kFarSideWrap:
      return fmt::format("net '{}' is not balanced: band '{}' has wound round its bone", net.name,
                         net.bands[rest.far_side_bands.front()].name);
    case NetStatus::kUnstable:
      return fmt::format("net '{}' is at a saddle: the least push moves it elsewhere", net.name);
    case NetStatus::kOverstrained:
      return overstrained(net, rest);
    case NetStatus::kNodeCollapsed:
      return drawn_band_names(net, transformed(rest.collapsed, &CollapsedBand::band));
    case NetStatus::kBalanced:
      break;
  }
  return buried_band(net, state, rest);
}

VectorXd FreeFinger::posture(const VectorXd& q) const {
  VectorXd all(static_cast<Eigen::Index>(angles.size()));
  for (Eigen::Index j = 0; j < all.size(); ++j) all[j] = angle_at(angles[j], q);
  return all;
}

VectorXd FreeFinger::tensions(const VectorXd& t) const {
  VectorXd all(static_cast<Eigen::Index>(muscles.size()));
  for (Eigen::Index m = 0; m < all.size(); ++m) {
    const int of = muscles[m];
    all[m] = of < 0 ? 0 : t[of];
  }
  return all;
}

NetTendons::NetTendons(std::shared_ptr<const DigitTendons> linear, BuiltNet net,
                       const NetSolverOptions& options, FreeFinger free)
    : linear_(std::move(linear)),
      net_(std::move(net)),
      options_(options),
      free_(std::move(free)),
      digit_(linear_->digit()) {
  // Build the matrix of the muscles' shares in the pulls.
  digit_.fidelity.hood = Hood::kFloatingNet;
  shares_ = MatrixXd::Zero(static_cast<Eigen::Index>(net_.pulls.size()),
                           static_cast<Eigen::Index>(digit_.names.muscles.size()));
  for (std::size_t p = 0; p < net_.pulls.size(); ++p)
    shares_(static_cast<Eigen::Index>(p), net_.pulls[p].muscle) = net_.pulls[p].share;
}

std::unique_ptr<DigitTendons> NetTendons::smoothed(double strain) const {
  require(strain >= 0 && std::isfinite(strain), "strain must be >= 0, got {}", strain);
  BuiltNet net = net_;
  net.net.blend = strain;
  // Smooth the finger with all joints free, too.
  FreeFinger free = free_;
  if (free.tendons) {
    BuiltNet whole = free.tendons->net_;
    whole.net.blend = strain;
    free.tendons = std::make_shared<NetTendons>(free.tendons->linear_, std::move(whole), options_);
  }
  return std::make_unique<NetTendons>(linear_, std::move(net), options_, std::move(free));
}

std::unique_ptr<TendonFollower> NetTendons::follower() const {
  return std::make_unique<NetFollower>(*this);
}

std::unique_ptr<TendonFollower> NetTendons::follower_on_tendons(const TendonEnds& ends) const {
  // Friction in sheaths has no potential, so net and tendons would have no common minimum.
  const bool has_friction = !digit_.model.friction.isZero(0);
  if (has_friction || !pulls_one_band_each(*this) || !ends.at.rest) return nullptr;
  return std::make_unique<NetFollower>(
      std::make_unique<PullByTendon>(*this, ends.laws, *ends.at.rest),
      PostureAndLoad{ends.q, ends.load}, *ends.at.rest);
}

VectorXd NetTendons::drive(const VectorXd& t) const { return shares_ * t; }

NetEquilibrium NetTendons::rest(const VectorXd& q, const VectorXd& t,
                                const Eigen::Matrix3Xd& start) const {
  return rest(q, NetDrive{drive(t), {}}, start);
}

NetEquilibrium NetTendons::rest(const VectorXd& q, const NetDrive& drive,
                                const Eigen::Matrix3Xd& start) const {
  require(start.cols() == 0 || start.cols() == static_cast<Eigen::Index>(net_.net.nodes.size()),
          "start has {} nodes, net '{}' {}", start.cols(), net_.net.name, net_.net.nodes.size());
  return solvers_.solve(net_.net, options_, pose_tree(digit_.model.tree, q), drive,
                        start.cols() == 0 ? nullptr : &start);
}

TendonTorque NetTendons::torque_outside(const VectorXd& q, const VectorXd& t) const {
  return torque_outside(q, t, pose_tree(digit_.model.tree, q));
}

TendonDerivatives NetTendons::derivatives_outside(const VectorXd& q, const VectorXd& t) const {
  const VectorXd whole = whole_shares();
  TendonDerivatives slopes = linear_->derivatives(q, whole.cwiseProduct(t));
  const TreeState<double> state = pose_tree(digit_.model.tree, q);
  // Add the paths of the net's muscles from their exits to their origins.
  slopes.by_posture += own_path_slopes(state, t);
  slopes.length = whole.cwiseProduct(slopes.length);
  for (const NetMuscle& m : net_.muscles)
    slopes.length[m.muscle] += m.to_net * path_length(state, m.own_path);
  return slopes;
}

MatrixXd NetTendons::torque_by_posture_outside(const VectorXd& q, const VectorXd& t) const {
  return linear_->torque_by_posture(q, whole_shares().cwiseProduct(t), {}) +
         own_path_slopes(pose_tree(digit_.model.tree, q), t);
}

VectorXd NetTendons::whole_shares() const {
  VectorXd whole = VectorXd::Ones(shares_.cols());
  for (const NetMuscle& m : net_.muscles) whole[m.muscle] = 1 - m.to_net;
  return whole;
}

MatrixXd NetTendons::own_path_slopes(const TreeState<double>& state, const VectorXd& t) const {
  const TendonModel<double>& model = digit_.model;
  MatrixXd slopes = MatrixXd::Zero(model.coordinates, model.coordinates);
  for (const NetMuscle& m : net_.muscles)
    slopes +=
        m.to_net * t[m.muscle] * arm_derivatives(model.tree, state, m.own_path, model.coordinates);
  return slopes;
}

TendonTorque NetTendons::torque_outside(const VectorXd& q, const VectorXd& t,
                                        const TreeState<double>& state) const {
  TendonTorque pull = linear_->evaluate(q, t);
  // Combine the arms of the whole tendon and of the own path of each muscle of the net.
  const TendonModel<double>& model = digit_.model;
  for (const NetMuscle& m : net_.muscles)
    pull.R.row(m.muscle) = (1 - m.to_net) * pull.R.row(m.muscle) +
                           m.to_net * moment_arms(model.tree, state, m.own_path, model.coordinates);
  pull.tau = pull.R.transpose() * t;
  return pull;
}

VectorXd NetTendons::torque(const VectorXd& q, const VectorXd& t,
                            const NetEquilibrium& rest) const {
  const TendonModel<double>& model = digit_.model;
  const TreeState<double> state = pose_tree(model.tree, q);
  return torque_outside(q, t, state).tau +
         net_torque(net_.net, model.tree, state, rest, model.coordinates);
}

TendonTorque NetTendons::evaluate(const VectorXd& q, const VectorXd& t,
                                  const Eigen::Matrix3Xd& start) const {
  return torque_at_equilibrium(q, t, rest(q, t, start));
}

std::shared_ptr<const NetEquilibrium> NetTendons::equilibrium_of(const TendonTorque& at,
                                                                 const VectorXd& q,
                                                                 const VectorXd& t) const {
  return at.rest ? at.rest : std::make_shared<const NetEquilibrium>(rest(q, t, at.nodes));
}

MatrixXd NetTendons::torque_by_posture(const VectorXd& q, const VectorXd& t,
                                       const TendonTorque& at) const {
  const TendonModel<double>& model = digit_.model;
  const TreeState<double> state = pose_tree(model.tree, q);
  const std::shared_ptr<const NetEquilibrium> rest = equilibrium_of(at, q, t);
  if (!why_not_differentiable(net_.net, *rest).empty())
    return DigitTendons::torque_by_posture(q, t, at);
  return torque_by_posture_outside(q, t) + thenar::torque_by_posture(net_.net, model.tree, state,
                                                                     {drive(t), {}}, *rest,
                                                                     model.coordinates);
}

MatrixXd NetTendons::compliance(const VectorXd& q, const VectorXd& t,
                                const TendonTorque& at) const {
  // Convert the compliance of the net's pulls to the digit's muscles by their shares.
  const std::shared_ptr<const NetEquilibrium> rest = equilibrium_of(at, q, t);
  if (!why_not_differentiable(net_.net, *rest).empty()) return MatrixXd::Zero(t.size(), t.size());
  const TreeState<double> state = pose_tree(digit_.model.tree, q);
  return -shares_.transpose() * muscle_compliance(net_.net, state, {drive(t), {}}, *rest) * shares_;
}

VectorXd NetTendons::lengths_outside(const VectorXd& q) const {
  const TreeState<double> state = pose_tree(digit_.model.tree, q);
  // Combine whole tendons and own paths by their shares.
  VectorXd length = linear_->lengths(q, VectorXd::Zero(shares_.cols()), {});
  for (const NetMuscle& m : net_.muscles)
    length[m.muscle] =
        (1 - m.to_net) * length[m.muscle] + m.to_net * path_length(state, m.own_path);
  return length;
}

VectorXd NetTendons::lengths(const VectorXd& q, const VectorXd& t, const TendonTorque& at) const {
  return lengths_outside(q) +
         shares_.transpose() * muscle_band_length(net_.net, *equilibrium_of(at, q, t));
}

TendonTorque NetTendons::torque_without_net_arms(const VectorXd& q, const VectorXd& t,
                                                 NetEquilibrium rest) const {
  // Add the net to the tendons outside it.
  const TendonModel<double>& model = digit_.model;
  const TreeState<double> state = pose_tree(model.tree, q);
  TendonTorque pull = torque_outside(q, t, state);
  pull.tau += net_torque(net_.net, model.tree, state, rest, model.coordinates);
  pull.slips = slip_tension(net_, rest);
  pull.nodes = rest.x;
  pull.effort = rest.evaluations;
  // Combine status and warnings.
  add_warning(net_warning(net_.net, state, rest), pull);
  pull.status = worse(pull.status, net_status(net_.net, state, rest));
  pull.rest = std::make_shared<const NetEquilibrium>(std::move(rest));
  return pull;
}

TendonTorque NetTendons::torque_at_equilibrium(const VectorXd& q, const VectorXd& t,
                                               NetEquilibrium rest) const {
  TendonTorque pull = torque_without_net_arms(q, t, std::move(rest));
  const TendonModel<double>& model = digit_.model;
  const TreeState<double> state = pose_tree(model.tree, q);
  // Add the arms of the net where it is differentiable.
  if (why_not_differentiable(net_.net, *pull.rest).empty())
    pull.R += (torque_by_drive(net_.net, model.tree, state, {drive(t), {}}, *pull.rest,
                               model.coordinates) *
               shares_)
                  .transpose();
  else
    add_warning("moment arms are without the net", pull);
  return pull;
}

}  // namespace thenar
