#include "sampling/methods/learn_whitening.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include "base/error.h"
#include "sampling/methods/saved_shape.h"

namespace thenar::internal {

void WindowDraws::add(const Eigen::VectorXd& x, const Eigen::VectorXd& gradient) {
  if (count_ == x_.cols()) {
    const Eigen::Index room = std::max<Eigen::Index>(32, 2 * count_);
    x_.conservativeResize(Eigen::NoChange, room);
    gradient_.conservativeResize(Eigen::NoChange, room);
  }
  x_.col(count_) = x;
  gradient_.col(count_) = gradient;
  ++count_;
}

void WindowDraws::save(StateWriter& to) const {
  to.write(x());
  to.write(gradient());
}

void WindowDraws::restore(StateReader& from) {
  const Eigen::Index n = x_.rows();
  x_ = from.matrix();
  require(x_.rows() == n, "saved state, draws of a window: wanted {} rows, got {}", n, x_.rows());
  gradient_ = saved_matrix(from, "gradients of a window", n, x_.cols());
  count_ = x_.cols();
}

Eigen::MatrixXd shrunk_covariance(const Eigen::Ref<const Eigen::MatrixXd>& x,
                                  const Eigen::MatrixXd& before) {
  const auto n = static_cast<double>(x.cols());
  const Eigen::MatrixXd off = x.colwise() - x.rowwise().mean();
  const Eigen::MatrixXd square = before.cols() == 1 ? Eigen::MatrixXd(off.rowwise().squaredNorm())
                                                    : Eigen::MatrixXd(off * off.transpose());
  return n / (n + 5) / (n - 1) * square + 5 / (n + 5) * 1e-3 * before;
}

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Maximum ratio of a variance to that of the draws, because gradients do not bound it where the
// density is flat [1]
constexpr double kMaxVarianceRatio = 2;

/// Draws in linear coordinates z, and gradients by z (n, N).
struct Whitened {
  MatrixXd z, gradient;

  [[nodiscard]] MatrixXd residual() const { return z + gradient; }
};

/// Draws, and gradients by x (n, N).
struct Window {
  MatrixXd x, gradient;

  /// Returns every other draw, starting with the first or the second.
  [[nodiscard]] Window half(Index first) const {
    const Index count = (x.cols() - first + 1) / 2;
    Window out{MatrixXd(x.rows(), count), MatrixXd(x.rows(), count)};
    for (Index k = 0; k < count; ++k) {
      out.x.col(k) = x.col(first + 2 * k);
      out.gradient.col(k) = gradient.col(first + 2 * k);
    }
    return out;
  }
};

/// Affine coordinates:  x = c + F z.
struct Affine {
  VectorXd centre;
  MatrixXd factor, inverse;  // F and F^-1

