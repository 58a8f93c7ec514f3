#include <algorithm>

#include "base/error.h"
#include "tendons/strand_paths.h"
#include "tendons/wrapping/arm_slopes.h"
#include "tendons/wrapping/path_arms.h"

namespace thenar {
namespace {

std::string trouble_of(const PathShape& shape, const std::string& name) {
  switch (shape.status) {
    case PathStatus::kTaut:
      return "";
    case PathStatus::kRidesOnBend:
      return fmt::format("the origin of strand '{}' has come where its carrier bends", name);
    case PathStatus::kPointInside:
      return fmt::format("a point of strand '{}' is {:.3g} mm inside a surface", name,
                         1e3 * shape.depth);
    case PathStatus::kCrossed:
      return fmt::format(
          "a point of strand '{}' went round the far side of its cylinder, where its length jumps",
          name);
    case PathStatus::kStalled:
      return fmt::format("the path of strand '{}' is not taut: {:.3g} rad", name, shape.error);
  }
  return "";
}

TendonStatus status_of(PathStatus status) {
  if (status == PathStatus::kTaut) return TendonStatus::kSound;
  return status == PathStatus::kRidesOnBend ? TendonStatus::kRough : TendonStatus::kAstray;
}

class WrappedStrands : public StrandPaths {
 public:
  WrappedStrands(PathSet set, const TendonDigit& digit)
      : set_(std::move(set)), tree_(digit.model.tree), constant_(digit.model.constant_arms) {
    for (const std::string& name : digit.names.strands) {
      const auto found = std::find_if(set_.paths.begin(), set_.paths.end(),
                                      [&](const WrappedPath& path) { return path.name == name; });
      path_of_.push_back(found == set_.paths.end() ? -1
                                                   : static_cast<int>(found - set_.paths.begin()));
    }
  }

  [[nodiscard]] StrandArms arms(const TreeState<double>& state,
                                const Eigen::VectorXd& /*q*/) const override {
    PathSolver solver(set_);
    const std::vector<PathShape>& shapes = solver.solve(state);
    StrandArms arms{rows_of(state, shapes), "", TendonStatus::kSound};
    for (std::size_t s = 0; s < path_of_.size(); ++s) {
      if (path_of_[s] < 0) continue;
      const auto path = static_cast<std::size_t>(path_of_[s]);
      const TendonStatus status = status_of(shapes[path].status);
      if (status > arms.status) arms.trouble = trouble_of(shapes[path], set_.paths[path].name);
      arms.status = worse(arms.status, status);
    }
    return arms;
  }

  [[nodiscard]] StrandSlopes slopes(const TreeState<double>& state,
                                    const Eigen::VectorXd& q) const override {
    PathSolver solver(set_);
    const std::vector<PathShape>& shapes = solver.solve(state);
    std::vector<ArmSlopes> paths =
        arm_slopes(tree_, state, set_, shapes, static_cast<int>(q.size()));
    StrandSlopes slopes{true, rows_of(state, shapes), lengths_of(shapes, q), {}};
    for (std::size_t s = 0; s < path_of_.size(); ++s) {
      slopes.dR.emplace_back(Eigen::MatrixXd::Zero(q.size(), q.size()));
      if (path_of_[s] < 0) continue;
      const auto path = static_cast<std::size_t>(path_of_[s]);
      slopes.exist = slopes.exist && paths[path].exist;
      slopes.dR.back() = std::move(paths[path].dR);
    }
    return slopes;
  }

  [[nodiscard]] Eigen::VectorXd lengths(const TreeState<double>& state,
                                        const Eigen::VectorXd& q) const override {
    PathSolver solver(set_);
    return lengths_of(solver.solve(state), q);
  }

 private:
  /// Of all strands (strands) [m].
  [[nodiscard]] Eigen::VectorXd lengths_of(const std::vector<PathShape>& shapes,
                                           const Eigen::VectorXd& q) const {
    Eigen::VectorXd length = -constant_ * q;
    for (std::size_t s = 0; s < path_of_.size(); ++s)
      if (path_of_[s] >= 0)
        length[static_cast<Eigen::Index>(s)] = shapes[static_cast<std::size_t>(path_of_[s])].length;
    return length;
  }

  /// Arms of all strands (strands, coordinates) [m/rad].
  [[nodiscard]] Eigen::MatrixXd rows_of(const TreeState<double>& state,
                                        const std::vector<PathShape>& shapes) const {
    Eigen::MatrixXd of_path(shapes.size(), constant_.cols());
    path_arms(tree_, state, set_, shapes, of_path);
    Eigen::MatrixXd R = constant_;
    for (std::size_t s = 0; s < path_of_.size(); ++s)
      if (path_of_[s] >= 0) R.row(static_cast<Eigen::Index>(s)) = of_path.row(path_of_[s]);
    return R;
  }

  PathSet set_;
  Tree<double> tree_;
  Eigen::MatrixXd constant_;  // (strands, coordinates) [m/rad]
  std::vector<int> path_of_;  // of each strand; -1: constant arms
};

}  // namespace

std::unique_ptr<StrandPaths> build_wrapped_paths(const Subject& subject, const TendonDigit& digit) {
  std::vector<std::string> with_path;
  for (std::size_t s = 0; s < digit.names.strands.size(); ++s)
    if (!digit.model.paths[s].empty()) with_path.push_back(digit.names.strands[s]);
  return std::make_unique<WrappedStrands>(build_paths(subject, digit.skeleton, with_path), digit);
}

}  // namespace thenar
