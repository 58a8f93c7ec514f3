#pragma once

/// Convolution with a sum of decaying exponentials, one exact step at a time.

#include <vector>

namespace thenar {

/// One exponential term of a relaxation function.
struct ExponentialTerm {
  double share = 0;  // g_i, share of the instantaneous response [1]
  double time = 1;   // tau_i, time constant [s]
};

/// Weights of one step of  y(t) = integral of g(t - s) dx(s),  g(t) = g_inf + sum g_i exp(-t /
/// tau_i),  g(0) = 1, exact if x is linear in time:
///   y = now x_new + history,  history = sum h_i,
///   h_i = decay_i H_i - change_i x_old,   H_i' = h_i + change_i x_new.
/// Source: [Simo1998] sec. 10.3.
struct MemoryStep {
  double now = 1;                     // g_inf + sum change_i [1]
  std::vector<double> decay, change;  // exp(-h/tau_i), g_i (1 - exp(-h/tau_i)) tau_i / h (terms)
};

/// Computes the weights of a step.
/// @param h  duration of the step [s], >= 0; 0: instantaneous; infinity: fully relaxed
[[nodiscard]] MemoryStep memory_step(const std::vector<ExponentialTerm>& terms, double h);

/// State of an exponential memory: the last x and its history terms.
struct ExponentialMemory {
  double x = 0;               // x at the last step
  std::vector<double> terms;  // H_i; empty: all zero (terms)
};

/// Returns `history` of a step, which does not depend on x_new.
[[nodiscard]] double history_of(const MemoryStep& step, const ExponentialMemory& memory);
/// Advances the memory to x_new. @return y
double remember(const MemoryStep& step, double x_new, ExponentialMemory& memory);

/// Checks relaxation terms.
/// @param what  owner of the terms, for messages
/// @throws InputError unless shares are not negative and sum to less than 1, and times are positive
///         and finite.
void check_exponential_terms(const std::vector<ExponentialTerm>& terms, const char* what);

}  // namespace thenar
