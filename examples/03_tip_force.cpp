// With which force does the tip of an index finger press when its deep flexor pulls with 10 N?
//
// Prints:
//   proximal 0.74 N, palmar 2.41 N, radial 0.02 N
//   2.52 N in all, condition 4.38
#include <cstdio>

#include <thenar/thenar.h>

int main() {
  // A subject by its name, posed in degrees; a file of your own is given by its path.
  thenar::DigitRequest request;
  request.subject = "an_chao_index";
  request.posture.named = {{"MCP2_FE", 30}, {"PIP2", 45}, {"DIP2", 20}};
  request.posture.unit = thenar::PostureUnit::kTyped;
  const thenar::DigitCase finger = thenar::build_digit(request, thenar::Hood::kFractions);
  const thenar::DigitAtPosture now = thenar::digit_at(finger, finger.grid.postures.front());

  // The force of the tip on the world, along its own directions.
  const Eigen::VectorXd tension = thenar::tensions(finger, {{"FDP", 10}});
  const thenar::TipForce answer = thenar::tip_force(now.statics, tension);
  const Eigen::Vector3d force = now.tip_axes->transpose() * answer.f_W;
  std::printf("proximal %.2f N, palmar %.2f N, radial %.2f N\n", force[0], -force[1], force[2]);
  std::printf("%.2f N in all, condition %.2f\n", force.norm(), answer.condition);
}
