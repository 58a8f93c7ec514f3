#include "bench/net_sweep.h"

#include <limits>

#include "base/error.h"

namespace thenar::bench {

std::vector<WarmTask> warm_tasks(const SampleNet& sample, int count, double step) {
  NetSolver solver(sample.net, {1e-11, 200});
  Eigen::VectorXd q = sample.q;
  Eigen::Matrix3Xd start = solver.solve(pose_tree(sample.tree, q), sample.drive).x;
  std::vector<WarmTask> tasks;
  for (int i = 0; i < count; ++i) {
    q[0] += step;
    const TreeState<double> state = pose_tree(sample.tree, q);
    NetEquilibrium rest = solver.solve(state, sample.drive, &start);
    require(rest.status == NetStatus::kBalanced, "net '{}' does not balance at {} rad: {} N left",
            sample.net.name, q[0], rest.residual);
    tasks.push_back({state, PosedNet(sample.net, state, sample.drive), start, rest});
    start = tasks.back().rest.x;
  }
  return tasks;
}

double tension_error(const WarmTask& task, const RivalRest& rest) {
  if (!rest.balanced) return std::numeric_limits<double>::infinity();
  return (task.posed.tensions(rest.x) - task.rest.tension).cwiseAbs().maxCoeff();
}

}  // namespace thenar::bench
