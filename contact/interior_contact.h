#pragma once

/// Interior-point method for a contact problem.

#include <cmath>
#include <vector>

#include <Eigen/Core>

#include "contact/in_place_lu.h"
#include "contact/scaled_contacts.h"

namespace thenar::internal {

/// Primal-dual interior-point method on De Saxce's form itself, not on its convex relaxation. In
/// the variables
///   x = (mu fn, ft),  y = (un / mu + |ut|, ut),  both in the Lorentz cone,
/// it takes Newton steps on  y - |y_t| e = D (A D x + b),  x o y = tau e,  with tau to 0,
/// Nesterov-Todd scaling, and Mehrotra's predictor-corrector. |y_t| is differentiated too (smoothed
/// by tau), so the linear systems are not symmetric, and a line search decreases the residual and
/// tau. If it stalls, a fixed-point iteration on |y_t| [AcaryCadoux2011] solves convex problems.
/// Intervals have a multiplier for each bound.
/// Source: [Mehrotra1992] for predictor and corrector.
class InteriorContact {
 public:
  /// Treatment of |ut| in De Saxce's form.
  enum class Coupling {
    kFull,   // |ut| is an unknown
    kFrozen  // |ut| is fixed at the given impulses: a convex problem, one fixed-point iteration
  };

  /// Iterates from an interior point towards a solution, and stores the best impulses in f.
  /// @param tolerance  largest residual, and largest tau over the scale squared [1]
  /// @param f          scaled impulses, which fix |ut| if it is frozen (rows)
  /// @returns number of steps
  int run(const ScaledContacts& contacts, Coupling coupling, int max_steps, double tolerance,
          Eigen::Ref<Eigen::VectorXd> f);

 private:
  enum class SecondOrder { kNo, kYes };
  /// Variables of a cone; vectors are zero beyond `rows`.
  struct Cone {
    int start = 0, rows = 3;
    double mu = 1, beta = 1, slip = 0;                     // beta of the scaling; frozen |ut|
    Eigen::Vector4d x{0, 0, 0, 0}, y = x, dx = x, dy = x;  // iterate and direction
    Eigen::Vector4d lambda = x, w = x, v = x;              // Nesterov-Todd scaling
    Eigen::Vector4d rho = x;                               // right-hand side, W dx + W^-1 dy
  };
  /// Variables of an interval.
  struct Interval {
    int start = 0;
    double lower = 0, upper = 0, f = 0, low = 0, high = 0;  // bounds, impulse, multipliers
    double df = 0, dlow = 0, dhigh = 0;                     // direction
    double low_term = 0, high_term = 0;                     // dlow and dhigh at df = 0
    [[nodiscard]] bool has_lower() const { return std::isfinite(lower); }
    [[nodiscard]] bool has_upper() const { return std::isfinite(upper); }
    [[nodiscard]] bool is_fixed() const { return lower == upper; }
  };

  [[nodiscard]] static Eigen::Vector4d times_scaling(const Cone& cone, const Eigen::Vector4d& u);
  void initialize(const ScaledContacts& contacts, const Eigen::Ref<const Eigen::VectorXd>& f);
  [[nodiscard]] Eigen::Vector3d slip_gradient(const Cone& cone) const;  // d |y_t| / d y_t
  [[nodiscard]] double mean_complementarity() const;
  void update_residuals(const ScaledContacts& contacts);
  void scale_cones();
  [[nodiscard]] bool factor(const ScaledContacts& contacts);
  void set_right_side(double target, SecondOrder second_order);
  void solve_direction();
  void compute_direction();
  [[nodiscard]] double max_step_length() const;
  void advance(double step);
  [[nodiscard]] bool line_search(const ScaledContacts& contacts);

  std::vector<Cone> cones_;
  std::vector<Interval> intervals_;
  Eigen::MatrixXd R_;                       // workspace: system matrix (rows, rows)
  Eigen::VectorXd residual_, rhs_, f_, u_;  // workspace (rows)
  Eigen::Index rows_ = 0;
  Coupling coupling_ = Coupling::kFull;
  double tau_ = 0, smoothing_ = 0, residual_norm_ = 0;
  InPlaceLu lu_;
};

}  // namespace thenar::internal
