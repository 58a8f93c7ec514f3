#pragma once

/// High-order steps of a scene while no contact, joint limit or dry friction acts.

#include "dynamics/stepping/contact_step.h"
#include "dynamics/stepping/dormand_prince.h"

namespace thenar {

/// Dormand and Prince's explicit Runge-Kutta method of order eight, with an estimate of its error
/// from methods of orders five and three. Source: [Hairer1993] sections II.5 and II.10.
class FreeStep {
 public:
  static constexpr std::size_t kStages = DormandPrince::kStages;

  /// @param scene  any ContactStep of the scene, for the sizes
  explicit FreeStep(const ContactStep& scene);

  /// Error estimate of a step.
  struct Error {
    double q = 0;       // error of positions [m], [rad]
    double v = 0;       // error of velocities [m/s], [rad/s]
    double z = 0;       // error of element states, each in its unit
    bool acted = true;  // all elements had a valid force at all stages
  };

  /// Advances a state by h [s] and normalises its quaternions; the error estimate falls as h^8. A
  /// step from the same state as the last one reuses its first stage.
  Error take_step(ContactStep& scene, double h, SceneState& state);

  /// Discards the stored first stage. Call when active forces or elements have changed.
  void discard_first_stage() { first_.t = std::numeric_limits<double>::quiet_NaN(); }

 private:
  /// Copies positions, velocities and element states of y into stage_.
  void unpack(const Eigen::VectorXd& y);
  /// Computes the rates at stage_ as one column. @return false if an element has no valid force
  bool compute_rates(ContactStep& scene, Eigen::Index stage);

  /// Combines the error estimates of orders five and three for some entries.
  [[nodiscard]] double error_of(Eigen::Index first, Eigen::Index count) const;

  Eigen::Index flows_;  // number of energy flows to integrate; 0: nothing does work
  // Rows: positions, velocities, element states and flows, then zeros up to whole SIMD blocks.
  Eigen::MatrixXd rates_;                                   // (rows, stages)
  Eigen::VectorXd y_begin_, y_, error_five_, error_three_;  // (rows)
  Eigen::VectorXd q_dot_, v_dot_, z_dot_;
  SceneState stage_, first_;  // first_: state of column 0 of rates_; t is NaN if none
  bool first_acted_ = true;   // all elements had a valid force there
};

}  // namespace thenar
