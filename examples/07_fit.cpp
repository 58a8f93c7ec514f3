// What do measured fingertip forces say of a finger, and does it predict another hand's forces?
//
// Prints:
//   solved: 202 parameters
//   synek2019_H01: 24 trials, relative error 0.09
//   synek2019_H02: 24 trials, relative error 0.43
#include <cstdio>

#include <thenar/fits.h>

int main() {
  // A normative middle finger, fitted to one specimen; data/fits/finger.toml says what may move.
  thenar::FitRequest request;
  request.sources.subject = "an_chao_middle";
  request.sources.experiments = {"synek2019_H01"};
  const thenar::Fit fit = thenar::fit_digit(request).fit;
  std::printf("%s: %d parameters\n", thenar::name_of(fit.solution.status).c_str(),
              static_cast<int>(fit.solution.z.size()));

  // Relative errors of all forces: of the fitted specimen, and of one that was not measured before.
  const thenar::Prediction own = thenar::predict_fitted(fit.problem, fit.solution.z, 0);
  const thenar::Experiment other =
      thenar::read_experiment(thenar::experiment_file("synek2019_H02", ""));
  const thenar::Prediction unseen = thenar::predict_experiment(
      fit.problem, fit.solution.z, fit.covariance.C, other, thenar::kUnfittedSpecimen);
  std::printf("%s: %d trials, relative error %.2f\n", own.experiment.c_str(), own.error.trials,
              own.error.relative);
  std::printf("%s: %d trials, relative error %.2f\n", unseen.experiment.c_str(),
              unseen.error.trials, unseen.error.relative);
}