  /// Transforms a window to z.
  [[nodiscard]] Whitened whitened(const Window& window) const {
    return {inverse * (window.x.colwise() - centre), factor.transpose() * window.gradient};
  }
  /// Returns the mean of |F' g + z|^2.
  [[nodiscard]] double left(const Window& window) const {
    return whitened(window).residual().squaredNorm() / static_cast<double>(window.x.cols());
  }
};

/// Chooses the centre such that the mean gradient vanishes.
Affine centred(const Window& window, MatrixXd factor, MatrixXd inverse) {
  const VectorXd mean = window.x.rowwise().mean();
  const VectorXd shift = factor.transpose() * window.gradient.rowwise().mean();
  return {mean + factor * shift, std::move(factor), std::move(inverse)};
}

/// Fits F F' = Sigma # C_g^-1; nothing if the draws do not span the space.
std::optional<Affine> fit_dense(const Window& window, const MatrixXd& before) {
  // Whiten by the covariance.
  const auto count = static_cast<double>(window.x.cols());
  const Eigen::LLT<MatrixXd> cholesky(shrunk_covariance(window.x, before));
  if (cholesky.info() != Eigen::Success) return {};
  const MatrixXd L = cholesky.matrixL(), gradient = L.transpose() * window.gradient;
  // In these coordinates, I # C^-1 is the inverse square root of the gradients' covariance. Shrink
  // the covariance as if by five more gradients of covariance I.
  const MatrixXd off = gradient.colwise() - gradient.rowwise().mean();
  const MatrixXd I = MatrixXd::Identity(off.rows(), off.rows());
  const MatrixXd covariance = (off * off.transpose() + 5 * I) / (count + 5);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(covariance);
  if (eigen.info() != Eigen::Success || !(eigen.eigenvalues()[0] > 0)) return {};
  const VectorXd scale =
      eigen.eigenvalues().array().max(1 / (kMaxVarianceRatio * kMaxVarianceRatio)).pow(-0.25);
  const MatrixXd& V = eigen.eigenvectors();
  const MatrixXd root = V * scale.asDiagonal() * V.transpose();
  const MatrixXd inverse_root = V * scale.cwiseInverse().asDiagonal() * V.transpose();
  return centred(window, L * root, inverse_root * cholesky.matrixL().solve(I));
}

/// Rescales the columns of the previous factor by s^4 = variance of z over that of gradients by z,
/// which minimises the residual; variances are shrunk as if by five more draws of variance 1.
std::optional<Affine> fit_scales(const Window& window, const Whitening& before) {
  const auto count = static_cast<double>(window.x.cols());
  const auto variances = [count](const MatrixXd& sample) -> Eigen::ArrayXd {
    const MatrixXd off = sample.colwise() - sample.rowwise().mean();
    return (off.rowwise().squaredNorm().array() + 5) / (count + 5);
  };
  const Eigen::ArrayXd variance = variances(before.inverse() * window.x),
                       of_gradient = variances(before.factor().transpose() * window.gradient);
  const VectorXd scale = (variance / of_gradient).sqrt().min(kMaxVarianceRatio * variance).sqrt();
  if (!scale.allFinite() || !(scale.minCoeff() > 0)) return {};
  return centred(window, before.factor() * scale.asDiagonal(),
                 scale.cwiseInverse().asDiagonal() * before.inverse());
}

/// Fits a dense factor if there are enough draws, and if it leaves a smaller residual than
/// rescaling on held-out draws.
std::optional<Affine> fit_affine(const Window& window, const Whitening& before) {
  const Index n = window.x.rows();
  if (window.x.cols() < 2 * n) return fit_scales(window, before);
  const MatrixXd covariance = before.covariance();
  const Window seen = window.half(0), unseen = window.half(1);
  const std::optional<Affine> dense = fit_dense(seen, covariance),
                              scaled = fit_scales(seen, before);
  const bool scales_do = scaled && dense && !(dense->left(unseen) < scaled->left(unseen));
  if (scales_do) return fit_scales(window, before);
  return fit_dense(window, covariance);
}

/// Draws in coordinates that begin with the drivers, and the potential of a bend,
///   psi = z . q(z),   grad psi = q + (dq/dz)' z,
/// which is the first-order change of the gradients by the bend.
class BendPotential {
 public:
  BendPotential(MatrixXd z, int drivers) : z_(std::move(z)), drivers_(drivers) {
    products_.resize(pairs(), z_.cols());
    for (int k = 0, pair = 0; k < drivers_; ++k)
      for (int j = 0; j <= k; ++j, ++pair)
        products_.row(pair) =
            (z_.row(j).array() * z_.row(k).array() - (j == k ? 1.0 : 0.0)).matrix();
  }

  [[nodiscard]] int pairs() const { return drivers_ * (drivers_ + 1) / 2; }

  /// Returns the gradients of psi at all draws for given strengths (n, pairs).
  [[nodiscard]] MatrixXd gradient(const MatrixXd& strength) const {
    MatrixXd out = strength * products_;
    const MatrixXd along = strength.transpose() * z_;
    for (int k = 0, pair = 0; k < drivers_; ++k)
      for (int j = 0; j <= k; ++j, ++pair) {
        out.row(j) += along.row(pair).cwiseProduct(z_.row(k));
        out.row(k) += along.row(pair).cwiseProduct(z_.row(j));
      }
    return out;
  }

  /// Applies the transpose of that linear map, with zeros for strengths that are fixed at zero.
  [[nodiscard]] MatrixXd transposed(const MatrixXd& residual) const {
    MatrixXd out = residual * products_.transpose();
    for (int k = 0, pair = 0; k < drivers_; ++k)
      for (int j = 0; j <= k; ++j, ++pair) {
        out.col(pair) +=
            z_ * (residual.row(j).cwiseProduct(z_.row(k)) + residual.row(k).cwiseProduct(z_.row(j)))
                     .transpose();
        out.col(pair).head(k + 1).setZero();
      }
    return out;
  }

