#pragma once

/// One digit with its tendons as a live picture: bones, skin, axes of joints, lines.

#include <memory>
#include <string>
#include <vector>

#include "live/digit_bodies.h"
#include "live/digit_lines.h"

namespace thenar {

/// The picture of a digit, whatever decides on its posture and its tensions.
class DigitPicture {
 public:
  /// @param tendons  of that digit of the subject; it is shared
  /// @param q        posture that the camera aims at [rad] (coordinates)
  /// @param look     whether bones and skin are those of the subject
  DigitPicture(const Subject& subject, const std::string& name,
               std::shared_ptr<const DigitTendons> tendons, const Eigen::VectorXd& q,
               DigitLook look = DigitLook::kAnatomy);

  /// Returns the constant parts of the picture; its arrows are the axes of the joints alone.
  [[nodiscard]] const LiveShape& shape() const { return shape_; }
  [[nodiscard]] const DigitTendons& tendons() const { return *tendons_; }
  [[nodiscard]] const DigitBodies& bodies() const { return bodies_; }
  /// The subject's frame in the picture.
  [[nodiscard]] const Pose<double>& placed() const { return bodies_.X_WS; }
  /// Returns warnings about bones that are drawn as capsules.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return bodies_.warnings; }

  /// @param q     [rad] (coordinates);  @param t  of each muscle [N] (muscles)
  /// @param rest  of the net there; of tendons without a net it is not read
  [[nodiscard]] LiveInstant instant(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                    const NetEquilibrium& rest) const;

 private:
  std::shared_ptr<const DigitTendons> tendons_;  // shared with whoever asks them for torques
  DigitBodies bodies_;
  DigitLines lines_;
  LiveShape shape_;
};

}  // namespace thenar
