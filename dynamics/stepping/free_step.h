#pragma once

/// Steps of a scene on which no contact, limit or dry friction acts.

#include "dynamics/stepping/contact_step.h"
#include "dynamics/stepping/dormand_prince.h"

namespace thenar {

/// Dormand and Prince's explicit Runge-Kutta method of order eight, with an estimate of its error
/// from methods of orders five and three. Source: [Hairer1993] sections II.5 and II.10.
class FreeStep {
 public:
  static constexpr std::size_t kStages = DormandPrince::kStages;

  /// @param scene  for the sizes
  explicit FreeStep(const ContactStep& scene);

  /// Error of a step.
  struct Error {
    double q;    // of positions [m], [rad]
    double v;    // of speeds [m/s], [rad/s]
    double z;    // of states of elements, each in its unit
    bool acted;  // all elements could act at all stages
  };

  /// Moves a state by h. Quaternions have length 1 afterwards. The error falls with h^8. A step
  /// from where the last one began uses its first stage again, as long as the same forces act.
  Error step(ContactStep& scene, double h, SceneState& state);

  /// Rates at a state may have changed since the last step: forces that act, or elements.
  void forget() { first_.t = std::numeric_limits<double>::quiet_NaN(); }

 private:
  void put(const Eigen::VectorXd& y);
  bool find_rates(ContactStep& scene, Eigen::Index stage);

  /// Error of some entries of the rates' sums e_5 and e_3.
  [[nodiscard]] double error_of(Eigen::Index first, Eigen::Index count) const;

  Eigen::Index flows_;  // of energy; none: they stand still
  // Of positions, speeds, states and flows, and zeros that fill up the last block of rows.
  Eigen::MatrixXd rates_;                     // (q + v + z + flows and a rest, stages)
  Eigen::VectorXd begin_, y_, five_, three_;  // (q + v + z + flows and a rest)
  Eigen::VectorXd q_dot_, v_dot_, z_dot_;
  SceneState at_, first_;    // first_: where column 0 of the rates belongs
  bool first_acted_ = true;  // elements could act there
};

}  // namespace thenar
