#include "data/io/robot/close_loops.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <Eigen/Dense>

#include "base/lists.h"
#include "base/numbers.h"
#include "data/io/robot/import_couplings.h"
#include "data/io/robot/link_poses.h"
#include "data/io/robot/linkage.h"

namespace thenar::internal {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kMaxLoopGap = 5e-5;   // Largest gap of a solved loop [m]
constexpr double kGoodLoopGap = 1e-7;  // Gap from which on no higher degree is tried [m]
constexpr double kStillRange = 1e-7;   // Range below which a joint stands still [rad] or [m]
constexpr double kMinRange = 0.2;      // Smallest share of the motor's range that must remain [1]
constexpr int kTrackSteps = 40;  // Steps across the range of the motor at which the loop is closed
constexpr int kGapChecks = 500;  // Intervals of the motor's range at which gaps are checked
constexpr int kMaxPolynomialDegree = 12;  // Largest degree of a coupling's polynomial

/// Names of the driven joints between a link and the base.
std::set<std::string> joints_below(const RobotSpec& robot, std::string link) {
  std::set<std::string> names;
  // Joints come parents first, so one walk backwards is enough.
  for (auto joint = robot.joints.rbegin(); joint != robot.joints.rend(); ++joint) {
    if (joint->child != link) continue;
    if (!joint->dof.empty()) names.insert(joint->name);
    link = joint->parent;
  }
  return names;
}

/// Degrees of freedom that move one place of a closure relative to the other.
std::set<std::string> dofs_between(RobotSpec& robot, const LoopClosure& closure) {
  const std::set<std::string> a = joints_below(robot, closure.a),
                              b = joints_below(robot, closure.b);
  std::vector<std::string> joints;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(joints));
  std::set<std::string> dofs;
  for (const std::string& joint : joints) dofs.insert(find_named(robot.joints, joint)->dof);
  return dofs;
}

/// Groups of closures that share degrees of freedom.
std::vector<LoopGroup> groups_of(RobotSpec& robot, const std::vector<LoopClosure>& closures) {
  std::vector<LoopGroup> groups;
  for (const LoopClosure& closure : closures) {
    LoopGroup joined{{closure}, dofs_between(robot, closure)};
    if (joined.dofs.empty()) continue;  // nothing moves the two places
    // Merge all groups that share one with this closure.
    for (auto group = groups.begin(); group != groups.end();) {
      const bool shared =
          any_of(joined.dofs, [&](const auto& dof) { return group->dofs.count(dof) > 0; });
      if (!shared) {
        ++group;
        continue;
      }
      append_all(joined.closures, group->closures);
      joined.dofs.insert(group->dofs.begin(), group->dofs.end());
      group = groups.erase(group);
    }
    groups.push_back(std::move(joined));
  }
  return groups;
}

/// Closed postures over the motor's range.
struct Track {
  std::vector<double> u;    // values of the motor, ascending [rad] or [m]
  std::vector<VectorXd> y;  // passive joints at each
};

/// Steps from a closed posture towards both ends of the range, as long as the loop closes.
Track follow(const Linkage& linkage, const RobotDof& motor, double start, const VectorXd& at) {
  Track track{{start}, {at}};
  const double step = (motor.upper - motor.lower) / kTrackSteps;
  for (const double way : {1.0, -1.0}) {
    double u = start;
    VectorXd y = at;
    while (way > 0 ? u < motor.upper : u > motor.lower) {
      // The next closed posture, from the last one.
      u = std::clamp(u + way * step, motor.lower, motor.upper);
      const std::optional<VectorXd> next = linkage.close(u, y);
      // A jump leads to another branch of the linkage.
      if (!next || (*next - y).lpNorm<Eigen::Infinity>() > 0.5) break;
      y = *next;
      track.u.insert(way > 0 ? track.u.end() : track.u.begin(), u);
      track.y.insert(way > 0 ? track.y.end() : track.y.begin(), y);
    }
  }
  return track;
}

