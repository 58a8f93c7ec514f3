#pragma once

/// Convolution with a sum of decaying exponentials, one exact step at a time.

#include <vector>

namespace thenar {

/// One exponential of a memory.
struct ExponentialTerm {
  double share = 0;  // g_i, of the instantaneous answer [1]
  double time = 1;   // tau_i [s]
};

/// Weights of one step of  y(t) = integral of g(t - s) dx(s),  g(t) = g_inf + sum g_i exp(-t /
/// tau_i),  g(0) = 1, exact where x runs straight in time:
///   y = now x_new + history,  history = sum h_i,
///   h_i = decay_i H_i - change_i x_old,   H_i' = h_i + change_i x_new.
/// Source: [Simo1998] sec. 10.3.
struct MemoryStep {
  double now = 1;                     // g_inf + sum change_i [1]
  std::vector<double> decay, change;  // exp(-h/tau_i), g_i (1 - exp(-h/tau_i)) tau_i / h (terms)
};

/// @param h  step [s], >= 0; 0: instantaneous; infinity: all has decayed
[[nodiscard]] MemoryStep memory_step(const std::vector<ExponentialTerm>& terms, double h);

/// State of an exponential memory: the last x and its history terms.
struct ExponentialMemory {
  double x = 0;               // at the last step
  std::vector<double> terms;  // H_i; empty: all zero (terms)
};

/// Returns `history` of a step, before x_new is known.
[[nodiscard]] double history_of(const MemoryStep& step, const ExponentialMemory& memory);
/// Advances the memory to x_new. @return y
double remember(const MemoryStep& step, double x_new, ExponentialMemory& memory);

/// @throws InputError unless shares are not negative and sum to less than 1, and times are positive
/// and finite. @param what  has the terms, in messages
void check_exponential_terms(const std::vector<ExponentialTerm>& terms, const char* what);

}  // namespace thenar