 private:
  MatrixXd z_;         // draws (n, N)
  int drivers_;        // K, number of drivers
  MatrixXd products_;  // products of drivers (pairs, N)
};

/// Strengths by least squares, and the residual.
struct Strengths {
  MatrixXd strength;  // (n, pairs)
  MatrixXd left;      // remaining residual (n, N)
};

/// Fits the strengths by conjugate gradients with ridge regularisation. The terms are nearly
/// orthogonal, so that a few iterations suffice.
Strengths fit_strengths(const BendPotential& potential, const MatrixXd& residual) {
  constexpr int kGradientSteps = 8;  // maximum number of iterations
  constexpr double kStrengthWeight =
      15;  // weight of the regularisation, equivalent to five draws [1]
  Strengths out{MatrixXd::Zero(residual.rows(), potential.pairs()), residual};
  MatrixXd slope = potential.transposed(residual), direction = slope;
  double square = slope.squaredNorm();
  for (int step = 0; step < kGradientSteps && square > 0; ++step) {
    const MatrixXd change = potential.gradient(direction);
    const double length =
        square / (change.squaredNorm() + kStrengthWeight * direction.squaredNorm());
    out.strength += length * direction;
    out.left -= length * change;
    slope = potential.transposed(out.left) - kStrengthWeight * out.strength;
    const double next = slope.squaredNorm();
    direction = slope + next / square * direction;
    square = next;
  }
  return out;
}

/// Search for unit vectors v along which residuals bend most: maximises the cubic form of third
/// moments
///   T(c, v, v),   T(a, b, d) = mean of (a.r)(b.z)(d.z) + (b.r)(a.z)(d.z) + (d.r)(a.z)(b.z),
/// with c orthogonal to v and the previous drivers, by power iteration from several draws.
class DriverSearch {
 public:
  DriverSearch(const MatrixXd& z, const MatrixXd& left, const MatrixXd& drivers)
      : z_(z), left_(left), drivers_(drivers) {}

  /// Returns the best vector (n); empty if there is none.
  [[nodiscard]] VectorXd find() const {
    VectorXd found;
    double max_form = 0;
    for (VectorXd v : starts()) {
      const double form = climb(v);
      if (!(form > max_form)) continue;
      max_form = form;
      found = v;
    }
    return found;
  }

 private:
  /// Returns distinct directions of draws with the largest residuals.
  [[nodiscard]] std::vector<VectorXd> starts() const {
    constexpr std::size_t kDriverStarts = 4;  // maximum number of starting directions
    VectorXd size = left_.colwise().norm();
    std::vector<VectorXd> found;
    for (Index tried = 0; tried < size.size() && found.size() < kDriverStarts; ++tried) {
      Index at = 0;
      size.maxCoeff(&at);
      size[at] = -1;
      const VectorXd v = across(z_.col(at));
      if (!(v.norm() > 0)) continue;
      const VectorXd unit = v.normalized();
      const bool apart = std::all_of(found.begin(), found.end(), [&](const VectorXd& other) {
        return std::abs(unit.dot(other)) < 0.9;
      });
      if (apart) found.push_back(unit);
    }
    return found;
  }

  /// Improves v, and returns T(c, v, v) of the best unit vector c.
  double climb(VectorXd& v) const {
    constexpr int kPowerSteps = 30;  // maximum number of power iterations
    double form = 0;
    for (int step = 0; step < kPowerSteps; ++step) {
      // Compute the best c for this v.
      const VectorXd z_v = z_.transpose() * v, r_v = left_.transpose() * v;
      VectorXd c = left_ * (z_v.array().square() - 1).matrix() + 2 * (z_ * z_v.cwiseProduct(r_v));
      c = across(c - v * v.dot(c));
      form = c.norm();
      if (!(form > 0)) return 0;
      c /= form;
      // Update v to T(c, v, .).
      const VectorXd z_c = z_.transpose() * c, r_c = left_.transpose() * c;
      const VectorXd next = across(z_ * (r_c.cwiseProduct(z_v) + r_v.cwiseProduct(z_c)) +
                                   left_ * z_c.cwiseProduct(z_v));
      if (!(next.norm() > 0)) return 0;
      const VectorXd before = v;
      v = next.normalized();
      if (std::abs(v.dot(before)) > 1 - 1e-6) break;
    }
    return form;
  }

