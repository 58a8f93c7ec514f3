#pragma once

/// Comparison of a fit with other solvers, left-out data and baselines on the same trials.

#include <string>
#include <vector>

#include "kinematics_fit/cross_validation.h"
#include "kinematics_fit/fit.h"
#include "kinematics_fit/prediction.h"
#include "kinematics_fit/profile.h"
#include "kinematics_fit/trivial_prediction.h"

namespace thenar {

/// One solver on one problem.
struct SolverRun {
  LeastSquaresMethod method;
  Solution solution;
  ForceError error;  // error in sample
};

/// One specimen, fitted alone.
struct SpecimenStudy {
  Fit fit;                        // fit by the first solver
  Prediction in_sample;           // predictions with predictive sds
  CrossValidation postures;       // leave one posture out
  CrossValidation tendons;        // leave one tendon out
  std::vector<SolverRun> runs;    // every solver from the same start
  std::vector<Profile> profiles;  // profiles of the coordinates with the smallest posterior sds
  std::vector<BaselinePrediction> baselines;
};

/// An experiment that was not fitted, by the population and by its baselines.
struct UnseenSpecimen {
  std::string specimen;
  Prediction prediction;
  std::vector<BaselinePrediction> baselines;
};

/// Several specimens, fitted together.
struct PopulationStudy {
  Fit fit;
  std::vector<Prediction> own;         // each specimen by its own parameters
  std::vector<Prediction> as_unseen;   // each by the population alone, in sample
  CrossValidation specimens;           // leave one specimen out
  std::vector<UnseenSpecimen> unseen;  // experiments that were not fitted
};

/// A subject and its name in the report.
struct NamedSubject {
  std::string name;
  SourceText source;
};

/// Inputs of a study: fits, and baselines to compare them with.
struct StudyInputs {
  FitInputs specimen;                   // subject and settings of the single fits; all experiments
  SourceText population_subject;        // subject at which the population starts
  std::vector<SourceText> unseen;       // experiments to predict and never to fit
  std::vector<NamedSubject> baselines;  // used as they are, in the plane of the finger
  std::vector<LeastSquaresMethod> methods;
};

/// Fits and compares one specimen of the inputs alone.
/// @param experiment  one of inputs.specimen.experiments
[[nodiscard]] SpecimenStudy study_specimen(const StudyInputs& inputs, const SourceText& experiment,
                                           const Progress& progress = {});

/// Fits and compares all specimens together.
[[nodiscard]] PopulationStudy study_population(const StudyInputs& inputs,
                                               const Progress& progress = {});

}  // namespace thenar
