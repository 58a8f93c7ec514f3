#include "data/io/robot/close_loops.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <Eigen/Dense>

#include "base/angles.h"
#include "data/io/robot/import_couplings.h"
#include "data/io/robot/link_poses.h"

namespace thenar::internal {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kGape = 5e-5;        // farthest that a solved loop may gape [m]
constexpr double kWell = 1e-7;        // gape that asks for no higher degree [m]
constexpr double kClosed = 1e-11;     // of the search [m]
constexpr double kLength = 0.05;      // by which directions of welds are weighed [m]
constexpr double kStep = 0.1;         // longest step of the search [rad] or [m]
constexpr double kDifference = 1e-6;  // of derivatives [rad] or [m]
constexpr double kRank = 1e-7;       // singular values below this share of the largest are none [1]
constexpr double kStill = 1e-7;      // way of a joint that stands still [rad] or [m]
constexpr double kLeastRange = 0.2;  // of the motor's range that must remain [1]
constexpr int kNodes = 40, kChecks = 500, kHighestDegree = 12;

/// Loops that share motors or passive joints.
struct Group {
  std::vector<LoopClosure> closures;
  std::set<std::string> dofs;
};

/// The joints from a link to the base.
std::set<std::string> joints_below(const RobotSpec& robot, std::string link) {
  std::set<std::string> names;
  for (auto joint = robot.joints.rbegin(); joint != robot.joints.rend(); ++joint) {
    if (joint->child != link) continue;
    if (!joint->dof.empty()) names.insert(joint->name);
    link = joint->parent;
  }
  return names;
}

/// What moves one place of a closure and not the other.
std::set<std::string> dofs_between(RobotSpec& robot, const LoopClosure& closure) {
  const std::set<std::string> a = joints_below(robot, closure.a),
                              b = joints_below(robot, closure.b);
  std::vector<std::string> joints;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(joints));
  std::set<std::string> dofs;
  for (const std::string& joint : joints) dofs.insert(find_joint(robot, joint)->dof);
  return dofs;
}

std::vector<Group> groups_of(RobotSpec& robot, const std::vector<LoopClosure>& closures) {
  std::vector<Group> groups;
  for (const LoopClosure& closure : closures) {
    Group joined{{closure}, dofs_between(robot, closure)};
    if (joined.dofs.empty()) continue;  // nothing moves them against each other
    for (auto group = groups.begin(); group != groups.end();) {
      const bool shared = std::any_of(joined.dofs.begin(), joined.dofs.end(),
                                      [&](const auto& dof) { return group->dofs.count(dof) > 0; });
      if (!shared) {
        ++group;
        continue;
      }
      joined.closures.insert(joined.closures.end(), group->closures.begin(), group->closures.end());
      joined.dofs.insert(group->dofs.begin(), group->dofs.end());
      group = groups.erase(group);
    }
    groups.push_back(std::move(joined));
  }
  return groups;
}

/// A passive degree of freedom.
struct Passive {
  std::string name;
  double lower, upper, stiffness, rest;  // stiffness 0: no spring
};

/// Closes the loops of one group at values of its motor.
class Linkage {
 public:
  Linkage(const RobotSpec& robot, const Group& group, std::string motor)
      : robot_(robot), group_(group), motor_(std::move(motor)) {
    for (std::size_t i = 0; i < robot.links.size(); ++i) index_[robot.links[i].name] = i;
    for (const RobotDof& dof : robot.dofs) {
      if (group.dofs.count(dof.name) == 0 || dof.name == motor_) continue;
      Passive passive{dof.name, dof.lower, dof.upper, 0, 0};
      for (const RobotJoint& joint : robot.joints)
        if (joint.dof == dof.name && joint.name == dof.name) {
          passive.stiffness = joint.stiffness;
          passive.rest = joint.rest;
        }
      passives_.push_back(passive);
    }
  }

  [[nodiscard]] const std::vector<Passive>& passives() const { return passives_; }

  /// How far places that are one lie apart; of welds their turn by kLength, too [m].
  [[nodiscard]] VectorXd gaps(double u, const VectorXd& y) const {
    DofValues values{{motor_, u}};
    for (std::size_t i = 0; i < passives_.size(); ++i)
      values[passives_[i].name] = y[static_cast<Eigen::Index>(i)];
    return gaps(link_poses(robot_, values));
  }

