#pragma once

/// Interior points of a contact problem.

#include <vector>

#include <Eigen/Core>

#include "contact/in_place_lu.h"
#include "contact/scaled_contacts.h"

namespace thenar::internal {

/// A primal-dual method on De Saxce's form itself, not on its convex relaxation: in the variables
///   x = (mu fn, ft),  y = (un / mu + |ut|, ut),  both in the cone of Lorentz,
/// Newton's steps on  y - |y_t| e = D (A D x + b),  x o y = tau e,  tau to 0, with the scaling of
/// Nesterov and Todd, predictor and corrector. |y_t| is differentiated, too (smoothed by tau), so
/// the linear systems are not symmetric and steps are halved until the equations and tau fall.
/// Where they stall, the fixed point on |y_t| [AcaryCadoux2011] goes on with convex problems.
/// Intervals have a multiplier for each of their ends.
/// Source: [Mehrotra1992] for predictor and corrector.
class InteriorContact {
 public:
  /// Treatment of |ut| in De Saxce's form.
  enum class Coupling {
    kFull,   // as an unknown
    kFrozen  // as it is at the impulses given: a convex problem, one turn of a fixed point
  };

  /// Moves from the middle to an answer, or as near as it gets, and writes the impulses to f.
  /// @param f  scaled impulses (rows)
  /// @returns steps taken
  int run(const ScaledContacts& contacts, Coupling coupling, int max_steps, double tolerance,
          Eigen::Ref<Eigen::VectorXd> f);

 private:
  enum class Corrected { kNo, kYes };
  struct Cone {
    int start = 0, rows = 3;
    double mu = 1, beta = 1, slip = 0;                     // slip: |ut| where frozen
    Eigen::Vector4d x{0, 0, 0, 0}, y = x, dx = x, dy = x;  // zero beyond `rows`
    Eigen::Vector4d lambda = x, w = x, v = x, rho = x;
  };
  struct Interval {
    int start = 0;
    double lower = 0, upper = 0, f = 0, low = 0, high = 0;  // multipliers of the ends
    double df = 0, dlow = 0, dhigh = 0, low_term = 0, high_term = 0;
    [[nodiscard]] bool has_lower() const;
    [[nodiscard]] bool has_upper() const;
    [[nodiscard]] bool is_fixed() const { return lower == upper; }
  };

  [[nodiscard]] static Eigen::Vector4d times_scaling(const Cone& cone, const Eigen::Vector4d& u);
  void start(const ScaledContacts& contacts, const Eigen::Ref<const Eigen::VectorXd>& f);
  [[nodiscard]] Eigen::Vector3d slope(const Cone& cone) const;  // of |y_t|
  [[nodiscard]] double mean_complementarity() const;
  void measure(const ScaledContacts& contacts);
  void scale_cones();
  [[nodiscard]] bool factor(const ScaledContacts& contacts);
  void set_right_side(double target, Corrected corrected);
  void take_direction();
  void find_step();
  [[nodiscard]] double longest_step() const;
  void move(double step);
  [[nodiscard]] bool move_down(const ScaledContacts& contacts);

  std::vector<Cone> cones_;
  std::vector<Interval> intervals_;
  Eigen::MatrixXd R_;                   // (room, room)
  Eigen::VectorXd rest_, rhs_, f_, u_;  // (room)
  Eigen::Index rows_ = 0;
  Coupling coupling_ = Coupling::kFull;
  double tau_ = 0, smooth_ = 0, missing_ = 0;
  InPlaceLu lu_;
};

}  // namespace thenar::internal
