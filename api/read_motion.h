#pragma once

/// Reader of recorded motions of digits.
///
///     const RecordedDigit run = read_motion("motion.h5");

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "data/io/subject.h"
#include "tendons/digit_tendons.h"

namespace thenar {

/// Motion written by write_motion(), with its rebuilt digit.
struct RecordedDigit {
  Subject subject;                              // subject of the recorded text
  std::string digit;                            // name of the digit
  std::shared_ptr<const DigitTendons> tendons;  // never null
  Eigen::VectorXd time;                         // instants, at least one, rising [s] (instants)
  Eigen::MatrixXd angle;                        // [rad] (instants, joints)
  Eigen::MatrixXd speed;                        // [rad/s] (instants, joints)
  Eigen::MatrixXd activation;                   // [1] (instants, muscles)
  Eigen::MatrixXd tension;                      // [N] (instants, muscles)
  Eigen::VectorXd energy;      // energy of motion, weights, springs and stops [J] (instants)
  Eigen::VectorXd work;        // work of the tendons on the joints [J] (instants)
  Eigen::VectorXd dissipated;  // energy dissipated by the dampers of the joints [J] (instants)
  std::vector<std::string> warnings;  // doubts about the record
};

/// Reads a motion. Its digit is built from the texts in the file, on the rungs that it states; in
/// files that state none, on those of its fidelity, with no joint frozen. The digit is verified by
/// its joints, its muscles and the tip at every instant.
/// @throws DataError or InputError if the file is no motion of a digit, its parts are inconsistent,
/// numbers are not finite or implausible for a hand, or the digit cannot be rebuilt.
[[nodiscard]] RecordedDigit read_motion(const std::string& path);

}  // namespace thenar