  [[nodiscard]] VectorXd gaps(const std::vector<Pose<double>>& links) const {
    std::vector<double> all;
    for (const LoopClosure& closure : group_.closures) {
      const Pose<double> A = links[index_.at(closure.a)] * closure.X_A,
                         B = links[index_.at(closure.b)] * closure.X_B;
      for (int k = 0; k < 3; ++k) all.push_back(A.p[k] - B.p[k]);
      if (!closure.welded) continue;
      const Eigen::AngleAxisd turn(Eigen::Matrix3d(A.R.transpose() * B.R));
      for (int k = 0; k < 3; ++k) all.push_back(kLength * turn.angle() * turn.axis()[k]);
    }
    return Eigen::Map<const VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
  }

  /// Goes from a posture to the closed one of least spring energy near it.
  /// @return none if the search does not get there, or springs leave a freedom
  [[nodiscard]] std::optional<VectorXd> close(double u, VectorXd y) const {
    // Where the motor moves every joint, the loop closes by itself or not at all.
    if (passives_.empty())
      return gaps(u, y).cwiseAbs().maxCoeff() < kClosed ? std::optional<VectorXd>(y) : std::nullopt;
    for (int iteration = 0; iteration < 200; ++iteration) {
      const VectorXd c = gaps(u, y);
      const MatrixXd J = slopes(u, y);
      bool decided = true;
      VectorXd d = step(c, J, y, decided);
      if (c.cwiseAbs().maxCoeff() < kClosed && d.cwiseAbs().maxCoeff() < 1e-10)
        return decided ? std::optional<VectorXd>(y) : std::nullopt;
      const double longest = d.cwiseAbs().maxCoeff();
      if (longest > kStep) d *= kStep / longest;
      y += d;
      for (std::size_t i = 0; i < passives_.size(); ++i) {
        double& each = y[static_cast<Eigen::Index>(i)];
        each = std::clamp(each, passives_[i].lower, passives_[i].upper);
      }
    }
    return {};
  }

 private:
  [[nodiscard]] MatrixXd slopes(double u, const VectorXd& y) const {
    MatrixXd J;
    for (Eigen::Index i = 0; i < y.size(); ++i) {
      const VectorXd e = kDifference * VectorXd::Unit(y.size(), i);
      const VectorXd column = (gaps(u, y + e) - gaps(u, y - e)) / (2 * kDifference);
      if (i == 0) J.resize(column.size(), y.size());
      J.col(i) = column;
    }
    return J;
  }

  /// One step of sequential quadratic programming; bounds that it would cross are held one by one.
  [[nodiscard]] VectorXd step(const VectorXd& c, const MatrixXd& J, const VectorXd& y,
                              bool& decided) const {
    const auto count = static_cast<std::size_t>(y.size());
    std::vector<bool> held(count, false);
    VectorXd d = VectorXd::Zero(y.size());
    for (std::size_t round = 0; round <= count; ++round) {
      free_step(c, J, y, held, d, decided);
      std::size_t worst = count;
      double most = 1e-13;
      for (std::size_t i = 0; i < count; ++i) {
        if (held[i]) continue;
        const double at = y[static_cast<Eigen::Index>(i)] + d[static_cast<Eigen::Index>(i)];
        const double beyond = std::max(passives_[i].lower - at, at - passives_[i].upper);
        if (beyond <= most) continue;
        most = beyond;
        worst = i;
      }
      if (worst == count) break;
      const auto i = static_cast<Eigen::Index>(worst);
      held[worst] = true;
      d[i] =
          (y[i] + d[i] < passives_[worst].lower ? passives_[worst].lower : passives_[worst].upper) -
          y[i];
    }
    return d;
  }

  /// Least spring energy with J d = -c, entries of d that are held as they are.
  void free_step(const VectorXd& c, const MatrixXd& J, const VectorXd& y,
                 const std::vector<bool>& held, VectorXd& d, bool& decided) const {
    std::vector<Eigen::Index> free;
    VectorXd wanted = -c;
    for (std::size_t i = 0; i < held.size(); ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      if (held[i])
        wanted -= d[at] * J.col(at);
      else
        free.push_back(at);
    }
    if (free.empty()) return;
    MatrixXd A(J.rows(), static_cast<Eigen::Index>(free.size()));
    for (std::size_t f = 0; f < free.size(); ++f)
      A.col(static_cast<Eigen::Index>(f)) = J.col(free[f]);
    Eigen::JacobiSVD<MatrixXd> svd(A, Eigen::ComputeThinU | Eigen::ComputeFullV);
    svd.setThreshold(kRank);
    const VectorXd least = svd.solve(wanted);
    const MatrixXd Z = svd.matrixV().rightCols(A.cols() - svd.rank());
    VectorXd x = least;
    decided = true;
    if (Z.cols() > 0) {
      VectorXd k(A.cols()), pull(A.cols());
      for (std::size_t f = 0; f < free.size(); ++f) {
        const Passive& passive = passives_[static_cast<std::size_t>(free[f])];
        const auto at = static_cast<Eigen::Index>(f);
        k[at] = passive.stiffness;
        pull[at] = passive.stiffness * (passive.rest - y[free[f]] - least[at]);
      }
      const MatrixXd H = Z.transpose() * k.asDiagonal() * Z;
      const Eigen::FullPivLU<MatrixXd> lu(H);
      decided = H.cwiseAbs().maxCoeff() > 0 && lu.rank() == Z.cols();
      if (decided) x += Z * lu.solve(Z.transpose() * pull);
    }
    for (std::size_t f = 0; f < free.size(); ++f) d[free[f]] = x[static_cast<Eigen::Index>(f)];
  }

