// How hard can an index finger press with its pad, and which muscles limit it?
//
// Prints:
//   solved: 33.01 N
//   FDP  143.70 of 143.70 N, 0.23 N more for each N of strength
//   FDS   12.56 of 143.70 N, 0.00 N more for each N of strength
//   RI    21.07 of 105.90 N, 0.00 N more for each N of strength
//   UI    20.32 of  84.00 N, 0.00 N more for each N of strength
#include <cstdio>

#include <thenar/hands.h>

int main() {
  // The palmar direction of the tip: its axes are proximal, dorsal and radial.
  thenar::FeasibleForceRequest request;
  request.digit.subject = "an_chao_index";
  request.digit.posture.named = {{"MCP2_FE", 30}, {"PIP2", 45}, {"DIP2", 20}};
  request.digit.posture.unit = thenar::PostureUnit::kTyped;
  request.digit.passive = thenar::PassiveMoments::kOff;  // of tendons alone
  request.frame = thenar::DirectionFrame::kTip;
  request.direction = Eigen::Vector3d(0, -1, 0);
  const thenar::FeasibleForceResult answer = thenar::compute_feasible_force(request);

  // The largest force, and what each muscle that pulls has to do with it.
  const thenar::MaxTipForce& largest = *answer.points.front().largest;
  std::printf("%s: %.2f N\n", thenar::name_of(largest.status).c_str(), largest.component);
  for (Eigen::Index m = 0; m < largest.tension.size(); ++m)
    if (largest.tension[m] > 0.01)
      std::printf("%-4s %6.2f of %6.2f N, %.2f N more for each N of strength\n",
                  answer.muscles[static_cast<std::size_t>(m)].c_str(), largest.tension[m],
                  answer.max_tension[m], std::abs(largest.prices.increase(m)));
}
