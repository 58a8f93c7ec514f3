#include "tendons/muscle/activation.h"

namespace thenar {

double activation_rate(double excitation, double activation, const ActivationTimes& times) {
  const double level = 0.5 + 1.5 * activation;
  const double lag = excitation > activation ? times.rise * level : times.fall / level;
  return (excitation - activation) / lag;
}

}  // namespace thenar
