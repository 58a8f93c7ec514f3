#pragma once

/// Problem that is solved by a fit and sampled by a posterior: measured forces, a digit and its
/// free parameters.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "data/io/experiment.h"
#include "kinematics_fit/fit_coordinates.h"
#include "kinematics_fit/model/activation_plan.h"
#include "kinematics_fit/outside_scale.h"

namespace thenar {

class ForceKernel;

/// Data and unknowns of a fit. The unknowns z are displacements of the parameters from their prior
/// means, in prior sds. Residuals are in fit_residuals.h, and the map from z to displacements in
/// specimen_prior.h.
class FitProblem {
 public:
  /// @param robust_scale    c of fit_residuals(), in noise sds; 0: plain squares [1]
  /// @param axis_distances  bounds on distances between joint axes, for every specimen: see
  ///                        axis_constraints(); enforced by constrained solvers only
  /// @param scaling         size of the digit of each specimen, see scale_to_outside()
  /// @throws InputError if an experiment does not fit the digit, a posture is singular, nothing is
  /// free, an axis distance names an unknown joint, a size cannot be computed, or two experiments
  /// state different sizes of one specimen.
  FitProblem(TendonDigit digit, FitParameters parameters, std::vector<Experiment> experiments,
             double robust_scale = 0, std::vector<AxisDistance> axis_distances = {},
             Scaling scaling = Scaling::kSubject);

  /// Return the layout of z, and its number of entries.
  [[nodiscard]] const FitCoordinates& coordinates() const { return coordinates_; }
  [[nodiscard]] int size() const { return coordinates_.size(); }

  /// Return the digit in the subject's size, and in that of a specimen (its index, or below 0 for
  /// the population).
  [[nodiscard]] const TendonDigit& digit() const { return digit_; }
  [[nodiscard]] const TendonDigit& digit_of(int specimen) const;
  /// Returns the digit in the size of the specimen of any experiment, of this fit or not.
  /// @throws InputError if the digit must be scaled and the size is not stated.
  [[nodiscard]] TendonDigit sized_digit(const Experiment& experiment) const;
  [[nodiscard]] Scaling scaling() const { return scaling_; }
  [[nodiscard]] const FitParameters& parameters() const { return coordinates_.parameters(); }
  [[nodiscard]] const std::vector<std::string>& specimens() const {
    return coordinates_.specimens();
  }

  [[nodiscard]] const std::vector<Experiment>& experiments() const { return experiments_; }
  [[nodiscard]] const std::vector<ExperimentPlan>& plans() const { return plans_; }
  /// Returns the index of the experiment's specimen in specimens().
  [[nodiscard]] int specimen_of(int experiment) const { return specimen_of_.at(experiment); }
  /// Returns compile_forces() of an experiment; may be null.
  [[nodiscard]] const ForceKernel* kernel_of(int experiment) const {
    return kernels_.at(static_cast<std::size_t>(experiment)).get();
  }
  /// Returns the activation rows of an experiment as unit pulls, which are the trials of its plan;
  /// no tasks if there are none, or if the digit has a net, whose forces are not linear in the
  /// tensions.
  [[nodiscard]] const ActivationPlan& activations_of(int experiment) const {
    return activations_.at(static_cast<std::size_t>(experiment));
  }
  /// Returns the compiled forces of the activation rows; null without tasks.
  [[nodiscard]] const ForceKernel* activation_kernel_of(int experiment) const {
    return activation_kernels_.at(static_cast<std::size_t>(experiment)).get();
  }
  [[nodiscard]] double robust_scale() const { return robust_scale_; }  // [1]

  /// Return the bounds on distances between axes, as given and as pairs of hinges of the digit.
  [[nodiscard]] const std::vector<AxisDistance>& axis_distances() const { return axis_distances_; }
  [[nodiscard]] const std::vector<AxisPair>& axis_pairs() const { return axis_pairs_; }

  /// Returns warnings about the data: experiment_warnings(), posture_name_warnings(),
  /// doubled_trial_warnings(), activations that least squares does not use,
  /// fixed_geometry_warnings().
  [[nodiscard]] std::vector<std::string> warnings() const;

 private:
  void find_axes();
  void size_specimens();
  void add_activations(const TendonDigit& sized, std::size_t e);

  TendonDigit digit_;
  std::vector<Experiment> experiments_;
  Scaling scaling_;
  FitCoordinates coordinates_;
  std::vector<ExperimentPlan> plans_;  // plan of each experiment
  std::vector<int> specimen_of_;       // specimen of each experiment
  std::vector<TendonDigit> digits_;    // scaled digit of each specimen; empty if not scaled
  // Compiled forces of each experiment; immutable, hence shared by copies of the problem.
  std::vector<std::shared_ptr<const ForceKernel>> kernels_;
  std::vector<ActivationPlan> activations_;  // activation rows of each experiment
  std::vector<std::shared_ptr<const ForceKernel>>
      activation_kernels_;  // one per experiment, null without tasks
  double robust_scale_;     // [1]
  std::vector<AxisDistance> axis_distances_;
  std::vector<AxisPair> axis_pairs_;
};

/// Returns the problem with a part of its trials. Experiments without trials are dropped, and so
/// are activation rows of postures that have lost all trials.
/// @param keep  selects trials: keep(experiment, trial)
[[nodiscard]] FitProblem subset(const FitProblem& problem,
                                const std::function<bool(const Experiment&, const Trial&)>& keep);

}  // namespace thenar
