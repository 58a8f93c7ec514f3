#include "sampling/diagnostics/autocovariance.h"

#include <unsupported/Eigen/FFT>

#include "base/error.h"

namespace thenar {
namespace {

constexpr Eigen::Index kLagsWithoutFft = 100;  // Fewer lags are cheaper one by one than by FFT

Eigen::VectorXd sum_by_fft(const Eigen::VectorXd& centred) {
  // Zeros behind the series keep its end from meeting its beginning.
  const Eigen::Index n = centred.size();
  Eigen::Index length = 4;  // the least that Eigen's real transform takes
  while (length < 2 * n) length *= 2;
  Eigen::VectorXd padded = Eigen::VectorXd::Zero(length);
  padded.head(n) = centred;

  // The spectrum's squared size is the transform of the autocovariance.
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  Eigen::VectorXcd spectrum;
  fft.fwd(spectrum, padded);
  spectrum = spectrum.cwiseAbs2().cast<std::complex<double>>().eval();
  fft.inv(padded, spectrum, length);
  return padded.head(n);
}

}  // namespace

Eigen::VectorXd autocovariance(const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Index lags) {
  const Eigen::Index n = x.size();
  require(lags >= 0 && lags <= n, "a chain of {} draws has no {} lags", n, lags);
  if (lags == 0) return {};
  // Many lags by FFT, few by sums.
  const Eigen::VectorXd centred = x.array() - x.mean();
  if (lags > kLagsWithoutFft) return sum_by_fft(centred).head(lags) / double(n);
  return Eigen::VectorXd::NullaryExpr(lags, [&](Eigen::Index t) {
    return centred.head(n - t).dot(centred.tail(n - t)) / double(n);
  });
}

Eigen::VectorXd autocovariance(const Eigen::Ref<const Eigen::VectorXd>& x) {
  return autocovariance(x, x.size());
}

}  // namespace thenar
