#include "tendons/net/solve_postures.h"

#include <algorithm>

#include "base/error.h"

namespace thenar {

std::vector<NetEquilibrium> solve_postures(NetSolver& solver, const Tree<double>& tree,
                                           const std::vector<Eigen::VectorXd>& postures,
                                           const NetDrive& drive, Eigen::Matrix3Xd start) {
  int coordinates = 0;
  for (const Hinge<double>& hinge : tree) coordinates = std::max(coordinates, hinge.coordinate + 1);
  for (std::size_t k = 0; k < postures.size(); ++k)
    require(postures[k].size() >= coordinates, "posture {} has {} coordinates, the tree {}", k,
            postures[k].size(), coordinates);
  std::vector<NetEquilibrium> rests;
  for (const Eigen::VectorXd& q : postures) {
    rests.push_back(solver.solve(pose_tree(tree, q), drive, start.cols() == 0 ? nullptr : &start));
    if (rests.back().status == NetStatus::kBalanced) start = rests.back().x;
  }
  return rests;
}

}  // namespace thenar
