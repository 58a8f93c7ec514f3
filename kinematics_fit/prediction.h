#pragma once

/// Predicted and measured forces, and their errors.

#include <optional>
#include <string>
#include <vector>

#include "base/numbers.h"
#include "kinematics_fit/fit_problem.h"
#include "solvers/arrow_factor.h"

namespace thenar {

/// Predicts the forces of all trials of experiment `e` of the problem at z [N] (3, trials).
/// @throws InputError if z has another size or is not finite.
[[nodiscard]] Eigen::Matrix3Xd predict_trials(const FitProblem& problem, const Eigen::VectorXd& z,
                                              int e);

/// Measured and predicted force of one trial.
struct PredictedTrial {
  std::string posture;
  std::string loads;          // "FDS", "FDS+EDC" or "FDS at MC3"
  Eigen::Vector3d measured;   // [N] (3)
  Eigen::Vector3d predicted;  // [N] (3)
  Eigen::Vector3d sd;         // predictive sd of each component; zero if not requested [N] (3)
  int components = 3;  // number of fitted components, 2 or 3; the others are 0, of infinite sd [1]
  std::optional<Eigen::Vector3d> trivial = {};  // prediction without a model, see trivial_force();
                                                // empty: not requested, or not possible [N] (3)
  bool by_draws = false;  // the force is a median of draws, because it is too nonlinear in the
                          // uncertain parameters; see predictive_moments()
};

/// Returns the angle between the predicted and the measured force; 0 if either is zero [rad].
[[nodiscard]] double direction_error(const PredictedTrial& trial);

/// Errors of predicted forces; NaN without trials.
struct ForceError {
  double rms = kNaN;               // root mean square of |predicted - measured| [N]
  double relative = kNaN;          // rms over the root mean square of |measured| [1]
  double relative_flexion = kNaN;  // relative error of the first two components [1]
  double direction =
      kNaN;  // median angle between predicted and measured forces, if neither is zero [rad]
  std::optional<double>
      covered;  // share of components within 1.96 predictive sds; empty without sds
  std::optional<double>
      log_loss;    // mean over components of -log N(measured; predicted, sd^2), with densities per
                   // newton; measures errors and sds together [nat]
  int trials = 0;  // number of trials [1]
};

/// Predictions of one experiment.
struct Prediction {
  std::string experiment;
  std::vector<PredictedTrial> trials;
  ForceError error;
  // The subject that predicts, or from which the fit started, was calibrated on this specimen: the
  // error is not that of an unseen specimen.
  bool calibrated_on_specimen = false;
};

/// Returns the muscles that pull in a trial: "FDS" or "EDC+FDS"; "FDS at MC3" if the load cell was
/// there.
[[nodiscard]] std::string describe_loads(const Trial& trial);

/// Returns whether the digit's subject was calibrated on the experiment's specimen.
[[nodiscard]] bool calibrated_on_specimen(const TendonDigit& digit, const Experiment& experiment);

/// Combines predicted and measured forces with their errors.
/// @param predicted, sd           forces and predictive sds [N] (3, trials)
/// @param calibrated_on_specimen  the predicting digit was calibrated on the specimen
[[nodiscard]] Prediction compare_forces(const Experiment& experiment,
                                        const Eigen::Matrix3Xd& predicted,
                                        const Eigen::Matrix3Xd& sd, bool calibrated_on_specimen);

/// Computes the errors. @throws InputError if there is no trial, or every measured force is zero.
[[nodiscard]] ForceError force_error(const std::vector<PredictedTrial>& trials);

/// Predicts experiment `e` of the problem at z, without predictive sds.
[[nodiscard]] Prediction predict_fitted(const FitProblem& problem, const Eigen::VectorXd& z, int e);

/// Index that denotes a specimen that was not fitted and is predicted from the population.
inline constexpr int kUnfittedSpecimen = -1;

/// Predicts any experiment; a specimen that was not fitted is predicted from the population. The
/// prediction is the mean of the forces over the uncertain parameters, see predictive_moments(),
/// with
///   V_u = du/dz C du/dz' + diag(unseen_variance) + diag(variance of unknown postures),
/// and its predictive variance also includes the noise. Errors of a posture whose name is not part
/// of the fit have the mean prior variance of the fitted postures.
/// @param specimen  index in fitted.specimens(), or kUnfittedSpecimen
/// @throws InputError if the experiment does not fit the digit.
[[nodiscard]] Prediction predict_experiment(const FitProblem& fitted, const Eigen::VectorXd& z,
                                            const ArrowMatrix& C, const Experiment& experiment,
                                            int specimen);

/// Returns the parameters, followed by errors of angles and unexplained forces of every posture of
/// the experiment that they do not name yet, with the mean prior of the named postures.
[[nodiscard]] FitParameters add_posture_errors(FitParameters fitted, const Experiment& experiment);

/// Returns a warning that names the first trial whose force is a median of draws, and their number.
[[nodiscard]] std::vector<std::string> unsteady_force_warnings(const Prediction& prediction);

/// Returns the index of a fitted specimen, or kUnfittedSpecimen.
[[nodiscard]] int find_specimen(const FitProblem& fitted, const std::string& specimen);

}  // namespace thenar
