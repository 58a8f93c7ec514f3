#pragma once

/// What tendon tensions do to one digit, whatever the rungs of path and hood.

#include <memory>
#include <string>

#include <Eigen/Core>

#include "tendons/tendon_model.h"

namespace thenar {

/// Tension in the slips of the extensor hood [N].
struct SlipTension {
  double central = 0, radial = 0, ulnar = 0, terminal = 0;
};

/// Torque of all tendons at one posture.
struct [[nodiscard]] TendonPull {
  Eigen::VectorXd tau;     // joint torque of the tendons [N m] (coordinates)
  Eigen::MatrixXd R;       // d tau / d tension, transposed: moment arms, flexion + (muscles,
                           // coordinates) [m/rad]
  SlipTension slips;       // zero without a hood
  Eigen::Matrix3Xd nodes;  // of a net at rest, world; hand it on as the next start [m] (3, nodes)
  std::string trouble;     // why not to trust this; empty: nothing
};

/// One digit with its tendons. Linear rungs have  tau = R' t; a net has not.
class DigitTendons {
 public:
  virtual ~DigitTendons() = default;

  /// Bones, names, limits and what was built.
  [[nodiscard]] virtual const TendonDigit& digit() const = 0;

  /// @param q      posture [rad] (coordinates)
  /// @param t      tension of each muscle, >= 0 [N] (muscles)
  /// @param start  nodes of a net to start from: of a neighbouring posture; empty: none
  /// @throws InputError if a length is wrong, an entry not finite or a tension negative.
  virtual TendonPull pull(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                          const Eigen::Matrix3Xd& start) const = 0;

  /// d tau / d q at these tensions, by central differences of pull(), whose moment arms are smooth;
  /// a net knows better [N m/rad] (coordinates, coordinates).
  /// @param at  pull() there
  [[nodiscard]] virtual Eigen::MatrixXd torque_by_posture(const Eigen::VectorXd& q,
                                                          const Eigen::VectorXd& t,
                                                          const TendonPull& at) const;

  /// Moment arms averaged over +-width of each joint in turn. Those of a net jump where a node
  /// meets a bone or a band begins to bend over one; their averages are continuous.
  /// @param at  pull() there
  /// @return [m/rad] (muscles, coordinates)
  [[nodiscard]] virtual Eigen::MatrixXd mean_arms(const Eigen::VectorXd& /*q*/,
                                                  const Eigen::VectorXd& /*t*/,
                                                  const TendonPull& at, double /*width*/) const {
    return at.R;
  }

  /// The same digit with bands of a net that go from slack to taut over this strain, so that its
  /// torque is smooth where they do; null where there is no net.
  /// @throws InputError if it is negative or not finite.
  [[nodiscard]] virtual std::unique_ptr<DigitTendons> blended(double /*strain*/) const {
    return nullptr;
  }

  TendonPull pull(const Eigen::VectorXd& q, const Eigen::VectorXd& t) const {
    return pull(q, t, {});
  }
};

}  // namespace thenar
