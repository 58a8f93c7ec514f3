#pragma once

/// Predicted forces beside measured ones, and how far apart they are.

#include <optional>
#include <string>
#include <vector>

#include "kinematics_fit/fit_residuals.h"

namespace thenar {

/// Forces of all trials of an experiment, and their Jacobian by the coordinates of a fit.
struct TrialPrediction {
  Eigen::Matrix3Xd force;  // [N] (3, trials)
  Eigen::MatrixXd J;       // [N] (3 trials, size); empty if not asked for
};

/// Experiment `e` of the problem at z.
/// @throws InputError if z has another size or is not finite.
[[nodiscard]] TrialPrediction predict_trials(const FitProblem& problem, const Eigen::VectorXd& z,
                                             int e, WithJacobian want);

/// One trial, predicted.
struct PredictedTrial {
  std::string posture;
  std::string loads;          // "FDS" or "FDS+EDC"
  Eigen::Vector3d measured;   // [N] (3)
  Eigen::Vector3d predicted;  // [N] (3)
  Eigen::Vector3d sd;         // predictive, of each component; zero if not asked for [N] (3)
};

/// Angle between the predicted and the measured force, 0 where either is zero [rad].
[[nodiscard]] double direction_error(const PredictedTrial& trial);

/// How far predictions are from measurements.
struct ForceError {
  double rms = 0;                 // root of the mean squared |predicted - measured| [N]
  double relative = 0;            // rms / root of the mean squared |measured| [1]
  double relative_flexion = 0;    // the same of the proximal and dorsal components alone [1]
  double direction = 0;           // median angle between them where neither is zero [rad]
  std::optional<double> covered;  // share of components within 1.96 predictive sds; empty: no sds
  int trials = 0;                 // that all this is of [1]
};

/// One experiment, predicted.
struct Prediction {
  std::string experiment;
  std::vector<PredictedTrial> trials;
  ForceError error;
  // The subject that predicts, or that the fit started from, was calibrated on this specimen: the
  // error is no error of a prediction of what was never seen.
  bool calibrated_on_specimen = false;
};

/// The muscles that pull in a trial: "FDS" or "EDC+FDS".
[[nodiscard]] std::string describe_loads(const Trial& trial);

/// Has the digit's subject been calibrated on this experiment's specimen?
[[nodiscard]] bool calibrated_on_specimen(const TendonDigit& digit, const Experiment& experiment);

/// Predicted forces beside the measured ones.
/// @param predicted, sd   [N] (3, trials)
/// @param calibrated_on_specimen  of the digit that predicted
[[nodiscard]] Prediction compare_forces(const Experiment& experiment,
                                        const Eigen::Matrix3Xd& predicted,
                                        const Eigen::Matrix3Xd& sd, bool calibrated_on_specimen);

/// @throws InputError if there is no trial, or every measured force is zero.
[[nodiscard]] ForceError force_error(const std::vector<PredictedTrial>& trials);

/// Experiment `e` of the problem at z, without predictive sds.
[[nodiscard]] Prediction predict_fitted(const FitProblem& problem, const Eigen::VectorXd& z, int e);

/// Any experiment, also of a specimen that was never fitted: then the population predicts. The
/// predictive variance adds what is not known of the parameters, how an unseen specimen differs
/// from the population, and the noise:
///   V = J_z C J_z' + J_u diag(unseen_variance) J_u' + J_q diag(angle variance) J_q' + diag(sd^2).
/// Angles of a posture that the fit does not know by name err by the mean prior variance of those
/// that it knows (J_q).
/// @param specimen  index in fitted.specimens(), or -1: one that was never fitted
/// @throws InputError if the experiment does not fit the digit.
[[nodiscard]] Prediction predict_experiment(const FitProblem& fitted, const Eigen::VectorXd& z,
                                            const Eigen::MatrixXd& C, const Experiment& experiment,
                                            int specimen);

/// The parameters, and after them an angle error of every joint in every posture of the experiment
/// that they do not name yet, with the mean prior of those that they do.
/// @param joints  coordinates of the digit
[[nodiscard]] FitParameters add_posture_errors(FitParameters fitted, const Experiment& experiment,
                                               int joints);

/// Index of a fitted specimen, or -1.
[[nodiscard]] int find_specimen(const FitProblem& fitted, const std::string& specimen);

}  // namespace thenar
