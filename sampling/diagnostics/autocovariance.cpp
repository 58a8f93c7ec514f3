#include "sampling/diagnostics/autocovariance.h"

#include <unsupported/Eigen/FFT>

namespace thenar {

Eigen::VectorXd autocovariance(const Eigen::Ref<const Eigen::VectorXd>& x) {
  const Eigen::Index n = x.size();
  if (n == 0) return {};

  // Zeros behind the series keep its end from meeting its beginning.
  Eigen::Index length = 4;  // the least that Eigen's real transform takes
  while (length < 2 * n) length *= 2;
  Eigen::VectorXd padded = Eigen::VectorXd::Zero(length);
  padded.head(n) = x.array() - x.mean();

  // The spectrum's squared size is the transform of the autocovariance.
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  Eigen::VectorXcd spectrum;
  fft.fwd(spectrum, padded);
  spectrum = spectrum.cwiseAbs2().cast<std::complex<double>>().eval();
  fft.inv(padded, spectrum, length);
  return padded.head(n) / double(n);
}

}  // namespace thenar
