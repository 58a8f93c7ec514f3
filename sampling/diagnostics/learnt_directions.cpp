#include "sampling/diagnostics/learnt_directions.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "base/error.h"

namespace thenar {
namespace {

constexpr double kMinNamedShare = 0.05;  // minimum share of an entry in the text [1]
constexpr int kMaxNamedEntries = 5;      // maximum number of entries in the text

/// Describes a direction by its largest entries.
std::string tell(const std::vector<std::string>& names, const LearntDirection& direction) {
  // Sort entries by falling share.
  std::vector<Eigen::Index> order(names.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
    return direction.share[a] > direction.share[b];
  });

  // The sign of a direction is arbitrary: make the largest entry positive.
  const double sign = direction.v[order[0]] < 0 ? -1 : 1;
  std::string text;
  int named = 0;
  for (const Eigen::Index i : order) {
    if (direction.share[i] < kMinNamedShare || named++ == kMaxNamedEntries) break;
    const char* joint = direction.v[i] * sign < 0 ? " - " : " + ";
    text += fmt::format("{}{:.2f} {}", text.empty() ? "" : joint, direction.share[i], names[i]);
  }
  return fmt::format("{}: sd {:.2g} of the prior's", text, direction.sd_ratio);
}

}  // namespace

Eigen::MatrixXd covariance_of(const Eigen::Ref<const Eigen::MatrixXd>& x) {
  require(x.cols() >= 2, "a covariance needs 2 draws, got {}", x.cols());
  const Eigen::MatrixXd centred = x.colwise() - x.rowwise().mean();
  return centred * centred.transpose() / double(x.cols() - 1);
}

LearntDirections learnt_directions(const std::vector<std::string>& names,
                                   const Eigen::Ref<const Eigen::MatrixXd>& S,
                                   const Eigen::Ref<const Eigen::MatrixXd>& P,
                                   double decided_below) {
  return learnt_directions(names, PosteriorCovariances{S, S, S}, P, decided_below);
}

LearntDirections learnt_directions(const std::vector<std::string>& names,
                                   const PosteriorCovariances& S,
                                   const Eigen::Ref<const Eigen::MatrixXd>& P,
                                   double decided_below) {
  const auto n = Eigen::Index(names.size());
  for (const Eigen::MatrixXd* each : {&S.all, &S.first, &S.second}) {
    require(each->rows() == n && each->cols() == n && P.rows() == n && P.cols() == n,
            "{} names for covariances of {} x {} and {} x {}", n, each->rows(), each->cols(),
            P.rows(), P.cols());
    require(each->allFinite() && P.allFinite(), "covariances must be finite");
  }

  // Scale to prior sds, so that units of very different size do no harm.
  const Eigen::VectorXd scale = P.diagonal().cwiseSqrt().cwiseInverse();
  require(scale.allFinite(), "the prior covariance is not positive definite");
  const auto scaled = [&scale](const Eigen::MatrixXd& C) -> Eigen::MatrixXd {
    return scale.asDiagonal() * C * scale.asDiagonal();
  };
  const Eigen::MatrixXd prior = scaled(P), measured = scaled(S.second);
  const Eigen::LLT<Eigen::MatrixXd> factor(prior);
  require(factor.info() == Eigen::Success, "the prior covariance is not positive definite");
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled(S.first), prior);

  // Take directions from one half, scaled to one prior sd, with their variances in the other half.
  LearntDirections out;
  for (Eigen::Index k = 0; k < n; ++k) {
    LearntDirection direction;
    const Eigen::VectorXd w = eigen.eigenvectors().col(k);
    direction.sd_ratio = std::sqrt(std::max(0.0, w.dot(measured * w)));
    direction.v = scale.cwiseProduct(w);
    direction.share = w.cwiseAbs2() / w.squaredNorm();
    direction.text = tell(names, direction);
    out.decided += direction.sd_ratio < decided_below ? 1 : 0;
    out.directions.push_back(direction);
  }
  std::stable_sort(
      out.directions.begin(), out.directions.end(),
      [](const LearntDirection& a, const LearntDirection& b) { return a.sd_ratio < b.sd_ratio; });
  out.effective_parameters = std::max(0.0, double(n) - factor.solve(scaled(S.all)).trace());
  return out;
}

}  // namespace thenar
