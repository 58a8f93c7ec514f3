#pragma once

/// Steady-state tensions of the excited muscles of a digit.

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "data/io/subject.h"
#include "tendons/digit_tendons.h"
#include "tendons/muscle/musculotendon.h"

namespace thenar {

/// Muscles in steady state: activation equals excitation, fibre velocity is zero, tendons are
/// rigid.
///   tension = rigid_tendon_tension(excitation, length at optimum + lengthening, 0),
/// where the lengthening is the length of the whole tendon minus its length with all joints at 0.
/// Every fibre is assumed to have its optimal length with all joints at 0. A muscle without a known
/// fibre length pulls with excitation times F0.
class ExcitedMuscles {
 public:
  /// @param tendons  tendons of a digit of that subject; a net is replaced by its linear tendons
  ExcitedMuscles(const Subject& subject, std::shared_ptr<const DigitTendons> tendons);

  /// Computes the tension of every muscle [N] (muscles).
  /// @param excitation  0..1; NaN: the muscle has a given tension [1] (muscles)
  /// @param t           tensions of muscles without excitation [N] (muscles)
  /// @param q           posture [rad] (coordinates)
  /// @throws InputError for an excitation outside 0..1, or if F0 of an excited muscle is unknown
  [[nodiscard]] Eigen::VectorXd tensions(const Eigen::VectorXd& excitation,
                                         const Eigen::VectorXd& t, const Eigen::VectorXd& q) const;

  /// Returns assumptions about the excited muscles, and reasons why their tensions are unreliable.
  [[nodiscard]] std::vector<std::string> warnings(const Eigen::VectorXd& excitation) const;

  /// Returns the lengths of the whole tendons minus those with all joints at 0 [m] (muscles).
  [[nodiscard]] Eigen::VectorXd lengthening(const Eigen::VectorXd& q) const;

 private:
  std::shared_ptr<const DigitTendons> tendons_;  // shared with the caller
  const DigitTendons* whole_tendons_;            // tendons_, or the linear tendons of their net
  std::vector<Musculotendon> muscles_;           // unknown F0: infinite; unknown fibre length: 0
  Eigen::VectorXd length_at_zero_;               // lengths with all joints at 0 [m] (muscles)
  std::string zero_warning_;  // reason why length_at_zero_ is unreliable; empty: it is reliable
};

}  // namespace thenar
