#pragma once

/// Motions of digits from their files, to be looked at again.

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "data/io/subject.h"
#include "tendons/digit_tendons.h"

namespace thenar {

/// A motion as write_motion() wrote it, with its digit built again.
struct RecordedDigit {
  Subject subject;
  std::string digit;
  std::shared_ptr<const DigitTendons> tendons;  // never null
  Eigen::VectorXd time;                         // instants, at least one, rising [s] (instants)
  Eigen::MatrixXd angle;                        // [rad] (instants, joints)
  Eigen::MatrixXd speed;                        // [rad/s] (instants, joints)
  Eigen::MatrixXd activation;                   // [1] (instants, muscles)
  Eigen::MatrixXd tension;                      // [N] (instants, muscles)
  Eigen::VectorXd energy;      // energy of motion, weights, springs and stops [J] (instants)
  Eigen::VectorXd work;        // work of the tendons on the joints [J] (instants)
  Eigen::VectorXd dissipated;  // energy dissipated by the dampers of the joints [J] (instants)
  std::vector<std::string> warnings;
};

/// Reads a motion. Its digit is built from the texts that the file keeps, on the rungs that it
/// names; of files that name none, on those of its fidelity, with no joint frozen. That it is the
/// digit of the motion is held against its joints, its muscles and the tip at every instant.
/// @throws DataError or InputError saying what is wrong: no motion of a digit, what does not fit
/// together, numbers that are not finite or beyond any hand, a digit that cannot be built again.
[[nodiscard]] RecordedDigit read_motion(const std::string& path);

}  // namespace thenar