  const RobotSpec& robot_;
  const Group& group_;
  std::string motor_;
  std::vector<Passive> passives_;
  std::map<std::string, std::size_t> index_;
};

/// Closed postures along the motor's range.
struct Track {
  std::vector<double> u;    // rising
  std::vector<VectorXd> y;  // of each
};

/// Steps from a closed posture to either end of the range, as far as the loop closes.
Track follow(const Linkage& linkage, const RobotDof& motor, double start, const VectorXd& at) {
  Track track{{start}, {at}};
  const double step = (motor.upper - motor.lower) / kNodes;
  for (const double way : {1.0, -1.0}) {
    double u = start;
    VectorXd y = at;
    while (way > 0 ? u < motor.upper : u > motor.lower) {
      u = std::clamp(u + way * step, motor.lower, motor.upper);
      const std::optional<VectorXd> next = linkage.close(u, y);
      // A jump is another branch of the linkage.
      if (!next || (*next - y).lpNorm<Eigen::Infinity>() > 0.5) break;
      y = *next;
      track.u.insert(way > 0 ? track.u.end() : track.u.begin(), u);
      track.y.insert(way > 0 ? track.y.end() : track.y.begin(), y);
    }
  }
  return track;
}

/// Coefficients c_0, c_1 .. of the polynomial of least squares through values.
VectorXd polynomial(const std::vector<double>& u, const VectorXd& values, int degree) {
  double scale = 0;
  for (const double each : u) scale = std::max(scale, std::abs(each));
  MatrixXd powers(values.size(), degree + 1);
  for (Eigen::Index i = 0; i < values.size(); ++i)
    for (int k = 0; k <= degree; ++k)
      powers(i, k) = std::pow(u[static_cast<std::size_t>(i)] / scale, k);
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
    if (c.size() == 1) {  // it stands still
      joint.X_PJ = joint.X_PJ * joint_motion(joint, joint.offset);
      joint.kind = RobotJointKind::kFixed;
      joint.dof.clear();
      joint.ratio = 1;
      joint.lower = joint.upper = joint.offset = 0;
      continue;
    }
    joint.dof = motor;
    joint.ratio = ratio * c[1];
    for (Eigen::Index k = 2; k < c.size(); ++k) joint.curve.push_back(ratio * c[k]);
  }
}

void widen_limits(RobotSpec& robot, const RobotDof& motor) {
  for (RobotJoint& joint : robot.joints)
    if (joint.dof == motor.name && !joint.curve.empty())
      for (int i = 0; i <= kChecks; ++i) {
        const double value =
            joint_value(joint, motor.lower + (motor.upper - motor.lower) * i / kChecks);
        joint.lower = std::min(joint.lower, value);  // by what the polynomial is off
        joint.upper = std::max(joint.upper, value);
      }
}

/// The largest gap anywhere in the range, with joints coupled [m].
double gape(const Linkage& linkage, const RobotSpec& coupled, const RobotDof& motor) {
  double worst = 0;
  for (int i = 0; i <= kChecks; ++i) {
    const double u = motor.lower + (motor.upper - motor.lower) * i / kChecks;
    worst =
        std::max(worst, linkage.gaps(link_poses(coupled, {{motor.name, u}})).cwiseAbs().maxCoeff());
  }
  return worst;
}

class Closing {
 public:
  Closing(RobotSpec& robot, const Group& group, const std::set<std::string>& driven)
      : robot_(robot), group_(group) {
    for (const std::string& dof : group.dofs)
      if (driven.count(dof) > 0) motors_.push_back(dof);
    // A file without any motor: what stands nearest to the base drives.
    for (const RobotDof& dof : robot.dofs)
      if (driven.empty() && motors_.empty() && group.dofs.count(dof.name) > 0)
        motors_.push_back(dof.name);
  }

