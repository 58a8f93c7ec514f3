#include "grasp/closing/close_hand.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "base/lists.h"
#include "base/numbers.h"

namespace thenar {
namespace {

constexpr double kSoftCheckDistance = 1e-3;  // sliding of soft links between two checks [m]
// Fraction of the refresh distance after which rates are updated, for rounding errors [1]
constexpr double kRefreshFraction = 0.999;

/// Linear and angular speed of one surface relative to another.
struct RelativeSpeed {
  double linear = 0;   // [m/s]
  double angular = 0;  // [rad/s]
};

/// Closes a hand by conservative advancement.
class Closing {
 public:
  Closing(const CollisionHand& touching, const Pose<double>& X_WH, const Eigen::VectorXd& q,
          const GraspSetup& setup, const CloseOptions& options)
      : touching_(touching),
        hand_(*touching.hand),
        options_(options),
        drives_(hand_.layout()),
        posed_{touching, X_WH, hand_.pose(q)},
        q_(q),
        clearances_(find_clearances(posed_, setup)),
        speeds_(touching.trees.size()) {
    // Pairs of links that may stop each other.
    if (!options.self) return;
    SelfClearances self = find_self_clearances(posed_, options.accuracy);
    append_all(clearances_, self.clearances);
    self_overlaps_ = std::move(self.overlaps);
  }

  ClosedHand run() {
    int steps = 0;
    update_rates();
    for (; drives_.is_moving() && steps < options_.max_steps; ++steps) {
      advance();
      update_rates();
    }
    return {q_, drives_.stopped(), {}, self_overlaps_, !drives_.is_moving(), steps, queries_};
  }

 private:
  /// Evaluates the given rates at the start, after a stop, and after the refresh distance.
  void update_rates() {
    if (!options_.rates) return;
    const Eigen::Array<bool, Eigen::Dynamic, 1> free = drives_.free_coordinates();
    // Keep the rates if nothing has stopped and little has moved.
    const bool same = rates_q_.size() == q_.size() && (free == rates_free_).all();
    if (same && (q_ - rates_q_).lpNorm<Eigen::Infinity>() < kRefreshFraction * options_.refresh)
      return;
    drives_.set_rates(options_.rates(q_, free));
    rates_q_ = q_;
    rates_free_ = free;
  }

  /// Returns the time until rates have to be updated [s].
  [[nodiscard]] double time_to_refresh() const {
    if (!options_.rates) return kInfinity;
    double time = kInfinity;
    for (Eigen::Index j = 0; j < q_.size(); ++j) {
      const double rate = std::abs(drives_.rates()[j]);
      const double remaining = options_.refresh - std::abs(q_[j] - rates_q_[j]);
      if (rate > 0) time = std::min(time, std::max(0.0, remaining) / rate);
    }
    return time;
  }

  void update_speeds() {
    for (std::size_t s = 0; s < speeds_.size(); ++s)
      speeds_[s] = surface_speed(hand_, q_, drives_.rates(), static_cast<int>(s),
                                 touching_.trees[s].nodes[0].ball);
  }

  /// Returns whether a coordinate moves the other surface of a clearance.
  [[nodiscard]] bool moves_other(const Clearance& clearance, Eigen::Index j) const {
    return clearance.body == nullptr && touching_.moved_by(clearance.other, j);
  }

  /// Sums the speeds of coordinates that move only one of the two surfaces.
  [[nodiscard]] RelativeSpeed relative_speed(const Clearance& clearance) const {
    RelativeSpeed sum;
    for (Eigen::Index j = 0; j < q_.size(); ++j) {
      const bool first = touching_.moved_by(clearance.surface, j);
      if (first == moves_other(clearance, j)) continue;
      const SurfaceSpeed& mover = speeds_[first ? clearance.surface : clearance.other];
      sum.linear += mover.speed[j];
      sum.angular += mover.angular_speed[j];
    }
    return sum;
  }

  /// Takes one step, as long as all clearances allow, or stops the coordinates that cause a
  /// contact.
  void advance() {
    update_speeds();
    double time = std::min(time_to_limits(), time_to_refresh());
    // Measure only clearances that the step may use up.
    for (Clearance& clearance : clearances_) {
      const RelativeSpeed relative = relative_speed(clearance);
      if (relative.linear == 0 || safe_time_of(relative, clearance) >= time) continue;
      const double way =
          max_displacement(relative.linear, relative.angular, finite_time(time, relative));
      const SignedDistance found =
          measure_clearance(clearance, posed_, options_.accuracy / 4, way + 2 * options_.accuracy);
      ++queries_;
      // In contact: stop what presses, or let it slide; otherwise the new bound limits the step.
      if (found.distance + clearance.yield_depth <= options_.accuracy) {
        if (stop(clearance, found)) return;
        time = std::min(time, check_distance(clearance) / relative.linear);
      } else {
        time = std::min(time, safe_time_of(relative, clearance));
      }
    }
    move(time);
  }

