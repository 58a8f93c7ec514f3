// Reads the subject named on the command line and prints where its first fingertip
// is [mm].

#include <cstdio>

#include <thenar/thenar.h>

int main(int argc, char** argv) {
  if (argc != 2 || thenar::name_of(thenar::LeastSquaresMethod::kCeres) != "ceres") return 2;
  const thenar::Skeleton skeleton = thenar::build_skeleton(thenar::read_subject(argv[1]));
  const thenar::SkeletonTip& tip = skeleton.tips.front();
  const Eigen::VectorXd q = thenar::posture(skeleton, {});
  const Eigen::Vector3d p = thenar::moved(thenar::pose_tree(skeleton.tree, q), tip.link, tip.p);
  std::printf("%s %.3f %.3f %.3f\n", tip.digit.c_str(), 1000 * p.x(), 1000 * p.y(), 1000 * p.z());
  return (p - tip.p).norm() < 1e-12 ? 0 : 1;
}
