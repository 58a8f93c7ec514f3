#pragma once

/// Densities whose means, sds and modes are known.

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "sampling/methods/target.h"

namespace thenar::sample {

/// A target from two functions of one point: log density and its gradient. All of it counts as
/// likelihood, with a wide normal prior if `prior_sd` is finite, so that it can be tempered.
class FunctionTarget : public Target {
 public:
  using Value = std::function<double(const Eigen::VectorXd& x, Eigen::VectorXd& gradient)>;

  FunctionTarget(int n, Value value, double prior_sd = std::numeric_limits<double>::infinity())
      : n_(n), value_(std::move(value)), precision_(1 / (prior_sd * prior_sd)) {}

  [[nodiscard]] int size() const override { return n_; }

  [[nodiscard]] Densities evaluate(const Eigen::Ref<const Eigen::MatrixXd>& x,
                                   WithGradient want) const override {
    Densities at;
    at.log_prior = -0.5 * precision_ * x.colwise().squaredNorm().transpose();
    at.log_likelihood.resize(x.cols());
    Eigen::MatrixXd gradient(n_, x.cols());
    for (Eigen::Index k = 0; k < x.cols(); ++k) {
      Eigen::VectorXd by(n_);
      // The prior is taken off again: value_ is the whole density.
      at.log_likelihood[k] = value_(x.col(k), by) - at.log_prior[k];
      gradient.col(k) = by;
    }
    if (want == WithGradient::kNo) return at;
    at.prior_gradient = -precision_ * x;
    at.likelihood_gradient = gradient - at.prior_gradient;
    return at;
  }

 private:
  int n_;
  Value value_;
  double precision_;
};

/// Moments that a sampler must find.
struct KnownPosterior {
  std::string name;
  FunctionTarget target;
  Eigen::VectorXd mean, sd;  // exact, or of published reference draws; NaN: none known (n)
  Eigen::VectorXd mcse;      // of the published mean; 0: exact (n)
};

/// Normal of n dimensions whose sds run evenly on a log scale from 1 to sqrt(condition), turned
/// by a fixed rotation so that no axis is special.
inline KnownPosterior gaussian(int n, double condition) {
  const Eigen::VectorXd u = Eigen::VectorXd::LinSpaced(n, 1, 2).normalized();
  const Eigen::MatrixXd Q = Eigen::MatrixXd::Identity(n, n) - 2 * u * u.transpose();
  Eigen::VectorXd variance(n);
  for (int i = 0; i < n; ++i) variance[i] = std::pow(condition, double(i) / (n - 1));
  const Eigen::MatrixXd P = Q * variance.cwiseInverse().asDiagonal() * Q;
  const Eigen::VectorXd sd = (Q * variance.asDiagonal() * Q).diagonal().cwiseSqrt();
  return {"gaussian",
          FunctionTarget(n,
                         [P](const Eigen::VectorXd& x, Eigen::VectorXd& by) {
                           by = -P * x;
                           return 0.5 * x.dot(by);
                         }),
          Eigen::VectorXd::Zero(n), sd, Eigen::VectorXd::Zero(n)};
}

/// exp(-(100 (y - x^2)^2 + (1 - x)^2) / 20): x ~ N(1, 10), y | x ~ N(x^2, 0.1).
inline KnownPosterior banana() {
  return {"banana",
          FunctionTarget(2,
                         [](const Eigen::VectorXd& x, Eigen::VectorXd& by) {
                           const double bend = x[1] - x[0] * x[0], off = x[0] - 1;
                           by[0] = 20 * bend * x[0] - off / 10;
                           by[1] = -10 * bend;
                           return -5 * bend * bend - off * off / 20;
                         }),
          Eigen::Vector2d(1, 11), Eigen::Vector2d(std::sqrt(10.0), std::sqrt(240.1)),
          Eigen::Vector2d(0, 0)};
}

/// v ~ N(0, 3), x_i | v ~ N(0, exp(v / 2)), with x_i = exp(v / 2) w_i unless centred.
inline KnownPosterior funnel(int n, bool centred) {
  Eigen::VectorXd sd = Eigen::VectorXd::Ones(n);
  sd[0] = 3;
  if (centred) sd.tail(n - 1).setConstant(std::exp(2.25));
  return {"funnel",
          FunctionTarget(n,
                         [centred](const Eigen::VectorXd& x, Eigen::VectorXd& by) {
                           const Eigen::Index m = x.size() - 1;
                           const double tight = centred ? std::exp(-x[0]) : 1;
                           const double sum = tight * x.tail(m).squaredNorm();
                           by[0] = -x[0] / 9 + (centred ? 0.5 * (sum - double(m)) : 0);
                           by.tail(m) = -tight * x.tail(m);
                           return -x[0] * x[0] / 18 - 0.5 * sum -
                                  (centred ? 0.5 * double(m) * x[0] : 0);
                         }),
          Eigen::VectorXd::Zero(n), sd, Eigen::VectorXd::Zero(n)};
}

/// Eight schools, not centred: x = (mu, log tau, eta_1 .. eta_8), theta = mu + tau eta.
/// Reference draws of posteriordb: mu 4.4105 +- 3.3093.
inline KnownPosterior eight_schools() {
  Eigen::VectorXd y(8), s(8);
  y << 28, 8, -3, 7, -1, 1, 18, 12;
  s << 15, 10, 16, 11, 9, 11, 10, 18;
  const double none = std::numeric_limits<double>::quiet_NaN();
  Eigen::VectorXd mean = Eigen::VectorXd::Constant(10, none), sd = mean;
  mean[0] = 4.4105;
  sd[0] = 3.3093;
  return {"eight schools",
          FunctionTarget(10,
                         [y, s](const Eigen::VectorXd& x, Eigen::VectorXd& by) {
                           const double tau = std::exp(x[1]);
                           const Eigen::VectorXd eta = x.tail(8);
                           const Eigen::VectorXd off =
                               ((y.array() - x[0] - tau * eta.array()) / s.array()).matrix();
                           const Eigen::VectorXd pull = (off.array() / s.array()).matrix();
                           // tau ~ half-Cauchy(5); the last term is the Jacobian of exp.
                           const double heavy = tau * tau / 25;
                           by[0] = pull.sum() - x[0] / 25;
                           by[1] = tau * pull.dot(eta) - 2 * heavy / (1 + heavy) + 1;
                           by.tail(8) = tau * pull - eta;
                           return -0.5 * off.squaredNorm() - x[0] * x[0] / 50 - std::log1p(heavy) +
                                  x[1] - 0.5 * eta.squaredNorm();
                         }),
          mean, sd, Eigen::VectorXd::Constant(10, 0.04)};
}

/// 1/3 N(-5, I) + 2/3 N(5, I): mean 5/3, sd 4.819 on each axis.
inline KnownPosterior two_modes(int n) {
  return {"two modes",
          FunctionTarget(
              n,
              [](const Eigen::VectorXd& x, Eigen::VectorXd& by) {
                const double a = std::log(1.0 / 3) - 0.5 * (x.array() + 5).square().sum();
                const double b = std::log(2.0 / 3) - 0.5 * (x.array() - 5).square().sum();
                const double top = std::max(a, b);
                const double pa = std::exp(a - top), pb = std::exp(b - top);
                by = -(pa * (x.array() + 5) + pb * (x.array() - 5)) / (pa + pb);
                return top + std::log(pa + pb);
              },
              10),
          Eigen::VectorXd::Constant(n, 5.0 / 3),
          Eigen::VectorXd::Constant(n, std::sqrt(26 - 25.0 / 9)), Eigen::VectorXd::Zero(n)};
}

}  // namespace thenar::sample