/// Coefficients c_0, c_1 .. of the polynomial that fits values in least squares.
VectorXd polynomial(const std::vector<double>& u, const VectorXd& values, int degree) {
  // Scaled to the unit interval, so that powers stay comparable.
  double scale = 0;
  for (const double each : u) scale = std::max(scale, std::abs(each));
  MatrixXd powers(values.size(), degree + 1);
  for (Eigen::Index i = 0; i < values.size(); ++i)
    for (int k = 0; k <= degree; ++k) powers(i, k) = std::pow(u[i] / scale, k);
  VectorXd c = powers.colPivHouseholderQr().solve(values);
  for (int k = 0; k <= degree; ++k) c[k] /= std::pow(scale, k);
  return c;
}

/// Lets the joints of a passive degree of freedom follow the motor: y = sum c_k u^k.
void couple(RobotSpec& robot, const std::string& passive, const std::string& motor,
            const VectorXd& c) {
  for (RobotJoint& joint : robot.joints) {
    if (joint.dof != passive) continue;
    const double ratio = joint.ratio;
    joint.offset += ratio * c[0];
    if (c.size() == 1) {  // constant: the joint stands still
      joint.X_PJ = joint.X_PJ * joint_motion(joint, joint.offset);
      joint.kind = RobotJointKind::kFixed;
      joint.dof.clear();
      joint.ratio = 1;
      joint.lower = joint.upper = joint.offset = 0;
      continue;
    }
    // Otherwise it follows along the polynomial.
    joint.dof = motor;
    joint.ratio = ratio * c[1];
    for (Eigen::Index k = 2; k < c.size(); ++k) joint.curve.push_back(ratio * c[k]);
  }
}

/// The largest gap in the whole range, with joints coupled [m].
double gape(const Linkage& linkage, const RobotSpec& coupled, const RobotDof& motor) {
  double worst = 0;
  for (int i = 0; i <= kGapChecks; ++i) {
    const double u = motor.lower + (motor.upper - motor.lower) * i / kGapChecks;
    worst = max_or_nan(
        worst,
        max_or_nan(linkage.loop_residual(link_poses(coupled, {{motor.name, u}})).cwiseAbs()));
  }
  return worst;
}

/// Solves one group of loops, and couples its joints in the robot.
class LoopSolver {
 public:
  LoopSolver(RobotSpec& robot, const LoopGroup& group, const std::set<std::string>& driven)
      : robot_(robot), group_(group) {
    for (const std::string& dof : group.dofs)
      if (driven.count(dof) > 0) motors_.push_back(dof);
    // Without any motor the degree of freedom nearest to the base drives.
    for (const RobotDof& dof : robot.dofs)
      if (driven.empty() && motors_.empty() && group.dofs.count(dof.name) > 0)
        motors_.push_back(dof.name);
  }

  void run() {
    const std::string failure = solve();
    // Tell the user how well the loop closes, or that the robot must not grasp.
    std::vector<std::string> words;
    for (const LoopClosure& closure : group_.closures) words.push_back(closure.words);
    if (failure.empty()) {
      robot_.warnings.push_back(fmt::format(
          "{}: solved as a linkage, in which {} follow '{}'; it closes to {:.2g} mm",
          fmt::join(words, ", "), fmt::join(followers_, ", "), motors_.front(), 1e3 * gape_));
      return;
    }
    for (const std::string& each : words) {
      robot_.open_loops.push_back(fmt::format("{}: {}", each, failure));
      robot_.warnings.push_back(fmt::format(
          "INCOMPLETE: {} is not kept, {}: the robot comes apart there and must not grasp", each,
          failure));
    }
  }

 private:
  /// @returns the reason of failure, or an empty text
  std::string solve() {
    if (motors_.empty()) return "no motor drives it";
    if (motors_.size() > 1)
      return fmt::format("it is driven by several motors: {}", fmt::join(motors_, ", "));
    RobotDof motor = *find_named(robot_.dofs, motors_.front());
    // A linkage of one motor without curves.
    const Linkage linkage(robot_, group_, motor.name);
    for (const RobotJoint& joint : robot_.joints)
      if (group_.dofs.count(joint.dof) > 0 && !joint.curve.empty())
        return fmt::format("'{}' follows along a curve in it", joint.name);
    // Closed postures, over a large enough part of the range.
    const std::optional<Track> track = find_track(linkage, motor);
    if (!track) return "no posture was found in which it closes and every joint is determined";
    const double whole = motor.upper - motor.lower, left = track->u.back() - track->u.front();
    if (left < kMinRange * whole)
      return fmt::format("it closes from {:.4g} to {:.4g} of '{}' only", track->u.front(),
                         track->u.back(), motor.name);
    motor.lower = track->u.front();
    motor.upper = track->u.back();
    return fit(linkage, *track, motor, whole - left);
  }

