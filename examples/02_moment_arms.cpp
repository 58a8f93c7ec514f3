// About which joints does each muscle of an index finger turn, and with which moment arm [mm]?
//
// Prints:
//          MCP2_FE MCP2_AA    PIP2    DIP2
//   EDC      -8.03   -0.54   -2.83   -0.96
//   EIP      -8.03   -0.54   -2.83   -0.96
//   FDP      11.23    0.12    9.71    4.72
//   FDS      12.30   -1.97    8.28    0.00
//   RI        6.01    7.95   -1.51   -0.48
//   LU        8.45    7.48   -3.02   -0.96
//   UI        6.26   -7.87   -2.64   -0.96
#include <cstdio>

#include <thenar/hands.h>

int main() {
  // The finger with the joints bent as in 01_pose.cpp, in degrees.
  thenar::DigitRequest request;
  request.subject = "an_chao_index";
  request.posture.named = {{"MCP2_FE", 30}, {"PIP2", 45}, {"DIP2", 20}};
  request.posture.unit = thenar::PostureUnit::kTyped;
  const thenar::MomentArmResult answer = thenar::compute_moment_arms(request);
  const thenar::MomentArmPoint& at = answer.points.front();

  // Rows are muscles, columns are joints; flexion and radial deviation are positive.
  std::printf("      ");
  for (const std::string& joint : answer.rows) std::printf("%8s", joint.c_str());
  for (Eigen::Index m = 0; m < at.arms.rows(); ++m) {
    std::printf("\n%-6s", answer.muscles[static_cast<std::size_t>(m)].c_str());
    for (const double arm : at.arms.row(m)) std::printf("%8.2f", 1e3 * arm);
  }
  std::printf("\n");
}
