#include <algorithm>

#include "base/error.h"
#include "tendons/strand_paths.h"
#include "tendons/wrapping/fitted_path.h"

namespace thenar {
namespace {

constexpr double kTold = 1e-3;  // possible error of an arm that is told: a tenth of a flexor's
                                // at a finger's joints [m/rad]

/// The path whose arms may be furthest off, in words; empty: all are near.
std::string worst_fit(const std::vector<FittedPath>& paths) {
  const auto worst =
      std::max_element(paths.begin(), paths.end(), [](const FittedPath& a, const FittedPath& b) {
        return a.error.arm_bound < b.error.arm_bound;
      });
  if (worst == paths.end() || worst->error.arm_bound <= kTold) return "";
  return fmt::format("fitted arms of '{}' may be off by {:.2g} mm/rad", worst->name,
                     1e3 * worst->error.arm_bound);
}

class FittedStrands : public StrandPaths {
 public:
  FittedStrands(const Subject& subject, const TendonDigit& digit, int order)
      : box_(fit_box(digit.skeleton)),
        names_(digit.names.coordinates),
        constant_(digit.model.constant_arms) {
    std::vector<std::string> with_path;
    for (std::size_t s = 0; s < digit.names.strands.size(); ++s)
      if (!digit.model.paths[s].empty()) with_path.push_back(digit.names.strands[s]);
    const PathSet set = build_paths(subject, digit.skeleton, with_path);
    for (std::size_t k = 0; k < set.paths.size(); ++k) {
      const auto strand =
          std::find(digit.names.strands.begin(), digit.names.strands.end(), set.paths[k].name);
      if (strand == digit.names.strands.end()) continue;  // it only carries another
      row_.push_back(strand - digit.names.strands.begin());
      paths_.push_back(fit_path(digit.model.tree, set, k, box_, order));
    }
    worst_fit_ = worst_fit(paths_);
  }

  [[nodiscard]] StrandArms arms(const TreeState<double>& /*state*/,
                                const Eigen::VectorXd& q) const override {
    StrandArms arms{constant_, worst_fit_,
                    worst_fit_.empty() ? TendonStatus::kSound : TendonStatus::kRough};
    for (std::size_t k = 0; k < paths_.size(); ++k)
      arms.R.row(row_[k]) = fitted_length(paths_[k], q).arms;
    for (Eigen::Index j = 0; j < q.size(); ++j)
      if (q[j] < box_.lower[j] || q[j] > box_.upper[j]) {
        arms.status = TendonStatus::kOutOfRange;
        arms.trouble = fmt::format("joint '{}' is outside the range that paths were fitted over",
                                   names_[static_cast<std::size_t>(j)]);
      }
    return arms;
  }

  [[nodiscard]] StrandSlopes slopes(const TreeState<double>& /*state*/,
                                    const Eigen::VectorXd& q) const override {
    StrandSlopes slopes{true, constant_, -constant_ * q, {}};
    slopes.dR.assign(static_cast<std::size_t>(constant_.rows()),
                     Eigen::MatrixXd::Zero(q.size(), q.size()));
    for (std::size_t k = 0; k < paths_.size(); ++k) {
      const FittedLength fitted = fitted_length(paths_[k], q);
      slopes.length[row_[k]] = fitted.length;
      slopes.R.row(row_[k]) = fitted.arms;
      slopes.dR[static_cast<std::size_t>(row_[k])] = arm_slopes(paths_[k], q);
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
  std::string worst_fit_;  // why not to trust them at any posture
};

}  // namespace

std::unique_ptr<StrandPaths> build_fitted_paths(const Subject& subject, const TendonDigit& digit,
                                                int order) {
  return std::make_unique<FittedStrands>(subject, digit, order);
}

}  // namespace thenar
