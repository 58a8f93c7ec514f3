#pragma once

/// Predicted forces beside the measured forces, and their errors.

#include <optional>
#include <string>
#include <vector>

#include "base/numbers.h"
#include "kinematics_fit/fit_problem.h"
#include "solvers/arrow_factor.h"

namespace thenar {

/// Forces of all trials of experiment `e` of the problem at z [N] (3, trials).
/// @throws InputError if z has another size or is not finite.
[[nodiscard]] Eigen::Matrix3Xd predict_trials(const FitProblem& problem, const Eigen::VectorXd& z,
                                              int e);

/// One trial, predicted.
struct PredictedTrial {
  std::string posture;
  std::string loads;          // "FDS", "FDS+EDC" or "FDS at MC3"
  Eigen::Vector3d measured;   // [N] (3)
  Eigen::Vector3d predicted;  // [N] (3)
  Eigen::Vector3d sd;         // predictive, of each component; zero if not asked for [N] (3)
  int components = 3;         // that are fitted, 2 or 3; the others are 0, of infinite sd [1]
  std::optional<Eigen::Vector3d> trivial = {};  // predicted without a model, see trivial_force();
                                                // empty: not asked for, or nobody can [N] (3)
  bool by_draws = false;  // its force hangs on what is uncertain so that it is a median of draws:
                          // see predictive_moments()
};

/// Angle between the predicted and the measured force, 0 where either is zero [rad].
[[nodiscard]] double direction_error(const PredictedTrial& trial);

/// Errors of predicted forces.
struct ForceError {
  double rms = kNaN;               // root of the mean squared |predicted - measured| [N]; all are
                                   // NaN without trials
  double relative = kNaN;          // rms / root of the mean squared |measured| [1]
  double relative_flexion = kNaN;  // relative error of the first two components [1]
  double direction = kNaN;         // median angle between them where neither is zero [rad]
  std::optional<double> covered;   // share of components within 1.96 predictive sds; empty: no sds
  std::optional<double> log_loss;  // mean over components of -log N(measured; predicted, sd^2), the
                                   // density per newton: it judges errors and sds together [nat]
  int trials = 0;                  // number of trials [1]
};

/// One experiment, predicted.
struct Prediction {
  std::string experiment;
  std::vector<PredictedTrial> trials;
  ForceError error;
  // The subject that predicts, or that the fit started from, was calibrated on this specimen: the
  // error is not that of an unseen specimen.
  bool calibrated_on_specimen = false;
};

/// Muscles that pull in a trial: "FDS" or "EDC+FDS"; "FDS at MC3" where the load cell was there.
[[nodiscard]] std::string describe_loads(const Trial& trial);

/// Returns whether the digit's subject was calibrated on the experiment's specimen.
[[nodiscard]] bool calibrated_on_specimen(const TendonDigit& digit, const Experiment& experiment);

/// Predicted forces beside the measured forces, with their errors; without trials, without these.
/// @param predicted, sd   [N] (3, trials)
/// @param calibrated_on_specimen  of the digit that predicted
[[nodiscard]] Prediction compare_forces(const Experiment& experiment,
                                        const Eigen::Matrix3Xd& predicted,
                                        const Eigen::Matrix3Xd& sd, bool calibrated_on_specimen);

/// @throws InputError if there is no trial, or every measured force is zero.
[[nodiscard]] ForceError force_error(const std::vector<PredictedTrial>& trials);

/// Prediction of experiment `e` of the problem at z, without predictive sds.
[[nodiscard]] Prediction predict_fitted(const FitProblem& problem, const Eigen::VectorXd& z, int e);

/// Index that stands for a specimen that was not fitted, which the population predicts.
inline constexpr int kUnfittedSpecimen = -1;

/// Prediction of any experiment; the population predicts a specimen that was not fitted. It is the
/// mean of the forces over all that is uncertain of the digit, see predictive_moments(), with
///   V_u = du/dz C du/dz' + diag(unseen_variance) + diag(variance of unknown postures),
/// and its predictive variance has the noise beside theirs. What is special to a posture that the
/// fit does not know by name has the mean prior variance of the postures that it knows.
/// @param specimen  index in fitted.specimens(), or kUnfittedSpecimen
/// @throws InputError if the experiment does not fit the digit.
[[nodiscard]] Prediction predict_experiment(const FitProblem& fitted, const Eigen::VectorXd& z,
                                            const ArrowMatrix& C, const Experiment& experiment,
                                            int specimen);

/// The parameters, followed by what every posture of the experiment that they do not name yet has
/// of its own: errors of angles and unexplained forces, with the mean prior of the named postures.
[[nodiscard]] FitParameters add_posture_errors(FitParameters fitted, const Experiment& experiment);

/// A warning that names the first trial whose force is a median of draws, and how many there are.
[[nodiscard]] std::vector<std::string> unsteady_force_warnings(const Prediction& prediction);

/// Index of a fitted specimen, or kUnfittedSpecimen.
[[nodiscard]] int find_specimen(const FitProblem& fitted, const std::string& specimen);

}  // namespace thenar
