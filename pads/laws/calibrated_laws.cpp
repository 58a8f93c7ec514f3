#include "pads/laws/calibrated_laws.h"

#include <cmath>

#include "base/error.h"

namespace thenar {

void check_laws(const CalibratedLaws& laws) {
  // Their builders refuse what makes no sense.
  (void)PowerLaw(laws.power, laws.relaxation);
  (void)SoftFinger(laws.soft_finger, laws.relaxation);
  (void)ElasticFoundation(laws.foundation, laws.relaxation);
  for (const LawError& law :
       {laws.power_error, laws.soft_finger_error, laws.foundation_error, laws.bed_error})
    for (const RelativeError& error : {law.force, law.area, law.radius, law.torsion})
      require(error.rms >= 0 && error.worst >= 0 && std::isfinite(error.rms + error.worst),
              "errors of laws must be finite and >= 0, got {} and {}", error.rms, error.worst);
}

}  // namespace thenar
