#include "tendons/strand_paths.h"

#include <algorithm>

#include "base/error.h"
#include "base/lists.h"
#include "tendons/wrapping/arm_slopes.h"
#include "tendons/wrapping/fitted_path.h"
#include "tendons/wrapping/path_arms.h"

namespace thenar {
namespace {

/// Describes the problem of a path; empty: none.
std::string warning_of(const PathShape& shape, const std::string& name) {
  switch (shape.status) {
    case PathStatus::kTaut:
      return "";
    case PathStatus::kRidesOnBend:
      return fmt::format("the origin of strand '{}' has come where its carrier bends", name);
    case PathStatus::kPointInside:
      return fmt::format("a point of strand '{}' is {:.3g} mm inside a surface", name,
                         1e3 * shape.depth);
    case PathStatus::kFarSideWrap:
      return fmt::format(
          "a point of strand '{}' went round the far side of its cylinder, where its length jumps",
          name);
    case PathStatus::kStalled:
      return fmt::format("the path of strand '{}' is not taut: {:.3g} rad", name, shape.error);
  }
  return "";
}

/// Converts the status of a path.
TendonStatus status_of(PathStatus status) {
  if (status == PathStatus::kTaut) return TendonStatus::kValid;
  return status == PathStatus::kRidesOnBend ? TendonStatus::kApproximate
                                            : TendonStatus::kInvalidPath;
}

/// Strands as geodesics over surfaces.
class WrappedStrands : public StrandPaths {
 public:
  WrappedStrands(PathSet set, const TendonDigit& digit)
      : set_(std::move(set)), tree_(digit.model.tree), constant_(digit.model.constant_arms) {
    // Find the path of each strand; those without one keep constant arms.
    for (const std::string& name : digit.names.strands)
      path_of_.push_back(place_named(set_.paths, name));
    // Find the strand of each path; those that only carry another have none.
    strand_of_.assign(set_.paths.size(), -1);
    for (std::size_t s = 0; s < path_of_.size(); ++s)
      if (path_of_[s] >= 0) strand_of_[path_of_[s]] = static_cast<int>(s);
  }

  [[nodiscard]] StrandArms arms(const TreeState<double>& state,
                                const Eigen::VectorXd& q) const override {
    StrandArms arms;
    set_arms(state, q, make_workspace().get(), arms);
    return arms;
  }

  [[nodiscard]] std::unique_ptr<StrandWorkspace> make_workspace() const override {
    return std::make_unique<StrandWorkspace>(StrandWorkspace{PathSolver(set_)});
  }

  void set_arms(const TreeState<double>& state, const Eigen::VectorXd& /*q*/,
                StrandWorkspace* workspace, StrandArms& arms) const override {
    // Solve the geodesics at this posture.
    const std::vector<PathShape>& shapes = workspace->solver.solve_for_arms(state);
    set_rows(state, shapes, arms.R);
    arms.warning.clear();
    arms.status = TendonStatus::kValid;
    // Find the worst status of all strands, with its warning.
    for (const int number : path_of_) {
      if (number < 0) continue;
      const auto path = static_cast<std::size_t>(number);
      const TendonStatus status = status_of(shapes[path].status);
      if (status > arms.status) arms.warning = warning_of(shapes[path], set_.paths[path].name);
      arms.status = worse(arms.status, status);
    }
  }

