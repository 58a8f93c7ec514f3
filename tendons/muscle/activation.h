#pragma once

/// How fast a muscle follows its excitation.

namespace thenar {

/// Time constants of activation, of young adults. Source: [Thelen2003].
struct ActivationTimes {
  double rise = 0.015;  // [s]
  double fall = 0.050;  // [s]
};

/// Rate of activation a under excitation e:
///   a' = (e - a) / (rise (0.5 + 1.5 a))   where e > a,
///   a' = (e - a) (0.5 + 1.5 a) / fall     elsewhere.
/// Keeps a within the range of e, so within 0..1. Source: [Thelen2003].
/// @return [1/s]
[[nodiscard]] double activation_rate(double excitation, double activation,
                                     const ActivationTimes& times);

/// d activation_rate / d activation [1/s]; at a = e, where it has a corner, that of falling.
[[nodiscard]] double activation_rate_slope(double excitation, double activation,
                                           const ActivationTimes& times);

}  // namespace thenar
