#pragma once

/// Live view of a fit, or of draws from a posterior: the fitted digit in the postures of the
/// trials, its joint axes, measured and predicted forces.

#include <memory>
#include <string>
#include <vector>

#include "kinematics_fit/model/predict_forces.h"
#include "live/digit_picture.h"
#include "live/fit_source.h"
#include "live/live_picture.h"
#include "tendons/neighbouring_axes.h"

namespace thenar {

/// One trial of an experiment that was fitted.
struct LiveTrial {
  int experiment = 0;  // entry of the experiments of FitSource::problem
  int trial = 0;       // entry of the experiment's trials
  int specimen = 0;    // entry of FitSource::specimens
};

/// Relative position of two neighbouring axes, with the interval that holds 90 % of the draws.
struct LiveAxisPair {
  NeighbouringAxes axes;
  AxisOffset estimate;      // fitted offset, or the mean of each number over the draws [rad], [m]
  AxisOffset lower, upper;  // 5 % and 95 % quantiles of the draws; for a fit, the estimate
};

/// Live fit. It shows one trial: the digit of its specimen with the fitted axes and tendons, in the
/// trial's posture with the fitted errors of angles, under the trial's tensions. Forces are drawn
/// at the points of measurement; components that were not measured are left out of both arrows. The
/// axes of the draws are clouds on the bone proximal of each joint.
class LiveFit final : public LiveModel {
 public:
  /// @param path  result of a fit (.h5) or posterior (.nc)
  /// @throws InputError for another kind of file or one without trials; DataError for a damaged one
  explicit LiveFit(const std::string& path);

  /// Shows a trial. @param trial  entry of trials(), from 0  @throws InputError if it is out of
  /// range
  void show_trial(int trial);

  [[nodiscard]] const FitSource& source() const { return source_; }
  [[nodiscard]] const std::vector<LiveTrial>& trials() const { return trials_; }
  [[nodiscard]] int shown_trial() const { return shown_trial_; }
  [[nodiscard]] const PredictedTrial& predicted(int trial) const;
  /// Returns the fitted digit of the specimen that is shown.
  [[nodiscard]] const TendonDigit& digit() const {
    return pictures_[specimen()].picture->tendons().digit();
  }
  /// Returns the digit's posture with the fitted errors of angles [rad] (coordinates).
  [[nodiscard]] Eigen::VectorXd posture() const { return posed_.angles; }
  [[nodiscard]] const std::vector<LiveAxisPair>& axis_pairs() const {
    return pictures_[specimen()].pairs;
  }
  /// Returns the pose of the subject's frame in the picture. All other results of this class are in
  /// the subject's frame.
  [[nodiscard]] const Pose<double>& subject_pose() const {
    return pictures_[specimen()].picture->subject_pose();
  }
  /// Returns warnings about the file, and about a net without equilibrium in the trial.
  [[nodiscard]] std::vector<std::string> warnings() const;

  [[nodiscard]] const LiveShape& shape() const override { return pictures_[specimen()].shape; }
  [[nodiscard]] LiveInstant instant() const override;
  [[nodiscard]] unsigned long shape_changes() const override { return shape_changes_; }
  [[nodiscard]] unsigned long changes() const override { return changes_; }

 private:
  /// Fitted specimen and its picture.
  struct SpecimenPicture {
    SpecimenModel<double> model;
    std::unique_ptr<DigitPicture> picture;  // picture of the digit with its fitted tendons
    std::vector<LiveAxisPair> pairs;
    LiveShape shape;  // shape of the picture with force arrows and axis clouds added
  };
  [[nodiscard]] SpecimenPicture draw_specimen(int specimen) const;
  [[nodiscard]] std::size_t specimen() const {
    return static_cast<std::size_t>(trials_[shown_trial_].specimen);
  }
  [[nodiscard]] const ExperimentPlan& plan() const;
  /// Frame in which the force of a trial was measured, seen from the subject's frame.
  struct ForceFrame {
    Eigen::Vector3d point{0, 0, 0};                   // point of measurement [m] (3)
    Eigen::Matrix3d R = Eigen::Matrix3d::Identity();  // rotation of the experiment's components
                                                      // into the subject's frame (3, 3)
  };
  [[nodiscard]] ForceFrame force_frame() const;

  FitSource source_;
  std::vector<LiveTrial> trials_;
  std::vector<SpecimenPicture> pictures_;  // one for each specimen
  int shown_trial_ = 0;
  PosedSpecimen<double> posed_;  // specimen in the posture of the trial that is shown
  Eigen::VectorXd tension_;      // tensions at the digit in that trial [N] (muscles)
  NetEquilibrium rest_;          // equilibrium of the net; empty without a net
  std::string net_warning_;      // reason why rest_ is unreliable; empty: it is reliable
  unsigned long shape_changes_ = 0, changes_ = 0;
};

}  // namespace thenar
