#pragma once

/// All that one asks of a fit: every solver, what is left out, and the baselines on the same rows.

#include <string>
#include <vector>

#include "kinematics_fit/cross_validation.h"
#include "kinematics_fit/fit.h"
#include "kinematics_fit/prediction.h"
#include "kinematics_fit/profile.h"

namespace thenar {

/// One solver on one problem.
struct SolverRun {
  LeastSquaresMethod method;
  Solution solution;
  ForceError error;  // in sample
};

/// Predictions of the same experiment by something else.
struct BaselinePrediction {
  std::string name;
  std::string note;  // what it has seen of the data
  Prediction prediction;
};

/// One specimen, fitted alone.
struct SpecimenStudy {
  Fit fit;                        // by the first solver
  Prediction in_sample;           // with predictive sds
  CrossValidation postures;       // leave one posture out
  CrossValidation tendons;        // leave one tendon out
  std::vector<SolverRun> runs;    // every solver from the same start
  std::vector<Profile> profiles;  // of the coordinates that the data taught most about
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

/// A subject by the name it goes by in the report.
struct NamedSubject {
  std::string name;
  SourceText source;
};

/// What a study fits, and what it compares with.
struct StudyInputs {
  FitInputs specimen;                   // subject and settings of the single fits; all experiments
  SourceText population_subject;        // where the population starts
  std::vector<SourceText> unseen;       // experiments to predict and never to fit
  std::vector<NamedSubject> baselines;  // used as they are, in the plane of the finger
  std::vector<LeastSquaresMethod> methods;
};

/// Every specimen of the inputs, alone.
[[nodiscard]] std::vector<SpecimenStudy> study_specimens(const StudyInputs& inputs,
                                                         const Progress& progress = {});

/// All specimens together.
[[nodiscard]] PopulationStudy study_population(const StudyInputs& inputs,
                                               const Progress& progress = {});

/// A subject as it is, without a fit: no friction, in-plane hold, all shifts zero.
[[nodiscard]] Prediction predict_as_published(const SourceText& subject,
                                              const Experiment& experiment);

/// Every trial predicted by the mean of the trials with the same loads in other postures: what
/// one gets without a model. Trials without such others are left out.
[[nodiscard]] Prediction mean_of_other_postures(const Experiment& experiment);

}  // namespace thenar
