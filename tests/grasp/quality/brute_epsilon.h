#pragma once

/// The least support of a wrench set over all directions, by descents from many
/// starts: knows nothing of hulls.

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "grasp/contact/wrench_set.h"
#include "tests/grasp/quality/random_grasps.h"

namespace thenar {

inline WrenchCoordinates random_wrench_direction(std::mt19937& rng) {
  WrenchCoordinates u;
  do {
    for (double& x : u) x = uniform(rng, -1, 1);
  } while (u.norm() > 1 || u.norm() < 0.1);
  return u.normalized();
}

/// Descends on a smoothed support, whose smoothing t goes to 0:
///   reach_i = c'u + sqrt(|A'u|^2 + t^2);  kL1: t log sum exp(reach_i / t);
///   kLinf: sum of t log(1 + exp(reach_i / t)).
/// Each contact has one cap here.
class BruteEpsilon {
 public:
  BruteEpsilon(const WrenchSet& set, ForceNorm limit) : set_(set), limit_(limit) {}

  /// Best of 10 descents, and of up to `most` while it is above `enough`; never below the true
  /// epsilon, rounding aside.
  double operator()(std::mt19937& rng, int most, double enough) const {
    double best = 1e300;
    for (int i = 0; i < 10 || (i < most && best > enough); ++i)
      best = std::min(
          best,
          support(set_,
                  ScaledWrench::from_coordinates(descend(random_wrench_direction(rng), i % 5)),
                  limit_));
    return best;
  }

 private:
  struct Smooth {
    double h;
    WrenchCoordinates slope;  // along the sphere
  };

  Smooth smooth(const WrenchCoordinates& u, double t) const {
    std::vector<double> reach;
    std::vector<WrenchCoordinates> slope;
    for (const WrenchCap& cap : set_.caps) {
      const Eigen::Vector3d z =
          (Eigen::Vector3d() << cap.A.transpose() * u, Eigen::VectorXd::Zero(3 - cap.A.cols()))
              .finished();
      const double length = std::sqrt(z.squaredNorm() + t * t);
      const WrenchCoordinates c = cap.c.vector();
      reach.push_back(c.dot(u) + length);
      slope.emplace_back(c + cap.A * (z.head(cap.A.cols()) / length));
    }
    // kLinf joins each contact with 0 alone, kL1 all contacts with each other.
    Smooth out{0, WrenchCoordinates::Zero()};
    const double top = *std::max_element(reach.begin(), reach.end());
    double sum = 0;
    for (std::size_t i = 0; i < reach.size(); ++i) {
      if (limit_ == ForceNorm::kL1) {
        const double weight = std::exp((reach[i] - top) / t);
        sum += weight;
        out.slope += weight * slope[i];
      } else {
        out.h += std::max(0.0, reach[i]) + t * std::log1p(std::exp(-std::abs(reach[i]) / t));
        out.slope += slope[i] / (1 + std::exp(-reach[i] / t));
      }
    }
    if (limit_ == ForceNorm::kL1) {
      out.h = top + t * std::log(sum);
      out.slope /= sum;
    }
    out.slope -= out.slope.dot(u) * u;
    return out;
  }

  /// @param roughness  0 to start from a very smooth function, which leads to few minima
  WrenchCoordinates descend(WrenchCoordinates u, int roughness) const {
    for (double t = 0.3 * std::pow(3.0, -roughness); t > 1e-7; t /= 4) u = descend_at(u, t);
    return u;
  }

  /// BFGS on directions.
  WrenchCoordinates descend_at(WrenchCoordinates u, double t) const {
    using Matrix = Eigen::Matrix<double, 6, 6>;
    Matrix inverse = t * Matrix::Identity();
    Smooth now = smooth(u, t);
    for (int i = 0; i < 60; ++i) {
      WrenchCoordinates way = -inverse * now.slope;
      if (way.dot(now.slope) >= 0) {
        inverse = t * Matrix::Identity();
        way = -inverse * now.slope;
      }
      double step = std::min(1.0, 0.5 / (way.norm() + 1e-300));
      Smooth next{};
      WrenchCoordinates to;
      for (int halvings = 0; halvings < 40; ++halvings, step /= 2) {
        to = (u + step * way).normalized();
        next = smooth(to, t);
        if (next.h <= now.h + 1e-4 * step * way.dot(now.slope)) break;
      }
      if (!(next.h < now.h - 1e-12)) return u;
      const WrenchCoordinates s = to - u, y = next.slope - now.slope;
      const double sy = s.dot(y);
      if (sy > 1e-14) {
        const Matrix left = Matrix::Identity() - s * y.transpose() / sy;
        inverse = left * inverse * left.transpose() + s * s.transpose() / sy;
      }
      u = to;
      now = next;
    }
    return u;
  }

  const WrenchSet& set_;
  ForceNorm limit_;
};

}  // namespace thenar