  /// Projects v orthogonally to the previous drivers.
  [[nodiscard]] VectorXd across(const VectorXd& v) const {
    if (drivers_.cols() == 0) return v;
    return v - drivers_ * (drivers_.transpose() * v);
  }

  const MatrixXd& z_;
  const MatrixXd& left_;
  const MatrixXd& drivers_;
};

/// Bend in rotated coordinates: z = Q (y + q(y)).
struct TurnedBend {
  MatrixXd turn;  // rotation Q, drivers first (n, n)
  Bend bend;
};

/// Fits drivers one after another to the remaining residual, each time with all strengths.
TurnedBend fit_bend(const Whitened& in) {
  const Index n = in.z.rows();
  const MatrixXd residual = in.residual();
  MatrixXd drivers(n, 0), left = residual;
  TurnedBend out{MatrixXd::Identity(n, n), {}};
  while (drivers.cols() < std::min<Index>(Bend::kMaxDrivers, n - 1)) {
    const VectorXd next = DriverSearch(in.z, left, drivers).find();
    if (next.size() == 0) break;
    drivers.conservativeResize(Eigen::NoChange, drivers.cols() + 1);
    drivers.rightCols(1) = next;
    // Rotate the drivers to the first coordinates.
    const Eigen::HouseholderQR<MatrixXd> qr(drivers);
    out.turn = qr.householderQ();
    out.turn.leftCols(drivers.cols()) = drivers;
    out.bend.drivers = static_cast<int>(drivers.cols());
    const Strengths fitted =
        fit_strengths(BendPotential(out.turn.transpose() * in.z, out.bend.drivers),
                      out.turn.transpose() * residual);
    out.bend.strength = fitted.strength;
    left = out.turn * fitted.left;
  }
  return out;
}

/// Mean squares of the residual gradients |g + y|^2, with g by y, and of all gradients |g|^2.
struct Remainder {
  double left = 0, all = 0;
};
/// Evaluates the residual of whitened draws with a bend.
Remainder remainder(const Whitened& in, const TurnedBend& turned) {
  Remainder sum;
  for (Index k = 0; k < in.z.cols(); ++k) {
    const VectorXd y = turned.bend.invert(turned.turn.transpose() * in.z.col(k));
    VectorXd gradient = turned.turn.transpose() * in.gradient.col(k);
    turned.bend.pull_back_gradient(y, gradient);
    sum.left += (gradient + y).squaredNorm();
    sum.all += gradient.squaredNorm();
  }
  return sum;
}

}  // namespace

bool learn_whitening(const WindowDraws& draws, Whitening& whitening) {
  if (draws.count() < 2) return false;
  const MatrixXd before = whitening.covariance();
  if (!whitening.is_dense()) return whitening.set_covariance(shrunk_covariance(draws.x(), before));
  const Window window{draws.x(), draws.gradient()};
  const std::optional<Affine> affine =
      window.gradient.allFinite() ? fit_affine(window, whitening) : std::nullopt;
  if (!affine) return whitening.set_covariance(shrunk_covariance(draws.x(), before));

  // Accept a bend only if it reduces the residual on held-out draws.
  constexpr double kLeftByBend = 0.9,
                   kLeftByOrbit = 0.5;  // maximum residual ratios with a bend, and with orbits [1]
  const Whitened all = affine->whitened(window);
  const Index n = all.z.rows();
  const TurnedBend straight{MatrixXd::Identity(n, n), {}};
  const Whitened seen = affine->whitened(window.half(0)), unseen = affine->whitened(window.half(1));
  const bool helps = n > 1 && remainder(unseen, fit_bend(seen)).left <
                                  kLeftByBend * remainder(unseen, straight).left;
  const TurnedBend best = helps ? fit_bend(all) : straight;
  const Remainder remains = remainder(all, best);
  const bool orbits = remains.left < kLeftByOrbit * remains.all;
  if (!helps) return whitening.set_map(affine->centre, affine->factor, {}, orbits);
  return whitening.set_map(affine->centre, affine->factor * best.turn, best.bend, orbits);
}

}  // namespace thenar::internal
