// With which force does the tip of an index finger press when its deep flexor pulls with 10 N?
//
// Prints:
//   proximal 0.74 N, palmar 2.41 N, radial 0.02 N
#include <cstdio>

#include <thenar/hands.h>

int main() {
  // A subject by its name, or the path of your own file; angles in degrees.
  thenar::TipForceRequest request;
  request.digit.subject = "an_chao_index";
  request.digit.posture.named = {{"MCP2_FE", 30}, {"PIP2", 45}, {"DIP2", 20}};
  request.digit.posture.unit = thenar::PostureUnit::kTyped;
  request.tension = {{"FDP", 10}};
  // Force of the tendons alone. By default the passive joint moments are included.
  request.digit.passive = thenar::PassiveMoments::kOff;

  // The force of the tip on the world, along its own directions.
  const thenar::TipForcePoint at = thenar::compute_tip_force(request).points.front();
  const Eigen::Vector3d force = at.tip_axes->transpose() * at.force;
  std::printf("proximal %.2f N, palmar %.2f N, radial %.2f N\n", force[0], -force[1], force[2]);
}
