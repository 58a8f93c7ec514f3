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

#include <thenar/thenar.h>

int main() {
  // The finger, and muscles that depend on length and velocity, on rigid tendons.
  thenar::DigitRequest request;
  request.subject = "an_chao_index";
  const thenar::DigitCase finger = thenar::build_digit(request, thenar::Hood::kFractions);
  const thenar::TendonDigit& bones = finger.bones();
  const auto muscles = thenar::build_contraction(
      thenar::musculotendons(finger.subject, bones, thenar::Muscle::kRigidTendon),
      thenar::Muscle::kRigidTendon);

  // A tenth of all motor units of FDP, a twentieth of those of EDC, from rest; half a second.
  const Eigen::VectorXd u =
      thenar::in_order({{"FDP", 0.1}, {"EDC", 0.05}}, bones.names.muscles, "");
  thenar::MotionStart start{finger.grid.postures.front(), {}, Eigen::VectorXd::Zero(u.size())};
  const thenar::MotionModel model(*finger.tendons, *muscles);
  const thenar::Trajectory motion =
      thenar::simulate(model, thenar::constant_excitation(u), start, {0.3, 0.05});

  std::printf("time_ms  MCP_deg  PIP_deg  DIP_deg\n");
  for (Eigen::Index i = 0; i < motion.time.size(); ++i) {
    const Eigen::RowVectorXd a = motion.angle.row(i) / thenar::kDegree;
    std::printf("%7.0f %8.1f %8.1f %8.1f\n", 1e3 * motion.time[i], a[0], a[2], a[3]);
  }
}
