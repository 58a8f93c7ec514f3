// How good is a grasp of which only the contacts are known: two soft fingers on a ball?
//
// Prints:
//   force closure: yes
//   epsilon: 0.080
//   hard points: rank 5 of 6, no torque about x: 1.00
#include <cstdio>

#include <thenar/grasps.h>

int main() {
  // Place [m], direction of push, friction [1], torque per normal force [m]; a ball of 60 mm.
  const double mu = 0.5, torsion = 0.004, scale = 0.05;
  const std::vector<thenar::Contact> fingers{{{-0.03, 0, 0}, {1, 0, 0}, mu, torsion},
                                             {{0.03, 0, 0}, {-1, 0, 0}, mu, torsion}};

  // All wrenches that they make with normal forces of 1 N in all, friction cones round.
  const thenar::WrenchSet wrenches = thenar::wrench_set(fingers, {0, 0, 0}, scale);
  thenar::EpsilonOptions options;
  options.gap = 1e-4;
  const thenar::Epsilon quality = thenar::epsilon(wrenches, options);
  std::printf("force closure: %s\n", quality.force_closure ? "yes" : "no");
  std::printf("epsilon: %.3f\n", quality.upper);

  // Hard points of the same place and friction resist no torque about the line between them.
  const std::vector<thenar::Contact> points{{{-0.03, 0, 0}, {1, 0, 0}, mu},
                                            {{0.03, 0, 0}, {-1, 0, 0}, mu}};
  const thenar::Epsilon hard = thenar::epsilon(thenar::wrench_set(points, {0, 0, 0}, scale));
  const Eigen::Vector3d missing = hard.missing_direction.moment_over_length.cwiseAbs();
  std::printf("hard points: rank %d of 6, no torque about x: %.2f\n", hard.rank, missing.x());
}
