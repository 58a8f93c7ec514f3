// How does an index finger move when its deep flexor is excited?
//
// Prints:
//   time_ms  MCP_deg  PIP_deg  DIP_deg
//         0      0.0      0.0      0.0
//        50     11.1     17.9     19.7
//       100     23.1     39.7     38.7
//       150     30.8     62.4     54.8
//       200     34.1     84.3     66.0
//       250     33.9     97.7     73.1
//       300     34.5     97.7     81.9
#include <cstdio>

#include <thenar/tendons.h>

int main() {
  // A tenth of the motor units of FDP and a twentieth of those of EDC, from rest, for 0.3 s;
  // muscles depend on length and velocity, tendons are rigid.
  thenar::DigitMotionRequest request;
  request.digit.subject = "an_chao_index";
  request.digit.passive = thenar::PassiveMoments::kOff;  // as far as its stops
  request.excitation = {{"FDP", 0.1}, {"EDC", 0.05}};
  request.seconds = 0.3;
  request.sample = 0.05;
  const thenar::DigitMotionResult answer = thenar::simulate_digit(request);
  const thenar::Trajectory& motion = answer.trajectory;

  std::printf("time_ms  MCP_deg  PIP_deg  DIP_deg\n");
  for (Eigen::Index i = 0; i < motion.time.size(); ++i) {
    const Eigen::RowVectorXd a = motion.angle.row(i) / thenar::kDegree;
    std::printf("%7.0f %8.1f %8.1f %8.1f\n", 1e3 * motion.time[i], a[0], a[2], a[3]);
  }
}
