#pragma once

/// Problem that a fit solves and a posterior samples: measured forces, a digit and its free
/// parameters.

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

/// The data and the unknowns of a fit; it only holds them. The unknowns are z: parameters as
/// displacements from their prior means, in prior sds. fit_residuals.h has the residuals,
/// specimen_prior.h the displacements that z stands for.
class FitProblem {
 public:
  /// @param robust_scale    c of fit_residuals(), in noise sds; 0: plain squares [1]
  /// @param axis_distances  bounds on distances between joint axes, for every specimen: see
  ///                        axis_constraints(); kept by constrained solvers only
  /// @param scaling         size of the digit of each specimen, see scale_to_outside()
  /// @throws InputError if an experiment does not fit the digit, a posture is singular, nothing is
  /// free, or an axis distance names a joint the digit has not; if a size is asked for that cannot
  /// be, or two experiments state different sizes of one specimen.
  FitProblem(TendonDigit digit, FitParameters parameters, std::vector<Experiment> experiments,
             double robust_scale = 0, std::vector<AxisDistance> axis_distances = {},
             Scaling scaling = Scaling::kSubject);

  /// Layout, bounds and names of z, and their number.
  [[nodiscard]] const FitCoordinates& coordinates() const { return coordinates_; }
  [[nodiscard]] int size() const { return coordinates_.size(); }

  /// The digit in the subject's size, and in that of a specimen (its index, or one below 0 for the
  /// population).
  [[nodiscard]] const TendonDigit& digit() const { return digit_; }
  [[nodiscard]] const TendonDigit& digit_of(int specimen) const;
  /// The digit in the size of the specimen of any experiment, of this fit or not.
  /// @throws InputError if the size is to be scaled and nobody has stated it.
  [[nodiscard]] TendonDigit sized_digit(const Experiment& experiment) const;
  [[nodiscard]] Scaling scaling() const { return scaling_; }
  [[nodiscard]] const FitParameters& parameters() const { return coordinates_.parameters(); }
  [[nodiscard]] const std::vector<std::string>& specimens() const {
    return coordinates_.specimens();
  }

  [[nodiscard]] const std::vector<Experiment>& experiments() const { return experiments_; }
  [[nodiscard]] const std::vector<ExperimentPlan>& plans() const { return plans_; }
  /// Index in specimens().
  [[nodiscard]] int specimen_of(int experiment) const { return specimen_of_.at(experiment); }
  /// compile_forces() of an experiment, which may be null.
  [[nodiscard]] const ForceKernel* kernel_of(int experiment) const {
    return kernels_.at(static_cast<std::size_t>(experiment)).get();
  }
  /// Activation rows of an experiment as unit pulls, which are all trials of its plan; no tasks
  /// where there are none, or a net makes forces that are not linear in tensions.
  [[nodiscard]] const ActivationPlan& activations_of(int experiment) const {
    return activations_.at(static_cast<std::size_t>(experiment));
  }
  [[nodiscard]] const ForceKernel* activation_kernel_of(int experiment) const {
    return activation_kernels_.at(static_cast<std::size_t>(experiment)).get();
  }
  [[nodiscard]] double robust_scale() const { return robust_scale_; }  // [1]

  /// Bounds on distances between axes, as given and by hinges of the digit.
  [[nodiscard]] const std::vector<AxisDistance>& axis_distances() const { return axis_distances_; }
  [[nodiscard]] const std::vector<AxisPair>& axis_pairs() const { return axis_pairs_; }

  /// Warnings to read before the fit is trusted: experiment_warnings(), posture_name_warnings(),
  /// doubled_trial_warnings(), activations that least squares leaves aside,
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
  std::vector<ExperimentPlan> plans_;  // of each experiment
  std::vector<int> specimen_of_;       // of each experiment
  std::vector<TendonDigit> digits_;    // of each specimen in its size; none if not scaled
  std::vector<std::shared_ptr<const ForceKernel>>
      kernels_;  // of each experiment; constant, so that copies of the problem share them
  std::vector<ActivationPlan> activations_;                             // of each experiment
  std::vector<std::shared_ptr<const ForceKernel>> activation_kernels_;  // null without tasks
  double robust_scale_;                                                 // [1]
  std::vector<AxisDistance> axis_distances_;
  std::vector<AxisPair> axis_pairs_;
};

/// The problem with a part of its trials; experiments without any are dropped, and so are rows of
/// activations in a posture that has lost all its trials.
/// @param keep  keep(experiment, trial)
[[nodiscard]] FitProblem subset(const FitProblem& problem,
                                const std::function<bool(const Experiment&, const Trial&)>& keep);

}  // namespace thenar
