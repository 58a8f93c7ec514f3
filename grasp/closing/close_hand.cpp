#include "grasp/closing/close_hand.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.h"
#include "base/numbers.h"

namespace thenar {
namespace {

constexpr double kSoftWay = 1e-3;  // distance between two checks of soft links that slide [m]

/// Linear and angular speed of one thing relative to another.
struct RelativeSpeed {
  double speed = 0;  // [m/s]
  double turn = 0;   // [rad/s]
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
    // Links that may stop each other.
    if (!options.self) return;
    SelfClearances self = self_clearances(posed_, options.accuracy);
    clearances_.insert(clearances_.end(), self.clearances.begin(), self.clearances.end());
    own_ = std::move(self.overlaps);
  }

  ClosedHand run() {
    int steps = 0;
    follow_rates();
    for (; drives_.moving() && steps < options_.max_steps; ++steps) {
      advance();
      follow_rates();
    }
    return {q_, drives_.stopped(), {}, own_, !drives_.moving(), steps, queries_};
  }

 private:
  /// Updates given rates at the start, after a stop, and after the refresh distance.
  void follow_rates() {
    if (!options_.rates) return;
    const Eigen::Array<bool, Eigen::Dynamic, 1> free = drives_.free();
    // Nothing was stopped and little has moved: keep the rates.
    const bool same = followed_.size() == q_.size() && (free == free_).all();
    if (same && (q_ - followed_).lpNorm<Eigen::Infinity>() < 0.999 * options_.refresh) return;
    drives_.follow(options_.rates(q_, free));
    followed_ = q_;
    free_ = free;
  }

  /// Time until rates have to be updated [s].
  [[nodiscard]] double time_to_refresh() const {
    if (!options_.rates) return kInfinity;
    double time = kInfinity;
    for (Eigen::Index j = 0; j < q_.size(); ++j) {
      const double rate = std::abs(drives_.rates()[j]);
      const double left = options_.refresh - std::abs(q_[j] - followed_[j]);
      if (rate > 0) time = std::min(time, std::max(0.0, left) / rate);
    }
    return time;
  }

  void find_speeds() {
    for (std::size_t s = 0; s < speeds_.size(); ++s)
      speeds_[s] = surface_speed(hand_, q_, drives_.rates(), static_cast<int>(s),
                                 touching_.trees[s].nodes[0].ball);
  }

  /// Sum of the speeds of coordinates that move one of the two things and not the other.
  [[nodiscard]] RelativeSpeed relative_speed(const Clearance& clearance) const {
    RelativeSpeed sum;
    for (Eigen::Index j = 0; j < q_.size(); ++j) {
      const bool first = touching_.moved_by(clearance.surface, j);
      const bool second = clearance.body == nullptr && touching_.moved_by(clearance.other, j);
      if (first == second) continue;
      const SurfaceSpeed& mover = speeds_[first ? clearance.surface : clearance.other];
      sum.speed += mover.speed[j];
      sum.turn += mover.turn[j];
    }
    return sum;
  }

  /// One step, as long as all clearances allow, or the stop of coordinates that caused a contact.
  void advance() {
    find_speeds();
    double time = std::min(time_to_limits(), time_to_refresh());
    // Only clearances that the step might use up are measured.
    for (Clearance& clearance : clearances_) {
      const RelativeSpeed relative = relative_speed(clearance);
      if (relative.speed == 0 || safe(relative, clearance) >= time) continue;
      const double way = longest_way(relative.speed, relative.turn, finite(time, relative));
      const SignedDistance found =
          measure_clearance(clearance, posed_, options_.accuracy / 4, way + 2 * options_.accuracy);
      ++queries_;
      // In contact: stop what presses, or let it slide on; otherwise the new bound limits the step.
      if (found.distance + clearance.yield <= options_.accuracy) {
        if (stop(clearance, found)) return;
        time = std::min(time, slide(clearance) / relative.speed);
      } else {
        time = std::min(time, safe(relative, clearance));
      }
    }
    move(time);
  }

  [[nodiscard]] double safe(const RelativeSpeed& relative, const Clearance& clearance) const {
    return safe_time(relative.speed, relative.turn,
                     std::max(0.0, clearance.margin() - options_.accuracy / 2));
  }

  /// Distance until two things that slide along each other are checked again [m].
  [[nodiscard]] double slide(const Clearance& clearance) const {
    return clearance.sticking_cosine > 0 ? kSoftWay : options_.accuracy / 4;
  }

  /// A finite time, in which a coordinate moves no farther than a metre [s].
  static double finite(double time, const RelativeSpeed& relative) {
    return std::min(time, safe_time(relative.speed, relative.turn, 1.0));
  }

  [[nodiscard]] double time_to_limits() const {
    double time = kInfinity;
    for (Eigen::Index j = 0; j < q_.size(); ++j) {
      const double rate = drives_.rates()[j];
      if (rate != 0) time = std::min(time, std::max(0.0, (limit(j) - q_[j]) / rate));
    }
    return time;
  }

  [[nodiscard]] double limit(Eigen::Index j) const {
    return drives_.rates()[j] > 0 ? hand_.layout().upper[j] : hand_.layout().lower[j];
  }

