#include "sampling/diagnostics/split_directions.h"

#include <algorithm>
#include <map>

#include <Eigen/Eigenvalues>

namespace thenar {
namespace {

constexpr int kMostStarts = 20;        // of the climb of kurtosis
constexpr int kClimbSteps = 15;        // it converges cubically
constexpr Eigen::Index kDraws = 4000;  // that it looks at

/// y = A (x - mean) has unit covariance; directions without variance are left out.
struct Whitened {
  Eigen::MatrixXd A;  // (k, n)
  Eigen::MatrixXd y;  // (k, N)
};

Whitened whiten(const Eigen::MatrixXd& x) {
  const Eigen::VectorXd mean = x.rowwise().mean();
  const Eigen::MatrixXd centred = x.colwise() - mean;
  const Eigen::VectorXd sd =
      centred.rowwise().norm() / std::sqrt(double(std::max<Eigen::Index>(1, x.cols())));
  const Eigen::VectorXd scale =
      sd.unaryExpr([](double s) { return s > 0 ? 1 / s : 0.0; });  // units out of the way
  const Eigen::MatrixXd z = scale.asDiagonal() * centred;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(z * z.transpose() / double(x.cols()));
  const Eigen::Index kept = (eigen.eigenvalues().array() > 1e-12).count();
  Whitened of;
  of.A = eigen.eigenvalues().tail(kept).cwiseSqrt().cwiseInverse().asDiagonal() *
         eigen.eigenvectors().rightCols(kept).transpose() * scale.asDiagonal();
  of.y = of.A * centred;
  return of;
}

/// Where the means of chains lie apart, widest first (k, at most k).
Eigen::MatrixXd between_chains(const Eigen::MatrixXd& y, const std::vector<int>& chain) {
  std::map<int, std::pair<Eigen::VectorXd, double>> sums;
  for (Eigen::Index i = 0; i < y.cols(); ++i) {
    auto& [sum, count] =
        sums.try_emplace(chain[i], Eigen::VectorXd::Zero(y.rows()), 0.0).first->second;
    sum += y.col(i);
    ++count;
  }
  Eigen::MatrixXd between = Eigen::MatrixXd::Zero(y.rows(), y.rows());
  for (const auto& [name, of] : sums) between += of.first * of.first.transpose() / of.second;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(between);
  const auto wanted = std::min<Eigen::Index>({Eigen::Index(sums.size()) - 1, y.rows(), 5});
  return eigen.eigenvectors().rightCols(wanted).rowwise().reverse();
}

Eigen::VectorXd climb_kurtosis(const Eigen::MatrixXd& y, Eigen::VectorXd w) {
  for (int step = 0; step < kClimbSteps; ++step) {
    const Eigen::VectorXd along = y.transpose() * w;
    const Eigen::VectorXd next = y * along.array().cube().matrix() / double(y.cols()) - 3 * w;
    if (!(next.norm() > 0)) break;
    w = next.normalized();
  }
  return w;
}

}  // namespace

Eigen::MatrixXd split_directions(const Eigen::Ref<const Eigen::MatrixXd>& x,
                                 const std::vector<int>& chain) {
  const Eigen::Index n = x.rows();
  const Whitened white = whiten(x);
  const Eigen::Index k = white.y.rows();
  if (k == 0) return Eigen::MatrixXd::Identity(n, n);

  const Eigen::MatrixXd apart = between_chains(white.y, chain);
  const Eigen::Index every = (x.cols() + kDraws - 1) / kDraws;
  const Eigen::MatrixXd few = white.y(Eigen::all, Eigen::seq(0, Eigen::last, every));
  const Eigen::Index axes = std::min<Eigen::Index>(k, kMostStarts);
  Eigen::MatrixXd starts(k, apart.cols() + axes);
  starts << apart, Eigen::MatrixXd::Identity(k, axes);

  Eigen::MatrixXd w(k, apart.cols() + starts.cols());
  w.leftCols(apart.cols()) = apart;
  for (Eigen::Index i = 0; i < starts.cols(); ++i)
    w.col(apart.cols() + i) = climb_kurtosis(few, starts.col(i));

  // w'y = (A'w)'x: back to directions of x.
  Eigen::MatrixXd all(n, n + w.cols());
  all << Eigen::MatrixXd::Identity(n, n), (white.A.transpose() * w).colwise().normalized();
  return all;
}

}  // namespace thenar
