#pragma once

/// Live picture of one digit with its tendons: bones, skin, joint axes, tendon lines.

#include <memory>
#include <string>
#include <vector>

#include "live/digit_bodies.h"
#include "live/digit_lines.h"

namespace thenar {

/// Picture of a digit. The caller supplies postures and tensions: a live digit, a fit, or a
/// recording.
class DigitPicture {
 public:
  /// @param name     name of the digit
  /// @param tendons  tendons of that digit; ownership is shared
  /// @param q        posture that the camera frames [rad] (coordinates)
  /// @param look     shapes of the bones: the subject's anatomy, or capsules
  DigitPicture(const Subject& subject, const std::string& name,
               std::shared_ptr<const DigitTendons> tendons, const Eigen::VectorXd& q,
               DigitLook look = DigitLook::kAnatomy);

  /// Returns the constant parts of the picture; its only arrows are the joint axes.
  [[nodiscard]] const LiveShape& shape() const { return shape_; }
  [[nodiscard]] const DigitTendons& tendons() const { return *tendons_; }
  [[nodiscard]] const DigitBodies& bodies() const { return bodies_; }
  /// Returns the pose of the subject's frame in the picture.
  [[nodiscard]] const Pose<double>& subject_pose() const { return bodies_.X_WS; }
  /// Returns the reasons why bones are drawn as capsules.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return bodies_.warnings; }

  /// Returns the moving parts of the picture at a posture.
  /// @param q     posture [rad] (coordinates)
  /// @param t     tensions of the muscles [N] (muscles)
  /// @param rest  equilibrium of the net at that posture; ignored without a net
  [[nodiscard]] LiveInstant instant(const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                    const NetEquilibrium& rest) const;

 private:
  std::shared_ptr<const DigitTendons> tendons_;  // shared with the caller
  DigitBodies bodies_;
  DigitLines lines_;
  LiveShape shape_;
};

}  // namespace thenar
