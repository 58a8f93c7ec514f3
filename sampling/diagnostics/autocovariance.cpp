#include "sampling/diagnostics/autocovariance.h"

#include <unsupported/Eigen/FFT>

#include "base/error.h"

namespace thenar {
namespace {

constexpr Eigen::Index kLagsWithoutFft =
    100;  // number of lags below which direct sums are cheaper than an FFT

/// Computes the sums over all lags by FFT.
Eigen::VectorXd sum_by_fft(const Eigen::VectorXd& centred) {
  // Pad with zeros to avoid circular wrap-around.
  const Eigen::Index n = centred.size();
  Eigen::Index length = 4;  // minimum length of Eigen's real transform
  while (length < 2 * n) length *= 2;
  Eigen::VectorXd padded = Eigen::VectorXd::Zero(length);
  padded.head(n) = centred;

  // The squared magnitude of the spectrum is the transform of the autocovariance.
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
  // Use the FFT for many lags.
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
