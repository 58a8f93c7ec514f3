#include "tendons/muscle/rigid_tensions.h"

#include <algorithm>
#include <cmath>

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Solver by arrays over all muscles; formulas in rigid_tendon_tension() and
/// rigid_tendon_derivatives().
class RigidTensions : public TensionSolver {
 public:
  RigidTensions(const std::vector<Musculotendon>& muscles, const HillOptions& options)
      : damping_(options.damping) {
    const auto n = static_cast<Index>(muscles.size());
    for (VectorXd* each : {&F0_, &slack_, &per_optimum_, &sine_, &per_top_}) each->resize(n);
    for (VectorXd* each : {&fibre_, &along_, &turn_, &v_}) each->setZero(n);
    for (Index m = 0; m < n; ++m) {
      const Musculotendon& muscle = muscles[m];
      F0_[m] = muscle.F0;
      slack_[m] = muscle.slack;
      // Allow muscles without fibres, whose tension is given.
      const double optimum = muscle.optimal_fibre_length;
      per_optimum_[m] = optimum > 0 ? 1 / optimum : 0;
      sine_[m] = std::sin(muscle.pennation);
      per_top_[m] = per_optimum_[m] / options.max_velocity;
    }
  }

  void tensions(const MuscleStates& at, MuscleTensions& out) override {
    set_fibres(at);
    out.tension.resize(F0_.size());
    for (Index m = 0; m < F0_.size(); ++m) {
      const double f = at.activation[m] * by_length_.active[m] * by_speed_.force[m] +
                       by_length_.passive[m] + damping_ * v_[m];
      out.tension[m] = at.length[m] > slack_[m] ? std::max(0.0, F0_[m] * f * along_[m]) : 0;
    }
  }

  void derivatives(const MuscleStates& at, MuscleTensions& out) override {
    tensions(at, out);
    const Index n = F0_.size();
    for (VectorXd* each : {&out.by_activation, &out.by_length, &out.by_velocity}) each->resize(n);
    out.by_projected_fibre.setZero(n);
    for (Index m = 0; m < n; ++m) {
      // Compute force over F0, and its derivatives by length and speed of the fibre.
      const double a = at.activation[m], fl = by_length_.active[m], fv = by_speed_.force[m];
      const double f = a * fl * fv + by_length_.passive[m] + damping_ * v_[m];
      const double f_l = a * by_length_.active_slope[m] * fv + by_length_.passive_slope[m];
      const double f_v = a * fl * by_speed_.slope[m] + damping_;
      // Set derivatives to zero where the tension is cut off.
      const double F0 = out.tension[m] > 0 ? F0_[m] : 0, along = along_[m];
      const double by_length =
          (f_l * along * per_optimum_[m] + f_v * at.velocity[m] * turn_[m] * per_top_[m]) * along +
          f * turn_[m];
      out.by_activation[m] = F0 > 0 ? F0 * fl * fv * along : 0;
      out.by_length[m] = F0 > 0 ? F0 * by_length : 0;
      out.by_velocity[m] = F0 > 0 ? F0 * f_v * along * along * per_top_[m] : 0;
    }
  }

 private:
  /// Computes lengths, angles and speeds of fibres, and the curves there; lengths only if they
  /// changed.
  void set_fibres(const MuscleStates& at) {
    if (length_.size() != at.length.size() || length_ != at.length) {
      length_ = at.length;
      for (Index m = 0; m < length_.size(); ++m) {
        // Compute fibre / optimum, the cosine of its angle, and the cosine's derivative.
        const double part = (length_[m] - slack_[m]) * per_optimum_[m], s = sine_[m];
        const double l = std::sqrt(part * part + s * s);
        fibre_[m] = l;
        along_[m] = part / l;
        turn_[m] = s * s * per_optimum_[m] / (l * l * l);
      }
      set_length_forces(fibre_, by_length_);
    }
    for (Index m = 0; m < length_.size(); ++m) v_[m] = at.velocity[m] * along_[m] * per_top_[m];
    set_speed_forces(v_, by_speed_);
  }

  double damping_;  // damper beta [1]
  // Constants of the muscles, and the sines of their pennation (muscles).
  VectorXd F0_, slack_, sine_;
  VectorXd per_optimum_, per_top_;  // 1 / optimal length [1/m], 1 / largest speed [s/m] (muscles)
  VectorXd length_;                 // lengths of the cached fibres [m] (muscles)
  VectorXd fibre_, along_,
      turn_;    // length over optimum [1], cosine [1] and its slope [1/m] (muscles)
  VectorXd v_;  // speed over the largest one [1] (muscles)
  LengthForces by_length_;
  SpeedForces by_speed_;
};

}  // namespace

std::unique_ptr<TensionSolver> rigid_tensions(const std::vector<Musculotendon>& muscles,
                                              const HillOptions& options) {
  return std::make_unique<RigidTensions>(muscles, options);
}

}  // namespace thenar
