#pragma once

/// A fit, or draws from a posterior, as a picture: the fitted digit in the postures of the trials,
/// its joint axes, and measured against predicted forces.

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
  int experiment = 0;  // in FitSource::problem
  int trial = 0;       // of the experiment
  int specimen = 0;
};

/// Relative position of two neighbouring axes, and the range of 90 % of the draws.
struct LiveAxisPair {
  NeighbouringAxes axes;
  AxisOffset estimate;   // of a fit, or means of the draws, each number by itself [rad], [m]
  AxisOffset low, high;  // 5 and 95 % of the draws; the estimate of a fit
};

/// A live fit. It shows one trial: the digit of its specimen with the fitted axes and tendons, in
/// the trial's posture with its fitted errors, under the trial's tensions. Forces are drawn where
/// they were measured; components that were not measured are left out of both. Axes of draws are
/// clouds on the bone proximal of each joint.
class LiveFit final : public LiveModel {
 public:
  /// @param path  of a result of a fit (.h5) or a posterior (.nc)
  /// @throws InputError if it is something else; DataError if it is damaged.
  explicit LiveFit(const std::string& path);

  /// Shows another trial. @throws InputError if there is none of that number.
  void show(int trial);

  [[nodiscard]] const FitSource& source() const { return source_; }
  [[nodiscard]] const std::vector<LiveTrial>& trials() const { return trials_; }
  [[nodiscard]] int shown() const { return shown_; }
  [[nodiscard]] const PredictedTrial& predicted(int trial) const;
  /// The digit of the specimen that is shown, as fitted.
  [[nodiscard]] const TendonDigit& digit() const {
    return looks_[specimen()].picture->tendons().digit();
  }
  /// Returns the digit's posture with the fitted errors of angles [rad] (coordinates).
  [[nodiscard]] Eigen::VectorXd posture() const { return posed_.angles; }
  [[nodiscard]] const std::vector<LiveAxisPair>& axis_pairs() const {
    return looks_[specimen()].pairs;
  }
  /// The subject's frame in the picture; everything but the picture is in the subject's frame.
  [[nodiscard]] const Pose<double>& placed() const { return looks_[specimen()].picture->placed(); }
  /// Returns warnings about the file, and about a net that is not at rest in the trial.
  [[nodiscard]] std::vector<std::string> warnings() const;

  [[nodiscard]] const LiveShape& shape() const override { return looks_[specimen()].shape; }
  [[nodiscard]] LiveInstant instant() const override;
  [[nodiscard]] unsigned long shape_changes() const override { return shape_changes_; }
  [[nodiscard]] unsigned long changes() const override { return changes_; }

 private:
  /// One specimen as it is drawn.
  struct Look {
    SpecimenModel<double> model;
    std::unique_ptr<DigitPicture> picture;  // of the fitted tendons
    std::vector<LiveAxisPair> pairs;
    LiveShape shape;  // that of the picture, with forces and draws
  };
  [[nodiscard]] Look look_of(int specimen) const;
  [[nodiscard]] std::size_t specimen() const {
    return static_cast<std::size_t>(trials_[shown_].specimen);
  }
  [[nodiscard]] const ExperimentPlan& plan() const;
  /// Point where the force of the trial was measured, and the rotation of its components into the
  /// subject's frame.
  struct ForcePlace {
    Eigen::Vector3d from;      // [m] (3)
    Eigen::Matrix3d to_frame;  // from components of the experiment (3, 3)
  };
  [[nodiscard]] ForcePlace force_place() const;

  FitSource source_;
  std::vector<LiveTrial> trials_;
  std::vector<Look> looks_;  // of each specimen
  int shown_ = 0;
  PosedSpecimen<double> posed_;  // in the trial that is shown
  Eigen::VectorXd tension_;      // at the digit in that trial [N] (muscles)
  NetEquilibrium rest_;          // of the net there; without nodes where there is none
  std::string net_trouble_;      // why it is not to be trusted; empty: it is
  unsigned long shape_changes_ = 0, changes_ = 0;
};

}  // namespace thenar
