#pragma once

/// Adaptive Metropolis as one would write it for a density that is asked point by point.

#include <functional>
#include <random>

#include <Eigen/Core>

namespace thenar::bench {

/// Haario's sampler:  x' = x + L w,  w ~ N(0, I),  L L' = 2.4^2 / n (C + epsilon I),
/// C the covariance of all states so far, by which a first guess counts as if drawn
/// `guess_weight` times. C follows every step, L only now and then, which the theorem allows and
/// which spares most of the time. It adapts for ever, as published.
/// Source: [Haario2001] equations 2 and 3.
class HaarioMetropolis {
 public:
  using Density = std::function<double(const Eigen::VectorXd&)>;

  struct Options {
    double epsilon = 1e-12;   // keeps C positive definite [unit of x^2]
    int guess_weight = 100;   // steps that the first guess is worth [1]
    int refactor_every = 50;  // steps between factors of C [1]
    std::uint64_t seed = 1;
  };

  /// @param covariance  first guess (n, n)
  HaarioMetropolis(Density density, const Eigen::VectorXd& start, Eigen::MatrixXd covariance,
                   const Options& options);

  void step();
  [[nodiscard]] const Eigen::VectorXd& position() const { return x_; }  // (n)
  [[nodiscard]] long steps() const { return steps_; }
  [[nodiscard]] long accepted() const { return accepted_; }

 private:
  void learn();
  void factor();

  Density density_;
  Options options_;
  std::mt19937_64 rng_;
  std::normal_distribution<double> normal_;
  Eigen::VectorXd x_, proposal_, w_, mean_, deviation_;
  double value_;  // log density at x [1]
  Eigen::MatrixXd covariance_, L_;
  long steps_ = 0, accepted_ = 0;
};

}  // namespace thenar::bench