  /// Returns a time in which the margin of a clearance is not used up [s].
  [[nodiscard]] double safe_time_of(const RelativeSpeed& relative,
                                    const Clearance& clearance) const {
    return safe_time(relative.linear, relative.angular,
                     std::max(0.0, clearance.margin() - options_.accuracy / 2));
  }

  /// Returns the distance after which two sliding surfaces are checked again [m].
  [[nodiscard]] double check_distance(const Clearance& clearance) const {
    return clearance.sticking_cosine > 0 ? kSoftCheckDistance : options_.accuracy / 4;
  }

  /// Limits a time to one in which no point moves farther than a metre [s].
  static double finite_time(double time, const RelativeSpeed& relative) {
    return std::min(time, safe_time(relative.linear, relative.angular, 1.0));
  }

  [[nodiscard]] double time_to_limits() const {
    double time = kInfinity;
    for (Eigen::Index j = 0; j < q_.size(); ++j) {
      const double rate = drives_.rates()[j];
      if (rate != 0) time = std::min(time, std::max(0.0, (limit(j) - q_[j]) / rate));
    }
    return time;
  }

  /// Returns the limit towards which a coordinate moves.
  [[nodiscard]] double limit(Eigen::Index j) const {
    return drives_.rates()[j] > 0 ? hand_.layout().upper[j] : hand_.layout().lower[j];
  }

  /// Moves all coordinates, and stops those that reach their limits.
  void move(double time) {
    // Reduce all bounds by the largest distance that a point can move.
    for (Clearance& clearance : clearances_) {
      const RelativeSpeed relative = relative_speed(clearance);
      clearance.bound -= max_displacement(relative.linear, relative.angular, time);
    }
    const Eigen::VectorXd rates = drives_.rates();
    // Move coordinates at their rates, up to their limits.
    std::vector<int> at_limit;
    for (Eigen::Index j = 0; j < q_.size(); ++j) {
      if (rates[j] == 0) continue;
      const bool ends = (limit(j) - q_[j]) / rates[j] <= time;
      q_[j] = ends ? limit(j) : q_[j] + rates[j] * time;
      if (ends) at_limit.push_back(static_cast<int>(j));
    }
    posed_.links = hand_.pose(q_);
    for (const int j : at_limit) drives_.stop(j, StoppedBy::kLimit);
  }

  /// Returns the velocity of a point of a surface by each coordinate that does not also move the
  /// other surface [m/s] (3, coordinates).
  [[nodiscard]] Eigen::Matrix3Xd velocities(int surface, int other,
                                            const Eigen::Vector3d& at_W) const {
    const int link = hand_.surfaces()[surface].link;
    if (link < 0) return Eigen::Matrix3Xd::Zero(3, q_.size());
    const Eigen::Vector3d p = posed_.surface_pose(surface).inverse() * at_W;
    Eigen::Matrix3Xd v =
        posed_.X_WH.R * hand_.jacobian(q_, link, p).bottomRows<3>() * drives_.rates().asDiagonal();
    for (Eigen::Index j = 0; j < q_.size(); ++j)
      if (other >= 0 && touching_.moved_by(other, j)) v.col(j).setZero();
    return v;
  }

  /// Stops the coordinates that press two surfaces together: for soft links those of a link that
  /// sticks to the other, otherwise all that move the two relative to each other. @returns whether
  /// any was stopped
  bool stop(const Clearance& clearance, const SignedDistance& found) {
    // Velocities of both contact points.
    const Eigen::Matrix3Xd a = velocities(clearance.surface, clearance.other, found.on_a);
    Eigen::Matrix3Xd b = Eigen::Matrix3Xd::Zero(3, q_.size());
    if (clearance.body == nullptr) b = velocities(clearance.other, clearance.surface, found.on_b);
    // Closing speed by each coordinate; surfaces that separate are not stopped.
    const Eigen::VectorXd into = (b - a).transpose() * found.normal;  // [m/s] (coordinates)
    if (into.sum() <= 0) return false;
    // Soft links slide unless they stick.
    const bool sticks[] = {sticks_to(-a, found.normal, into.sum(), clearance.sticking_cosine),
                           sticks_to(b, found.normal, into.sum(), clearance.sticking_cosine)};
    // Stop coordinates that move only one of the two.
    bool stopped = false;
    for (Eigen::Index j = 0; j < q_.size(); ++j) {
      const bool second = moves_other(clearance, j);
      if (touching_.moved_by(clearance.surface, j) == second || drives_.rates()[j] == 0) continue;
      if (clearance.sticking_cosine > 0 && !(sticks[second ? 1 : 0] && into[j] > 0)) continue;
      drives_.stop(static_cast<int>(j), StoppedBy::kContact);
      stopped = true;
    }
    return stopped;
  }

