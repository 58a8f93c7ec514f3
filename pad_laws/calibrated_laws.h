#pragma once

/// Calibrated laws of one pad with their errors.

#include <cmath>
#include <string>
#include <vector>

#include "base/error.h"
#include "pad_laws/elastic_foundation.h"
#include "pad_laws/point_laws.h"

namespace thenar {

/// Relative errors over presses that had no part in a fit.
struct RelativeError {
  double rms = 0;    // root mean square [1]
  double worst = 0;  // largest magnitude [1]
};

/// Errors of a law at given depths.
struct LawError {
  RelativeError force;    // normal force
  RelativeError area;     // area of the patch
  RelativeError radius;   // longer semi-axis of the patch
  RelativeError torsion;  // torsion per normal force and friction
  RelativeError shear;    // tangential stiffness, G area / h, while the whole patch sticks
};

/// Presses to which laws were fitted and against which they were checked.
struct LawEvidence {
  int fitted = 0, checked = 0;  // number of presses
  double depth = 0;             // largest depth of a fitted press [m]
  double force = 0;             // largest force of a fitted press [N]
  double force_error = 0;       // largest error that the finite elements estimate [1]
};

/// Laws of one pad.
struct CalibratedLaws {
  std::string name;        // name of the pad
  std::string pad_digest;  // digest of the pad's numbers, pad_digest(); empty: unknown
  PowerLawConstants power;
  SoftFingerConstants soft_finger;
  FoundationConstants foundation;
  std::vector<ExponentialTerm> relaxation;  // relaxation of all laws
  LawError power_error, soft_finger_error;
  LawError foundation_error;  // error of ElasticFoundation, from curvatures
  LawError bed_error;         // error of FoundationBed, from the pad's shape
  LawEvidence evidence;
};

/// Checks calibrated laws.
/// @throws InputError if constants are invalid for their laws, or errors are negative or not
///         finite.
inline void check_laws(const CalibratedLaws& laws) {
  // The laws' own constructors check their constants.
  (void)PowerLaw(laws.power, laws.relaxation);
  (void)SoftFinger(laws.soft_finger, laws.relaxation);
  (void)ElasticFoundation(laws.foundation, laws.relaxation);
  for (const LawError& law :
       {laws.power_error, laws.soft_finger_error, laws.foundation_error, laws.bed_error})
    for (const RelativeError& error : {law.force, law.area, law.radius, law.torsion, law.shear})
      require(error.rms >= 0 && error.worst >= 0 && std::isfinite(error.rms + error.worst),
              "errors of laws must be finite and >= 0, got {} and {}", error.rms, error.worst);
}

}  // namespace thenar