  /// Moves all coordinates, and stops those that reach their limits.
  void move(double time) {
    // Bounds shrink by the longest distance a point can move.
    for (Clearance& clearance : clearances_) {
      const RelativeSpeed relative = relative_speed(clearance);
      clearance.bound -= longest_way(relative.speed, relative.turn, time);
    }
    const Eigen::VectorXd rates = drives_.rates();
    // Coordinates move at their rates, up to their limits.
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

  /// Velocity of a point of a surface by each coordinate that does not move the other surface, too.
  /// [m/s] (3, coordinates)
  [[nodiscard]] Eigen::Matrix3Xd velocities(int surface, int other,
                                            const Eigen::Vector3d& at_W) const {
    const int link = hand_.surfaces()[surface].link;
    if (link < 0) return Eigen::Matrix3Xd::Zero(3, q_.size());
    const Eigen::Vector3d p = posed_.of_surface(surface).inverse() * at_W;
    Eigen::Matrix3Xd v =
        posed_.X_WH.R * hand_.jacobian(q_, link, p).bottomRows<3>() * drives_.rates().asDiagonal();
    for (Eigen::Index j = 0; j < q_.size(); ++j)
      if (other >= 0 && touching_.moved_by(other, j)) v.col(j).setZero();
    return v;
  }

  /// Stops the coordinates that press two things together: for soft links each that sticks to the
  /// other, for others all that move the two relative to each other. @returns whether it stopped
  /// any
  bool stop(const Clearance& clearance, const SignedDistance& found) {
    // Velocities of both contact points.
    const Eigen::Matrix3Xd a = velocities(clearance.surface, clearance.other, found.on_a);
    Eigen::Matrix3Xd b = Eigen::Matrix3Xd::Zero(3, q_.size());
    if (clearance.body == nullptr) b = velocities(clearance.other, clearance.surface, found.on_b);
    // Closing speed by each coordinate; parting things are not stopped.
    const Eigen::VectorXd into = (b - a).transpose() * found.normal;  // [m/s] (coordinates)
    if (into.sum() <= 0) return false;
    // Soft links slide unless they stick.
    const bool sticks[] = {sticks_to(-a, found.normal, into.sum(), clearance.sticking_cosine),
                           sticks_to(b, found.normal, into.sum(), clearance.sticking_cosine)};
    bool stopped = false;
    for (Eigen::Index j = 0; j < q_.size(); ++j) {
      const bool first = touching_.moved_by(clearance.surface, j);
      const bool second = clearance.body == nullptr && touching_.moved_by(clearance.other, j);
      if (first == second || drives_.rates()[j] == 0) continue;
      if (clearance.sticking_cosine > 0 && !(sticks[second ? 1 : 0] && into[j] > 0)) continue;
      drives_.stop(static_cast<int>(j), StoppedBy::kContact);
      stopped = true;
    }
    return stopped;
  }

  /// Returns whether a link goes into another within the friction cone, and faster than that gives
  /// way.
  /// @param closing  speed at which the two come together [m/s]
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
  std::vector<Overlap> own_;  // at the start
  std::vector<SurfaceSpeed> speeds_;
  Eigen::VectorXd followed_;                    // where rates were asked for last
  Eigen::Array<bool, Eigen::Dynamic, 1> free_;  // then
  int queries_ = 0;
};

}  // namespace

void require_start(const Hand& hand, const Eigen::VectorXd& q) {
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
  require_start(*hand.hand, q);
  // Overlaps at the start leave nothing to close.
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

constexpr double kLongestTurn = 1.5;  // e^x - 1 <= x + x^2 up to x = 1.79 [rad]

}  // namespace

SurfaceSpeed surface_speed(const Hand& hand, const Eigen::VectorXd& q, const Eigen::VectorXd& q_dot,
                           int surface, const Ball& ball) {
  const int link = hand.surfaces()[surface].link;
  if (link < 0) return {Eigen::VectorXd::Zero(q.size()), Eigen::VectorXd::Zero(q.size())};
  // The centre of the ball by the Jacobian; its rim moves faster by radius times angular speed.
  const auto J = hand.jacobian(q, link, ball.c);
  const Eigen::VectorXd rate = q_dot.cwiseAbs();
  const Eigen::VectorXd turn = J.topRows<3>().colwise().norm().transpose().cwiseProduct(rate);
  const Eigen::VectorXd centre = J.bottomRows<3>().colwise().norm().transpose().cwiseProduct(rate);
  return {centre + ball.r * turn, turn};
}

double safe_time(double speed, double turn, double clearance) {
  if (speed <= 0) return std::numeric_limits<double>::infinity();
  // Root of  speed turn t^2 + speed t = clearance,  in a form without cancellation.
  const double time = 2 * clearance / speed / (1 + std::sqrt(1 + 4 * turn * clearance / speed));
  return turn > 0 ? std::min(time, kLongestTurn / turn) : time;
}

double longest_way(double speed, double turn, double time) {
  return speed * time * (1 + turn * time);
}

}  // namespace thenar
