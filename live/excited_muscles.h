#pragma once

/// Tensions that the excited muscles of a digit hold at rest.

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "data/io/subject.h"
#include "tendons/digit_tendons.h"
#include "tendons/muscle/musculotendon.h"

namespace thenar {

/// Muscles in steady state: activation equals excitation, fibres are still, tendons rigid.
///   tension = rigid_tendon_tension(excitation, length at optimum + lengthening, 0),
/// where the lengthening of a muscle is that of its whole tendon since all joints were at 0, there
/// every fibre has its optimal length. Without a fibre length: excitation times F0.
class ExcitedMuscles {
 public:
  /// @param tendons  of that subject's digit; a net counts as the whole tendons beneath it
  ExcitedMuscles(const Subject& subject, std::shared_ptr<const DigitTendons> tendons);

  /// @param excitation  0..1; NaN: none (muscles) [1]
  /// @param t           tensions of muscles without excitation (muscles) [N]
  /// @param q           posture (coordinates) [rad]
  /// @return tension of every muscle (muscles) [N]
  /// @throws InputError for an excitation outside of 0..1, or of a muscle without F0.
  [[nodiscard]] Eigen::VectorXd tensions(const Eigen::VectorXd& excitation,
                                         const Eigen::VectorXd& t, const Eigen::VectorXd& q) const;

  /// Returns assumptions about the excited muscles, and postures where their tensions are
  /// unreliable.
  [[nodiscard]] std::vector<std::string> warnings(const Eigen::VectorXd& excitation) const;

  /// Lengths of whole tendons, longer than with all joints at 0 [m] (muscles).
  [[nodiscard]] Eigen::VectorXd lengthening(const Eigen::VectorXd& q) const;

 private:
  std::shared_ptr<const DigitTendons> tendons_;  // shared with the digit that they pull
  const DigitTendons* whole_;                    // the same without a net
  std::vector<Musculotendon> muscles_;           // F0 infinite: unknown; no fibre: 0
  Eigen::VectorXd at_zero_;                      // lengths with all joints at 0 [m] (muscles)
  std::string trouble_at_zero_;                  // why not to trust them; empty: they are sound
};

}  // namespace thenar