  void run() {
    const std::string trouble = solve();
    std::vector<std::string> words;
    for (const LoopClosure& closure : group_.closures) words.push_back(closure.words);
    if (trouble.empty()) {
      robot_.warnings.push_back(fmt::format(
          "{}: solved as a linkage, in which {} follow '{}'; it closes to {:.2g} mm",
          fmt::join(words, ", "), fmt::join(followers_, ", "), motors_.front(), 1e3 * gape_));
      return;
    }
    for (const std::string& each : words) {
      robot_.open_loops.push_back(fmt::format("{}: {}", each, trouble));
      robot_.warnings.push_back(fmt::format(
          "INCOMPLETE: {} is not kept, {}: the robot comes apart there and must not grasp", each,
          trouble));
    }
  }

 private:
  /// @return why not, or nothing
  std::string solve() {
    if (motors_.empty()) return "no motor drives it";
    if (motors_.size() > 1)
      return fmt::format("it is driven by several motors: {}", fmt::join(motors_, ", "));
    RobotDof motor = *find_dof(robot_, motors_.front());
    const Linkage linkage(robot_, group_, motor.name);
    for (const RobotJoint& joint : robot_.joints)
      if (group_.dofs.count(joint.dof) > 0 && !joint.curve.empty())
        return fmt::format("'{}' follows along a curve in it", joint.name);
    const std::optional<Track> track = find_track(linkage, motor);
    if (!track) return "no posture was found in which it closes and every joint is determined";
    const double whole = motor.upper - motor.lower, left = track->u.back() - track->u.front();
    if (left < kLeastRange * whole)
      return fmt::format("it closes from {:.4g} to {:.4g} of '{}' only", track->u.front(),
                         track->u.back(), motor.name);
    motor.lower = track->u.front();
    motor.upper = track->u.back();
    return fit(linkage, *track, motor, whole - left);
  }

  /// From where the file's own posture is, or any other that closes.
  static std::optional<Track> find_track(const Linkage& linkage, const RobotDof& motor) {
    const auto count = static_cast<Eigen::Index>(linkage.passives().size());
    VectorXd at(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const Passive& passive = linkage.passives()[static_cast<std::size_t>(i)];
      at[i] = std::clamp(0.0, passive.lower, passive.upper);
    }
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
    for (int degree = 1; degree <= kHighestDegree && gape_ > kWell; ++degree) {
      RobotSpec coupled = robot_;
      followers_.clear();
      for (std::size_t i = 0; i < linkage.passives().size(); ++i) {
        VectorXd values(static_cast<Eigen::Index>(track.u.size()));
        for (std::size_t k = 0; k < track.u.size(); ++k)
          values[static_cast<Eigen::Index>(k)] = track.y[k][static_cast<Eigen::Index>(i)];
        const bool still = values.maxCoeff() - values.minCoeff() < kStill;
        couple(coupled, linkage.passives()[i].name, motor.name,
               still ? VectorXd::Constant(1, values.mean()) : polynomial(track.u, values, degree));
        if (!still) followers_.push_back("'" + linkage.passives()[i].name + "'");
      }
      const double now = gape(linkage, coupled, motor);
      if (now >= gape_) continue;
      gape_ = now;
      best = std::move(coupled);
    }
    if (gape_ > kGape)
      return fmt::format("no polynomial of degree {} closes it: it gapes by {:.2g} mm",
                         kHighestDegree, 1e3 * gape_);
    adopt(std::move(best), linkage, motor, lost);
    return "";
  }

  void adopt(RobotSpec coupled, const Linkage& linkage, const RobotDof& motor, double lost) {
    robot_ = std::move(coupled);
    for (const LoopClosure& closure : group_.closures)
      robot_.joined.emplace_back(closure.a, closure.b);
    if (lost > kStill) {
      robot_.warnings.push_back(
          fmt::format("'{}' moves from {:.6g} to {:.6g} only: beyond, its linkage does not close",
                      motor.name, motor.lower, motor.upper));
      RobotDof& dof = *find_dof(robot_, motor.name);
      dof.lower = motor.lower;
      dof.upper = motor.upper;
    }
    const auto passive = [&](const RobotDof& dof) {
      return std::any_of(linkage.passives().begin(), linkage.passives().end(),
                         [&](const Passive& each) { return each.name == dof.name; });
    };
    robot_.dofs.erase(std::remove_if(robot_.dofs.begin(), robot_.dofs.end(), passive),
                      robot_.dofs.end());
    widen_limits(robot_, motor);
  }

  RobotSpec& robot_;
  const Group& group_;
  std::vector<std::string> motors_, followers_;
  double gape_ = 0;  // [m]
};

}  // namespace

void close_loops(RobotSpec& robot, const std::vector<LoopClosure>& closures,
                 const std::set<std::string>& driven) {
  for (const Group& group : groups_of(robot, closures)) Closing(robot, group, driven).run();
}

}  // namespace thenar::internal