  /// Returns whether a link moves into another within the friction cone, and faster than the other
  /// recedes.
  /// @param closing  speed at which the two approach each other [m/s]
  static bool sticks_to(const Eigen::Matrix3Xd& velocities, const Eigen::Vector3d& inwards,
                        double closing, double cosine) {
    const Eigen::Vector3d v = velocities.rowwise().sum();
    return std::min(inwards.dot(v), closing) > cosine * v.norm();
  }

  const CollisionHand& touching_;
  const Hand& hand_;
  CloseOptions options_;
  ClosingDrives drives_;
  PosedCollisionHand posed_;
  Eigen::VectorXd q_;
  std::vector<Clearance> clearances_;
  std::vector<Overlap> self_overlaps_;  // at the start
  std::vector<SurfaceSpeed> speeds_;
  Eigen::VectorXd rates_q_;                           // posture of the last evaluation of rates
  Eigen::Array<bool, Eigen::Dynamic, 1> rates_free_;  // free coordinates at that evaluation
  int queries_ = 0;
};

}  // namespace

void require_valid_start(const Hand& hand, const Eigen::VectorXd& q) {
  const HandLayout& layout = hand.layout();
  require(q.size() == layout.lower.size(), "the hand has {} coordinates, q has {}",
          layout.lower.size(), q.size());
  for (Eigen::Index j = 0; j < q.size(); ++j)
    require(q[j] >= layout.lower[j] - 1e-9 && q[j] <= layout.upper[j] + 1e-9,
            "'{}' starts at {}, its range is {} .. {}", layout.coordinates[j], q[j],
            layout.lower[j], layout.upper[j]);
}

ClosedHand close_hand(const CollisionHand& hand, const Pose<double>& X_WH, const Eigen::VectorXd& q,
                      const GraspSetup& setup, const CloseOptions& options) {
  require_valid_start(*hand.hand, q);
  // A hand that starts in overlap cannot close.
  std::vector<Overlap> overlaps =
      find_overlaps({hand, X_WH, hand.hand->pose(q)}, setup, options.accuracy);
  if (overlaps.empty()) return Closing(hand, X_WH, q, setup, options).run();
  ClosedHand stuck;
  stuck.q = q;
  stuck.stopped.assign(q.size(), StoppedBy::kNothing);
  stuck.overlaps = std::move(overlaps);
  return stuck;
}

namespace {

// Maximum rotation in a step: e^x - 1 <= x + x^2 holds up to x = 1.79 [rad]
constexpr double kMaxStepRotation = 1.5;

}  // namespace

SurfaceSpeed surface_speed(const Hand& hand, const Eigen::VectorXd& q, const Eigen::VectorXd& q_dot,
                           int surface, const Ball& ball) {
  const int link = hand.surfaces()[surface].link;
  if (link < 0) return {Eigen::VectorXd::Zero(q.size()), Eigen::VectorXd::Zero(q.size())};
  // Speed of the ball's centre by the Jacobian, plus radius times angular speed.
  const auto J = hand.jacobian(q, link, ball.c);
  const Eigen::VectorXd rate = q_dot.cwiseAbs();
  const Eigen::VectorXd angular = J.topRows<3>().colwise().norm().transpose().cwiseProduct(rate);
  const Eigen::VectorXd centre = J.bottomRows<3>().colwise().norm().transpose().cwiseProduct(rate);
  return {centre + ball.r * angular, angular};
}

double safe_time(double speed, double angular_speed, double clearance) {
  if (speed <= 0) return kInfinity;
  // Root of  speed angular_speed t^2 + speed t = clearance,  in a form without cancellation.
  const double time =
      2 * clearance / speed / (1 + std::sqrt(1 + 4 * angular_speed * clearance / speed));
  return angular_speed > 0 ? std::min(time, kMaxStepRotation / angular_speed) : time;
}

double max_displacement(double speed, double angular_speed, double time) {
  return speed * time * (1 + angular_speed * time);
}

}  // namespace thenar
