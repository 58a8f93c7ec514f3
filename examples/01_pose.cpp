// Where are the joints and the tip of an index finger when it is bent?
//
// Prints:
//   joint      x_mm    y_mm
//   MCP2_FE   87.91    0.00
//   MCP2_AA   87.91    0.00
//   PIP2      50.18  -21.78
//   DIP2      43.79  -45.61
//   tip       45.51  -65.21
#include <cstdio>

#include <thenar/hands.h>

int main() {
  // The finger straight: x points to the wrist, y to the back of the hand, z to the thumb.
  const thenar::SourceText file = thenar::subject_source("an_chao_index", "");
  const thenar::Skeleton finger =
      thenar::build_skeleton(thenar::parse_subject(file.text, file.path));

  // Joints that are not named stay at 0.
  const double deg = thenar::kDegree;
  const Eigen::VectorXd q =
      thenar::posture(finger, {{"MCP2_FE", 30 * deg}, {"PIP2", 45 * deg}, {"DIP2", 20 * deg}});
  const thenar::TreeState<double> links = thenar::pose_tree(finger.tree, q);

  // A point of every axis, and the tip, where they are now.
  std::printf("joint      x_mm    y_mm\n");
  for (std::size_t i = 0; i < links.size(); ++i)
    std::printf("%-8s %6.2f %7.2f\n", finger.hinge_names[i].c_str(), 1e3 * links[i].point.x(),
                1e3 * links[i].point.y());
  const thenar::SkeletonTip& tip = finger.tips.front();
  const Eigen::Vector3d p = thenar::moved(links, tip.link, tip.p);
  std::printf("%-8s %6.2f %7.2f\n", "tip", 1e3 * p.x(), 1e3 * p.y());
}