  /// Closed postures from the file's own posture, or from any other that closes.
  static std::optional<Track> find_track(const Linkage& linkage, const RobotDof& motor) {
    const auto count = static_cast<Eigen::Index>(linkage.passives().size());
    // Start with passive joints at zero, or at the nearest limit.
    VectorXd at(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const PassiveJoint& passive = linkage.passives()[i];
      at[i] = std::clamp(0.0, passive.lower, passive.upper);
    }
    // The file's own posture first, then others over the range.
    for (const double share : {-1.0, 0.0, 0.25, 0.5, 0.75, 1.0}) {
      const double u = share < 0 ? std::clamp(0.0, motor.lower, motor.upper)
                                 : motor.lower + share * (motor.upper - motor.lower);
      if (const std::optional<VectorXd> closed = linkage.close(u, at))
        return follow(linkage, motor, u, *closed);
    }
    return {};
  }

  std::string fit(const Linkage& linkage, const Track& track, const RobotDof& motor, double lost) {
    RobotSpec best;
    gape_ = 1;
    // Raise the degree until the loop closes well enough.
    for (int degree = 1; degree <= kMaxPolynomialDegree && gape_ > kGoodLoopGap; ++degree) {
      RobotSpec coupled = robot_;
      followers_.clear();
      // Fit every passive joint, and measure the gap of the coupled robot.
      for (std::size_t i = 0; i < linkage.passives().size(); ++i) {
        VectorXd values(static_cast<Eigen::Index>(track.u.size()));
        for (std::size_t k = 0; k < track.u.size(); ++k) values[k] = track.y[k][i];
        const bool still = values.maxCoeff() - values.minCoeff() < kStillRange;
        couple(coupled, linkage.passives()[i].name, motor.name,
               still ? VectorXd::Constant(1, values.mean()) : polynomial(track.u, values, degree));
        if (!still) followers_.push_back("'" + linkage.passives()[i].name + "'");
      }
      const double now = gape(linkage, coupled, motor);
      if (!(now < gape_)) continue;
      gape_ = now;
      best = std::move(coupled);
    }
    // The best degree must close the loop.
    if (!(gape_ <= kMaxLoopGap))
      return fmt::format("no polynomial of degree {} closes it: it gapes by {:.2g} mm",
                         kMaxPolynomialDegree, 1e3 * gape_);
    adopt(std::move(best), linkage, motor, lost);
    return "";
  }

  void adopt(RobotSpec coupled, const Linkage& linkage, const RobotDof& motor, double lost) {
    // The robot with followers instead of passive degrees of freedom.
    robot_ = std::move(coupled);
    for (const LoopClosure& closure : group_.closures)
      robot_.joined.emplace_back(closure.a, closure.b);
    // The motor may have lost part of its range.
    if (lost > kStillRange) {
      robot_.warnings.push_back(
          fmt::format("'{}' moves from {:.6g} to {:.6g} only: beyond, its linkage does not close",
                      motor.name, motor.lower, motor.upper));
      RobotDof& dof = *find_named(robot_.dofs, motor.name);
      dof.lower = motor.lower;
      dof.upper = motor.upper;
    }
    // Passive degrees of freedom are no longer needed.
    erase_where(robot_.dofs, [&](const RobotDof& dof) {
      return find_named(linkage.passives(), dof.name) != nullptr;
    });
    // By what the polynomials are off.
    for (RobotJoint& joint : robot_.joints)
      if (joint.dof == motor.name && !joint.curve.empty()) widen_limits(joint, motor, kGapChecks);
  }

  RobotSpec& robot_;
  const LoopGroup& group_;
  std::vector<std::string> motors_, followers_;
  double gape_ = 0;  // [m]
};

}  // namespace

void close_loops(RobotSpec& robot, const std::vector<LoopClosure>& closures,
                 const std::set<std::string>& driven) {
  for (const LoopGroup& group : groups_of(robot, closures)) LoopSolver(robot, group, driven).run();
}

}  // namespace thenar::internal
