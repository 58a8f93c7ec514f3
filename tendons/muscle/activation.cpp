#include "tendons/muscle/activation.h"

namespace thenar {

double activation_rate(double excitation, double activation, const ActivationTimes& times) {
  const double wanted = excitation - activation, speed = 0.5 + 1.5 * activation;
  return wanted > 0 ? wanted / (times.rise * speed) : wanted * speed / times.fall;
}

double activation_rate_slope(double excitation, double activation, const ActivationTimes& times) {
  const double wanted = excitation - activation, speed = 0.5 + 1.5 * activation;
  if (wanted > 0) return -(1 + 1.5 * wanted / speed) / (times.rise * speed);
  return (1.5 * wanted - speed) / times.fall;
}

}  // namespace thenar
