#pragma once

/// Studies of thumbs: information about a thumb's axes in forces, by a simulated experiment with
/// known truth; types of thumbs that result from the spread of axes between people; recovery of a
/// thumb from forces and muscle activity, and the information that published measurements add.

#include <optional>
#include <string>

#include "base/progress.h"
#include "solvers/status.h"
#include "studies/thumb/measured_lessons.h"
#include "studies/thumb/thumb_calibration.h"
#include "studies/thumb/thumb_recovery.h"
#include "studies/thumb/thumb_study.h"
#include "studies/thumb/thumb_types.h"

namespace thenar {

struct ThumbStudyRequest {
  std::string data;     // folder with fits/, studies/, subjects/; empty: the usual ones
  bool quick = false;   // arms known, one skewness: seconds instead of minutes
  long draws = 0;       // draws of each of 4 chains, and of warm-up; 0: as the study has them [1]
  int simulations = 0;  // simulated thumbs for the calibration of the sampler; 0: none [1]
  unsigned seed = 1;    // seed of noise and chains
};

struct ThumbStudyResult {
  ThumbStudy study;
  std::optional<ThumbCalibration> calibration;  // absent unless requested
  unsigned seed = 1;
  Outcome outcome;  // stopped: the parts finished by then
};

/// Fits orthogonal and skewed thumbs to forces of a skewed one. The same request gives bitwise
/// equal results.
/// @throws InputError if no data folder has fits/.
[[nodiscard]] ThumbStudyResult compute_thumb_study(const ThumbStudyRequest& request,
                                                   const Progress& progress = {});

struct ThumbTypesRequest {
  std::string data;   // folder with studies/ and subjects/; empty: the usual ones
  int draws = 3550;   // [1]
  unsigned seed = 1;  // seed of the draws
};

struct ThumbTypesResult {
  ThumbTypes types;
  unsigned seed = 1;
};

/// Computes the types of thumbs that result from the spread of joint axes, and the number of each.
/// The same request gives bitwise equal results. @throws InputError if no data folder has studies/,
/// or draws is not positive.
[[nodiscard]] ThumbTypesResult compute_thumb_types(const ThumbTypesRequest& request,
                                                   const Progress& progress = {});

struct ThumbRecoveryRequest {
  std::string data;   // folder with fits/, studies/, experiments/, subjects/; empty: the usual
                      // ones
  long draws = 0;     // draws of each of 4 chains, and of warm-up; 0: as the study has them [1]
  long weighed = 0;   // draws of the prior that measurements weight; 0: as the study has them [1]
  unsigned seed = 1;  // seed of noise and chains
};

struct ThumbRecoveryResult {
  ThumbRecovery recovery;   // recovery from simulated data
  MeasuredLessons lessons;  // information in published measurements
  Outcome outcome;          // stopped: the parts finished by then
};

/// Recovers a thumb from simulated forces and muscle activity, by least squares and by chains, and
/// adds published measurements of thumbs. Takes some 20 s. The same request gives bitwise equal
/// results.
/// @throws InputError if no data folder has fits/, DataError if a file is missing or wrong.
[[nodiscard]] ThumbRecoveryResult compute_thumb_recovery(const ThumbRecoveryRequest& request,
                                                         const Progress& progress = {});

/// Returns the number of fits whose chains have not converged.
[[nodiscard]] std::size_t unconverged_fits(const ThumbStudy& study);

}  // namespace thenar
