// How hard can an index finger press with its pad, and which muscles limit it?
//
// Prints:
//   solved: 33.01 N
//   FDP  143.70 of 143.70 N
//   FDS   12.56 of 143.70 N
//   RI    21.07 of 105.90 N
//   UI    20.32 of  84.00 N
//   all forces: 28 corners, 29553 N^3
#include <cstdio>

#include <thenar/thenar.h>

int main() {
  thenar::DigitRequest request;
  request.subject = "an_chao_index";
  request.posture.named = {{"MCP2_FE", 30}, {"PIP2", 45}, {"DIP2", 20}};
  request.posture.unit = thenar::PostureUnit::kTyped;
  const thenar::DigitCase finger = thenar::build_digit(request, thenar::Hood::kFractions);
  const thenar::DigitAtPosture now = thenar::digit_at(finger, finger.grid.postures.front());

  // The largest force in the palmar direction of the tip, all other components zero.
  const Eigen::Vector3d palmar = -now.tip_axes->col(1);
  const thenar::MaxTipForce largest = thenar::max_tip_force(now.statics, palmar);
  std::printf("%s: %.2f N\n", thenar::name_of(largest.status).c_str(), largest.magnitude);
  for (std::size_t m = 0; m < now.statics.muscles.size(); ++m)
    if (const double t = largest.tension[static_cast<Eigen::Index>(m)]; t > 0.01)
      std::printf("%-4s %6.2f of %6.2f N\n", now.statics.muscles[m].c_str(), t,
                  now.statics.max_tension[static_cast<Eigen::Index>(m)]);
  // All forces that the tip can make: a polytope.
  const thenar::FeasibleForceSet all = thenar::feasible_force_set(now.statics);
  std::printf("all forces: %d corners, %.0f N^3\n", static_cast<int>(all.vertices.rows()),
              all.volume);
}
