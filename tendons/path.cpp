#include "tendons/path.h"

#include <Eigen/Geometry>

namespace thenar {
namespace {

using Eigen::Vector3d;

/// Straight run of a tendon between two links, world frame.
struct LinkRun {
  int link_a, link_b;
  Vector3d a, b;  // [m] (3)
};

/// Motion of a run's end by one hinge.
struct RunMotion {
  int hinge;
  bool on_b;
  Vector3d r;
};

/// Collects the motions by all hinges between the links of a run, climbing to their common
/// ancestor.
void find_motions(const Tree<double>& tree, const TreeState<double>& state, const LinkRun& run,
                  std::vector<RunMotion>& moves) {
  moves.clear();
  for_each_hinge_between(tree, run.link_a, run.link_b, [&](int i, bool on_b) {
    const Vector3d r = state[i].axis.cross((on_b ? run.b : run.a) - state[i].point);
    moves.push_back({i, on_b, on_b ? r : Vector3d(-r)});
  });
}

}  // namespace

Eigen::MatrixXd arm_derivatives(const Tree<double>& tree, const TreeState<double>& state,
                                const TendonPath<double>& path, int coordinates) {
  Eigen::MatrixXd dR = Eigen::MatrixXd::Zero(coordinates, coordinates);
  std::vector<RunMotion> moves;
  for (std::size_t k = 1; k < path.size(); ++k) {
    if (path[k - 1].link == path[k].link) continue;
    // Compute the direction of the run, and the motion of its ends by each hinge.
    const LinkRun run{path[k - 1].link, path[k].link, moved(state, path[k - 1].link, path[k - 1].p),
                      moved(state, path[k].link, path[k].p)};
    const double length = (run.b - run.a).norm();
    const Vector3d u = (run.b - run.a) / length;
    find_motions(tree, state, run, moves);
    // Add the second derivative by two hinges: across the run, and by rotation of the outer motion.
    for (const RunMotion& x : moves)
      for (const RunMotion& y : moves) {
        const RunMotion &inner = x.hinge < y.hinge ? x : y, &outer = x.hinge < y.hinge ? y : x;
        double bend = (x.r.dot(y.r) - u.dot(x.r) * u.dot(y.r)) / length;
        if (x.on_b == y.on_b) bend += u.dot(state[inner.hinge].axis.cross(outer.r));
        const auto &one = tree[x.hinge], &other = tree[y.hinge];
        dR(one.coordinate, other.coordinate) -= one.ratio * other.ratio * bend;
      }
  }
  return dR;
}

}  // namespace thenar
