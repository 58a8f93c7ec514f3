#pragma once

/// Trajectories of Hamiltonian dynamics, and the choice of a draw from each.

#include <memory>

#include <Eigen/Core>

#include "base/random_stream.h"
#include "sampling/methods/whitening.h"

namespace thenar::internal {

/// A trajectory ends as divergent where its energy error is larger. Source: [Betancourt2017].
inline constexpr double kMaxEnergyError = 1000;

/// A point of a trajectory, in the units of Whitening.
struct PhasePoint {
  Eigen::VectorXd y;      // whitened position (n)
  Eigen::VectorXd r;      // whitened momentum (n)
  Eigen::VectorXd slope;  // of Whitening::whiten_gradient() at y (n)
};

/// First part of a leapfrog, up to where the next gradient is needed:  r += step / 2 slope,  then
///   y += step r,   or, if whitening.orbits(),
///   (y, r) = (y cos step + r sin step, r cos step - y sin step),
/// which is exact for a standard normal density, whose gradient -y is no part of slope then.
/// Source: [Neal2011, section 2.3]; [Shahbaba2014] and [Casas2022] for orbits.
void begin_leapfrog(PhasePoint& point, const Whitening& whitening, double step);
/// The rest, with the gradient by x where the point is now:  r += step / 2 slope.
void end_leapfrog(PhasePoint& point, const Whitening& whitening, const Eigen::VectorXd& gradient,
                  double step);

/// Decision about the latest point. A trajectory keeps no positions: its caller holds a candidate
/// and a choice; the choice is the starting point at first.
struct Verdict {
  bool take = false;   // the point is the candidate now
  bool adopt = false;  // the candidate is the choice now (after `take`)
  bool end = false;    // the choice is the next draw
};

/// Grows one trajectory after the other, point by point.
class HamiltonianTrajectory {
 public:
  virtual ~HamiltonianTrajectory() = default;

  /// @param step  greatest length of a leapfrog [1]
  virtual void start(const PhasePoint& from, double step, RandomStream& random) = 0;
  /// The point that makes the next leapfrog, and that leapfrog's length, negative back in time [1].
  [[nodiscard]] virtual PhasePoint& moving() = 0;
  [[nodiscard]] virtual double leap() const = 0;
  /// @param energy_error  of the point that has moved; +inf if its density is zero or non_finite
  virtual Verdict judge(double energy_error, RandomStream& random) = 0;

  /// Mean acceptance probability over the points so far, each taken as a proposal, 0..1 [1].
  [[nodiscard]] virtual double acceptance() const = 0;
  [[nodiscard]] virtual int depth() const = 0;  // complete doublings [1]
};

/// Multinomial draws from trajectories that double until they turn back.
/// Source: [Hoffman2014], [Betancourt2017, appendix A.4], checks across subtrees as in Stan 2.21+;
/// [Phan2019] for the loop that replaces recursion.
[[nodiscard]] std::unique_ptr<HamiltonianTrajectory> no_u_turn(int n, int max_depth);

/// Trajectories of whitened length pi / 2 times a factor uniform in 0.9 .. 1.6, in as few equal
/// leapfrogs as the step allows, at most 1000; the end is accepted or refused. A quarter turn
/// decorrelates a normal target, a little more makes successive draws alternate, and the jitter
/// avoids periods. Source: [Neal2011, section 3.2] for the jitter.
[[nodiscard]] std::unique_ptr<HamiltonianTrajectory> jittered_length();

}  // namespace thenar::internal