  [[nodiscard]] StrandDerivatives derivatives(const TreeState<double>& state,
                                              const Eigen::VectorXd& q,
                                              StrandWorkspace* workspace) const override {
    const std::unique_ptr<StrandWorkspace> own =
        workspace == nullptr ? this->make_workspace() : nullptr;
    const std::vector<PathShape>& shapes =
        (own ? own.get() : workspace)->solver.solve_for_arms(state);
    // Compute the second derivatives of all paths.
    std::vector<ArmDerivatives> paths =
        arm_derivatives(tree_, state, set_, shapes, static_cast<int>(q.size()));
    StrandDerivatives slopes{true, {}, lengths_of(shapes, q), {}};
    set_rows(state, shapes, slopes.R);
    // Copy them to the strands; those without a path have constant arms.
    for (const int number : path_of_) {
      slopes.dR.emplace_back(Eigen::MatrixXd::Zero(q.size(), q.size()));
      if (number < 0) continue;
      const auto path = static_cast<std::size_t>(number);
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
  /// Computes the lengths of all strands (strands) [m].
  [[nodiscard]] Eigen::VectorXd lengths_of(const std::vector<PathShape>& shapes,
                                           const Eigen::VectorXd& q) const {
    // Compute lengths: linear in the posture for constant arms.
    Eigen::VectorXd length = -constant_ * q;
    for (std::size_t s = 0; s < path_of_.size(); ++s)
      if (path_of_[s] >= 0) length[s] = shapes[path_of_[s]].length;
    return length;
  }

  /// Overwrites R with the arms of all strands (strands, coordinates) [m/rad].
  void set_rows(const TreeState<double>& state, const std::vector<PathShape>& shapes,
                Eigen::MatrixXd& R) const {
    // Start with the constant arms, and overwrite the rows of paths.
    R = constant_;
    path_arms(tree_, state, set_, shapes, strand_of_, R);
  }

  PathSet set_;
  Tree<double> tree_;
  Eigen::MatrixXd constant_;
  std::vector<int> path_of_;    // path of each strand; -1: constant arms
  std::vector<int> strand_of_;  // strand of each path; -1: it only carries another
};

/// Builds the paths of strands that have one.
PathSet strand_paths(const Subject& subject, const TendonDigit& digit) {
  std::vector<std::string> with_path;
  for (std::size_t s = 0; s < digit.names.strands.size(); ++s)
    if (!digit.model.paths[s].empty()) with_path.push_back(digit.names.strands[s]);
  return build_paths(subject, digit.skeleton, with_path);
}

}  // namespace

std::unique_ptr<StrandPaths> build_wrapped_paths(const Subject& subject, const TendonDigit& digit) {
  return std::make_unique<WrappedStrands>(strand_paths(subject, digit), digit);
}

namespace {

// Largest arm error without a warning: a tenth of a flexor's arm at finger joints [m/rad]
constexpr double kMaxUnreportedArmError = 1e-3;

/// Describes the path with the largest arm error; empty: all errors are small.
std::string worst_fit(const std::vector<FittedPath>& paths) {
  const auto worst =
      std::max_element(paths.begin(), paths.end(), [](const FittedPath& a, const FittedPath& b) {
        return a.error.arm_bound < b.error.arm_bound;
      });
  if (worst == paths.end() || worst->error.arm_bound <= kMaxUnreportedArmError) return "";
  return fmt::format("fitted arms of '{}' may be off by {:.2g} mm/rad", worst->name,
                     1e3 * worst->error.arm_bound);
}

/// Strands as fitted polynomials.
class FittedStrands : public StrandPaths {
 public:
  FittedStrands(const Subject& subject, const TendonDigit& digit, int order)
      : box_(fit_box(digit.skeleton)),
        names_(digit.names.coordinates),
        constant_(digit.model.constant_arms) {
    // Fit each wrapped path over the ranges of its joints.
    const PathSet set = strand_paths(subject, digit);
    for (std::size_t k = 0; k < set.paths.size(); ++k) {
      const int strand = place_in(digit.names.strands, set.paths[k].name);
      if (strand < 0) continue;  // it only carries another
      row_.push_back(strand);
      paths_.push_back(fit_path(digit.model.tree, set, k, box_, order));
    }
    worst_fit_ = worst_fit(paths_);
  }

  [[nodiscard]] StrandArms arms(const TreeState<double>& /*state*/,
                                const Eigen::VectorXd& q) const override {
    // Evaluate the polynomials at this posture.
    StrandArms arms{constant_, worst_fit_,
                    worst_fit_.empty() ? TendonStatus::kValid : TendonStatus::kApproximate};
    for (std::size_t k = 0; k < paths_.size(); ++k)
      arms.R.row(row_[k]) = fitted_length(paths_[k], q).arms;
    // Warn outside the ranges, where they are not valid; constant arms have none.
    for (Eigen::Index j = 0; !paths_.empty() && j < q.size(); ++j)
      if (q[j] < box_.lower[j] || q[j] > box_.upper[j]) {
        arms.status = TendonStatus::kOutOfRange;
        arms.warning =
            fmt::format("joint '{}' is outside the range that paths were fitted over", names_[j]);
      }
    return arms;
  }

  [[nodiscard]] StrandDerivatives derivatives(const TreeState<double>& /*state*/,
                                              const Eigen::VectorXd& q,
                                              StrandWorkspace* /*workspace*/) const override {
    // Start with constant arms, and overwrite the rows of fitted paths.
    StrandDerivatives slopes{true, constant_, -constant_ * q, {}};
    slopes.dR.assign(static_cast<std::size_t>(constant_.rows()),
                     Eigen::MatrixXd::Zero(q.size(), q.size()));
    for (std::size_t k = 0; k < paths_.size(); ++k) {
      const FittedLength fitted = fitted_length(paths_[k], q);
      slopes.length[row_[k]] = fitted.length;
      slopes.R.row(row_[k]) = fitted.arms;
      slopes.dR[row_[k]] = arm_derivatives(paths_[k], q);
    }
    return slopes;
  }

  [[nodiscard]] Eigen::VectorXd lengths(const TreeState<double>& /*state*/,
                                        const Eigen::VectorXd& q) const override {
    Eigen::VectorXd length = -constant_ * q;
    for (std::size_t k = 0; k < paths_.size(); ++k)
      length[row_[k]] = fitted_length(paths_[k], q).length;
    return length;
  }

 private:
  FitBox box_;
  std::vector<std::string> names_;
  Eigen::MatrixXd constant_;
  std::vector<Eigen::Index> row_;  // strand of each fitted path
  std::vector<FittedPath> paths_;
  std::string worst_fit_;  // warning at every posture; may be empty
};

}  // namespace

std::unique_ptr<StrandPaths> build_fitted_paths(const Subject& subject, const TendonDigit& digit,
                                                int order) {
  return std::make_unique<FittedStrands>(subject, digit, order);
}

}  // namespace thenar
