#pragma once

/// Interactive digit with tendons: given a posture, tensions and excitations, it returns the joint
/// torques, the tensions of the extensor hood and the force of the fingertip.

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

/// Changes of a digit's inputs; inputs that are not named keep their values.
struct DigitInputs {
  std::map<std::string, double> posture;     // joint -> angle [rad]
  std::map<std::string, double> tension;     // muscle -> tension; ends its excitation [N]
  std::map<std::string, double> excitation;  // muscle -> excitation 0..1, sets its tension [1]
};

/// Solution of a digit at one posture under its tensions.
struct DigitState {
  Eigen::VectorXd excitation;  // 0..1; NaN: the muscle has a given tension [1] (muscles)
  Eigen::VectorXd tension;     // tensions of the muscles [N] (muscles)
  Eigen::VectorXd length;      // lengths of the muscles' lines minus those with all joints at 0
                               // under the same tensions; NaN if unreliable, and for slack muscles
                               // of a net [m] (muscles)
  DigitPoint point;            // tendon solution; valid if is_trusted(point.pull.status)
  Eigen::MatrixXd arms;  // moment arms, flexion and radial positive; NaN if unreliable, for slack
                         // muscles of a net, and where the torque is not differentiable [m/rad]
                         // (muscles, coordinates)
  std::vector<std::string> warnings;  // warnings about this posture and these tensions
};

/// Moment arms and lengths of all muscles over one joint; NaN where there is no solution.
struct DigitCurves {
  std::string joint;        // joint that varies
  Eigen::VectorXd angle;    // angles of the joint [rad] (postures)
  Eigen::MatrixXd arms;     // moment arms, flexion and radial positive [m/rad] (muscles, postures)
  Eigen::MatrixXd lengths;  // lengths minus those with all joints at 0, for a net under the current
                            // tensions [m] (muscles, postures)
  std::vector<std::string> warnings;
};

/// Live digit. Its solution depends only on the current inputs, not on their history: a net is
/// followed from the straight finger to every posture under the current tensions, as in
/// solve_tendons(). Excited muscles pull with their steady-state tension, see ExcitedMuscles.
class LiveDigit final : public LiveModel {
 public:
  /// @param request  digit and initial posture; `vary` and `map` must be empty. If it names neither
  ///                 hood nor net, the digit gets a floating net if it can have one, else the
  ///                 subject's fixed fractions and a warning
  /// @throws InputError, DataError for unknown or missing parts of the subject
  explicit LiveDigit(const DigitRequest& request);

  /// Changes inputs and solves the digit. Angles are clamped to the limits of their joints.
  /// @return names of the joints whose angles were clamped
  /// @throws InputError for unknown names or values out of range; the digit is then unchanged
  std::vector<std::string> set(const DigitInputs& inputs);

  /// Computes moment arms and lengths over the whole range of a joint, with all other joints in
  /// their current posture. Uses compute_moment_arms(), or for a net sweep_tendons() under the
  /// current tensions.
  /// @param count  number of postures, 2 to 1000
  /// @throws InputError for an unknown joint
  [[nodiscard]] DigitCurves sweep(const std::string& joint, int count,
                                  const Progress& progress = {}) const;

  [[nodiscard]] const DigitCase& digit_case() const { return case_; }
  [[nodiscard]] const DigitState& state() const { return state_; }
  /// Returns the warnings from building the digit.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }
  /// Returns the pose of the subject's frame in the picture. All other results of this class are in
  /// the subject's frame.
  [[nodiscard]] const Pose<double>& subject_pose() const { return picture_->subject_pose(); }

  [[nodiscard]] const LiveShape& shape() const override { return shape_; }
  [[nodiscard]] LiveInstant instant() const override;
  [[nodiscard]] unsigned long shape_changes() const override { return 0; }
  [[nodiscard]] unsigned long changes() const override { return changes_; }

 private:
  /// Results that depend on the tensions alone, cached for all postures under these tensions.
  struct TensionBaseline {
    Eigen::VectorXd tension;       // tensions; empty: nothing is cached [N] (muscles)
    NetEquilibrium straight_rest;  // equilibrium of a net in the straight finger
    Eigen::VectorXd zero_length;   // lengths of the muscles' lines with all joints at 0; NaN as in
                                   // DigitState::length [m] (muscles)
  };

  void build_shape();
  [[nodiscard]] Eigen::VectorXd limited_posture(const std::map<std::string, double>& posture,
                                                std::vector<std::string>& limited) const;
  [[nodiscard]] Eigen::VectorXd merged_excitations(const DigitInputs& inputs) const;
  /// Solves the digit and replaces state_; leaves it unchanged if this throws.
  void solve(const Eigen::VectorXd& q, const Eigen::VectorXd& excitation, const Eigen::VectorXd& t);
  [[nodiscard]] TensionBaseline baseline_at(const Eigen::VectorXd& t) const;
  [[nodiscard]] DigitPoint point_at(const Eigen::VectorXd& q,
                                    const TensionBaseline& baseline) const;
  [[nodiscard]] Eigen::MatrixXd arms_at(const DigitPoint& point, const Eigen::VectorXd& t) const;
  [[nodiscard]] Eigen::VectorXd lengths_at(const DigitPoint& point, const Eigen::VectorXd& t) const;
  /// Returns the reason why a point of a net is unreliable; "" if it is reliable.
  [[nodiscard]] std::string reliability_warning(const DigitPoint& point) const;
  [[nodiscard]] DigitCurves net_curves(const std::string& joint, const PostureGrid& grid,
                                       const Progress& progress) const;

  DigitCase case_;
  std::vector<std::string> warnings_;
  std::unique_ptr<DigitPicture> picture_;
  std::unique_ptr<ExcitedMuscles> muscles_;
  LiveShape shape_;
  DigitState state_;
  TensionBaseline baseline_;
  unsigned long changes_ = 0;
};

}  // namespace thenar
