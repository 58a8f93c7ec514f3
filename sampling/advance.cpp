#include "sampling/advance.h"

namespace thenar {
namespace {

/// The densities of columns first .. first + count - 1.
Densities part(const Densities& all, Eigen::Index first, Eigen::Index count) {
  Densities at;
  at.log_prior = all.log_prior.segment(first, count);
  at.log_likelihood = all.log_likelihood.segment(first, count);
  if (all.prior_gradient.size() == 0) return at;
  at.prior_gradient = all.prior_gradient.middleCols(first, count);
  at.likelihood_gradient = all.likelihood_gradient.middleCols(first, count);
  return at;
}

Eigen::MatrixXd questions(const std::vector<Sampler*>& samplers, int size) {
  Eigen::Index points = 0;
  for (const Sampler* sampler : samplers) points += sampler->asks().cols();
  Eigen::MatrixXd x(size, points);
  Eigen::Index at = 0;
  for (const Sampler* sampler : samplers) {
    x.middleCols(at, sampler->asks().cols()) = sampler->asks();
    at += sampler->asks().cols();
  }
  return x;
}

}  // namespace

void advance(const std::vector<Sampler*>& samplers, const Target& target, long steps,
             const StepHeard& heard, const std::function<bool()>& stop) {
  std::vector<Sampler*> going;
  std::vector<std::size_t> number;
  WithGradient want = WithGradient::kNo;
  while (true) {
    going.clear();
    number.clear();
    for (std::size_t i = 0; i < samplers.size(); ++i) {
      if (samplers[i]->steps() >= steps) continue;
      going.push_back(samplers[i]);
      number.push_back(i);
      if (samplers[i]->wants() == WithGradient::kYes) want = WithGradient::kYes;
    }
    if (going.empty() || (stop && stop())) return;
    const Densities at = target.evaluate(questions(going, target.size()), want);
    Eigen::Index first = 0;
    for (std::size_t i = 0; i < going.size(); ++i) {
      const Eigen::Index count = going[i]->asks().cols();
      const long before = going[i]->steps();
      going[i]->tell(part(at, first, count));
      first += count;
      if (heard && going[i]->steps() > before) heard(number[i]);
    }
  }
}

}  // namespace thenar
