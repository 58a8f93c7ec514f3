#pragma once

/// Invented quantities of a posterior.

#include <cmath>
#include <string>

#include "base/random_stream.h"
#include "report/draws/draws.h"

namespace thenar::sample {

struct SampleChains {
  Eigen::Index draws = 100, chains = 4;
  unsigned seed = 1;
};

/// Normal draws about `mean`, whose estimate has this R-hat.
inline Quantity quantity(const std::string& name, double mean, double sd, double r_hat,
                         const SampleChains& of = {}) {
  Quantity out;
  out.name = name;
  out.unit = "deg";
  RandomStream random(of.seed, 0, 0);
  out.draws = Eigen::MatrixXd::NullaryExpr(of.draws, of.chains,
                                           [&] { return mean + sd * random.normal(); });
  out.prior = Eigen::VectorXd::NullaryExpr(1000, [&] { return random.normal(); });
  out.estimate = {name, mean, sd, 0.01, 0.01, mean - sd, mean, mean + sd, r_hat, 400, 300};
  return out;
}

}  // namespace thenar::sample
