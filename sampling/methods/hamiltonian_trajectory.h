#pragma once

/// Trajectories of Hamiltonian dynamics, and the selection of a draw from each.

#include <memory>

#include <Eigen/Core>

#include "base/random_stream.h"
#include "sampling/methods/whitening.h"

namespace thenar::internal {

/// Energy error above which a trajectory ends as divergent [1]. Source: [Betancourt2017].
inline constexpr double kMaxEnergyError = 1000;

/// Point of a trajectory, in the units of Whitening.
struct PhasePoint {
  Eigen::VectorXd y;      // whitened position (n)
  Eigen::VectorXd r;      // whitened momentum (n)
  Eigen::VectorXd slope;  // Whitening::whiten_gradient() at y (n)
};

/// First part of a leapfrog step, up to where the next gradient is needed:  r += step / 2 slope,
/// then
///   y += step r,   or, if whitening.follows_orbits(),
///   (y, r) = (y cos step + r sin step, r cos step - y sin step),
/// which is exact for a standard normal density, whose gradient -y is then excluded from `slope`.
/// Source: [Neal2011, section 2.3]; [Shahbaba2014] and [Casas2022] for orbits.
void begin_leapfrog(PhasePoint& point, const Whitening& whitening, double step);
/// Second part of a leapfrog step, with the gradient by x at the new point:  r += step / 2 slope.
void end_leapfrog(PhasePoint& point, const Whitening& whitening, const Eigen::VectorXd& gradient,
                  double step);

/// Decision about the latest point. A trajectory stores no positions: the caller holds a candidate
/// and a selected point, which is the starting point at first.
struct PointVerdict {
  bool is_candidate = false;       // the latest point becomes the candidate
  bool selects_candidate = false;  // the candidate, then, becomes the selected point
  bool is_complete = false;  // the trajectory is complete: the selected point is the next draw
};

/// Grows one trajectory after another, point by point.
class HamiltonianTrajectory {
 public:
  virtual ~HamiltonianTrajectory() = default;

  /// Starts a trajectory. @param step  maximum length of a leapfrog step [1]
  virtual void start(const PhasePoint& from, double step, RandomStream& random) = 0;
  /// Returns the point from which the next leapfrog step starts.
  [[nodiscard]] virtual PhasePoint& moving_point() = 0;
  /// Returns the length of that leapfrog step; negative: backward in time [1].
  [[nodiscard]] virtual double leapfrog_length() const = 0;
  /// Decides about the point that has moved.
  /// @param energy_error  energy error of that point; +inf if its density is zero or not finite
  virtual PointVerdict assess_point(double energy_error, RandomStream& random) = 0;

  /// Returns the mean acceptance probability of the points so far, each taken as a proposal, 0..1
  /// [1].
  [[nodiscard]] virtual double acceptance() const = 0;
  [[nodiscard]] virtual int depth() const = 0;  // number of complete doublings [1]
};

/// Creates trajectories with multinomial draws that double until they make a U-turn.
/// Source: [Hoffman2014], [Betancourt2017, appendix A.4], checks across subtrees as in Stan 2.21+;
/// [Phan2019] for the iterative form.
[[nodiscard]] std::unique_ptr<HamiltonianTrajectory> no_u_turn_trajectory(int n, int max_depth);

/// Creates trajectories of whitened length pi / 2 times a factor uniform in 0.9 .. 1.6, in as few
/// equal leapfrog steps as the step size allows, at most 1000; the end point is accepted or
/// rejected. A quarter turn decorrelates a normal target, a slightly longer trajectory makes
/// successive draws alternate, and the jitter avoids periodicity. Source: [Neal2011, section 3.2]
/// for the jitter.
[[nodiscard]] std::unique_ptr<HamiltonianTrajectory> jittered_trajectory();

}  // namespace thenar::internal
