#include "pad_laws/exponential_memory.h"

#include <cmath>
#include <cstddef>

#include "base/error.h"

namespace thenar {

MemoryStep memory_step(const std::vector<ExponentialTerm>& terms, double h) {
  require(h >= 0, "a step of a memory must be 0 s or longer, got {} s", h);
  MemoryStep step;
  for (const ExponentialTerm& term : terms) {
    const double x = h / term.time;
    step.decay.push_back(std::exp(-x));
    // (1 - exp(-x)) / x, 1 at x = 0 and 0 at infinity.
    const double mean = x > 0 ? (std::isinf(x) ? 0 : -std::expm1(-x) / x) : 1;
    step.change.push_back(term.share * mean);
    step.now += step.change.back() - term.share;
  }
  return step;
}

double history_of(const MemoryStep& step, const ExponentialMemory& memory) {
  double sum = 0;
  // Sum  h_i = decay_i H_i - change_i x_old,  where an empty memory has H_i = 0.
  for (std::size_t i = 0; i < step.decay.size(); ++i)
    sum += (memory.terms.empty() ? 0 : step.decay[i] * memory.terms[i]) - step.change[i] * memory.x;
  return sum;
}

double remember(const MemoryStep& step, double x_new, ExponentialMemory& memory) {
  memory.terms.resize(step.decay.size(), 0);
  // Compute y before the terms advance.
  const double y = step.now * x_new + history_of(step, memory);
  for (std::size_t i = 0; i < step.decay.size(); ++i)
    memory.terms[i] = step.decay[i] * memory.terms[i] + step.change[i] * (x_new - memory.x);
  memory.x = x_new;
  return y;
}

void check_exponential_terms(const std::vector<ExponentialTerm>& terms, const char* what) {
  double sum = 0;
  for (const ExponentialTerm& term : terms) {
    require(term.share >= 0 && term.time > 0 && std::isfinite(term.time),
            "relaxation of {} needs shares of 0 and more and times above 0, got {} and {} s", what,
            term.share, term.time);
    sum += term.share;
  }
  require(sum < 1, "shares of relaxation of {} must sum to less than 1, got {}", what, sum);
}

}  // namespace thenar
