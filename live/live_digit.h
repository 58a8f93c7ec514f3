#pragma once

/// A digit of a subject with its tendons that a person moves: postures, tensions and excitations
/// in; torques, bands of the hood and the force of the tip out, at once.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "api/named/digits.h"
#include "base/progress.h"
#include "live/digit_picture.h"
#include "live/excited_muscles.h"
#include "live/live_picture.h"
#include "tendons/net/digit_sweep.h"

namespace thenar {

/// Changes of a digit; inputs that are not named stay.
struct DigitInputs {
  std::map<std::string, double> posture;     // joint -> angle [rad]
  std::map<std::string, double> tension;     // muscle -> tension [N]; it is no longer excited
  std::map<std::string, double> excitation;  // muscle -> 0..1; its tension follows from that [1]
};

/// A digit at one posture under its tensions.
struct DigitNow {
  Eigen::VectorXd excitation;  // 0..1; NaN of muscles whose tension is given [1] (muscles)
  Eigen::VectorXd tension;     // [N] (muscles)
  Eigen::VectorXd length;      // of each muscle's line, longer than with all joints at 0 under the
                               // same tensions; NaN where that is not to be trusted, and of a slack
                               // muscle of a net [m] (muscles)
  DigitPoint point;            // read point.pull.status first: trusted()
  Eigen::MatrixXd arms;  // moment arms, flexion and radial +; NaN where not to be trusted, and
                         // of muscles of a net that are slack, or whose torque has a corner there
                         // [m/rad] (muscles, coordinates)
  std::vector<std::string> warnings;  // of this posture and these tensions
};

/// Moment arms and lengths of all muscles over one joint; NaN where there is no answer.
struct DigitCurves {
  std::string joint;
  Eigen::VectorXd angle;    // [rad] (postures)
  Eigen::MatrixXd arms;     // about the joint, flexion and radial + [m/rad] (muscles, postures)
  Eigen::MatrixXd lengths;  // longer than with all joints at 0; of a net as it lengthens under the
                            // present tensions [m] (muscles, postures)
  std::vector<std::string> warnings;
};

/// A live digit. Whatever it is told, its answer depends on its present inputs alone: a net comes
/// to every posture from the straight finger under the present tensions, as in solve_tendons().
///
/// An excited muscle pulls with what it holds in the end, see ExcitedMuscles.
class LiveDigit final : public LiveModel {
 public:
  /// @param request  its posture is the first one; `vary` and `map` must be empty. Without hood and
  ///                 net: a floating net where the digit can carry one, else fixed fractions where
  ///                 the subject has them, with a warning
  /// @throws InputError or DataError saying what is unknown or missing.
  explicit LiveDigit(const DigitRequest& request);

  /// Changes inputs and solves the digit. Angles end at the limits of their joints.
  /// @returns the joints whose angles were limited
  /// @throws InputError for what is unknown or out of range; the digit then is as it was.
  std::vector<std::string> set(const DigitInputs& inputs);

  /// Moment arms and lengths over the whole range of a joint, the others as they stand: those of
  /// compute_moment_arms(); of a net those of sweep_tendons() under the present tensions.
  /// @param count  postures, 2 .. 1000
  /// @throws InputError for an unknown joint.
  [[nodiscard]] DigitCurves sweep(const std::string& joint, int count,
                                  const Progress& progress = {}) const;

  [[nodiscard]] const DigitCase& about() const { return case_; }
  [[nodiscard]] const DigitNow& now() const { return now_; }
  /// Returns the warnings from building the digit.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }
  /// The subject's frame in the picture; everything but the picture is in the subject's frame.
  [[nodiscard]] const Pose<double>& placed() const { return picture_->placed(); }

  [[nodiscard]] const LiveShape& shape() const override { return shape_; }
  [[nodiscard]] LiveInstant instant() const override;
  [[nodiscard]] unsigned long shape_changes() const override { return 0; }
  [[nodiscard]] unsigned long changes() const override { return changes_; }

 private:
  /// Results that tensions alone decide, so that a posture is solved without finding them again.
  struct UnderTension {
    Eigen::VectorXd tension;       // empty: none yet [N] (muscles)
    NetEquilibrium straight_rest;  // of a net in the straight finger
    Eigen::VectorXd zero_length;   // of lines with all joints at 0; NaN: see DigitNow::length [m]
  };

  void build_shape();
  [[nodiscard]] Eigen::VectorXd with_angles(const std::map<std::string, double>& posture,
                                            std::vector<std::string>& limited) const;
  [[nodiscard]] Eigen::VectorXd with_excitations(const DigitInputs& inputs) const;
  /// Finds the answer at a posture; where that fails, the present one stays whole.
  void solve(const Eigen::VectorXd& q, const Eigen::VectorXd& excitation, const Eigen::VectorXd& t);
  [[nodiscard]] UnderTension under(const Eigen::VectorXd& t) const;
  [[nodiscard]] DigitPoint point_at(const Eigen::VectorXd& q, const UnderTension& under) const;
  [[nodiscard]] Eigen::MatrixXd arms_at(const DigitPoint& point, const Eigen::VectorXd& t) const;
  [[nodiscard]] Eigen::VectorXd lengths_at(const DigitPoint& point, const Eigen::VectorXd& t) const;
  /// Returns the reason why a point of a net is doubtful; "" if it is not.
  [[nodiscard]] std::string doubt_at(const DigitPoint& point) const;
  [[nodiscard]] DigitCurves net_curves(const std::string& joint, const PostureGrid& grid,
                                       const Progress& progress) const;

  DigitCase case_;
  std::vector<std::string> warnings_;
  std::unique_ptr<DigitPicture> picture_;
  std::unique_ptr<ExcitedMuscles> muscles_;
  LiveShape shape_;
  DigitNow now_;
  UnderTension under_;
  unsigned long changes_ = 0;
};

}  // namespace thenar
