// Tests for studies/thumb/thumb_calibration.cpp: THENAR_SBC=N simulates N thumbs instead of 24,
// and orthogonal ones as well.

#include "studies/thumb/thumb_calibration.h"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/studies/thumb/study_inputs.h"

namespace thenar {
namespace {

ThumbCalibrationSettings settings_of(bool skewed) {
  ThumbCalibrationSettings settings;
  settings.thumb.skewed = skewed;
  const char* asked = std::getenv("THENAR_SBC");
  settings.simulations = asked != nullptr ? std::atoi(asked) : 24;
  if (asked == nullptr) {  // quick: ranks of short chains, most of which agree to 1.02 alone
    settings.draws = settings.warm_up = 250;
    settings.retries = 0;
  }
  return settings;
}

void expect_calibrated(const ThumbCalibration& calibration) {
  for (const std::string& reason : calibration.judged.warnings) ADD_FAILURE() << reason;
  EXPECT_NEAR(calibration.covered, 0.9, 4 * calibration.covered_error);
  if (std::getenv("THENAR_SBC") == nullptr) return;
  double least_band = 1, least_chi = 1;
  for (const ParameterCalibration& parameter : calibration.judged.parameters) {
    fmt::print("  {:<28} band p {:.3f}  chi-square {:6.1f} p {:.3f} {}\n", parameter.name,
               parameter.band_p, parameter.chi_square, parameter.chi_square_p, parameter.shape);
    least_band = std::min(least_band, parameter.band_p);
    least_chi = std::min(least_chi, parameter.chi_square_p);
  }
  fmt::print(
      "{} simulations, {} not converged; least p {:.4f} (band) {:.4f} (chi-square) of {} "
      "each; 90 % intervals hold {:.4f} +- {:.4f}\n",
      calibration.rank.cols(), calibration.not_converged, least_band, least_chi,
      calibration.names.size(), calibration.covered, calibration.covered_error);
}

// Truths from the prior rank uniformly among draws of their posteriors.
TEST(ThumbCalibration, SkewedThumbIsCalibrated) {
  const ThumbCalibration calibration = calibrate_thumb(sample::study_inputs(), settings_of(true));
  EXPECT_EQ(calibration.names.size(), 22U);
  expect_calibrated(calibration);
}

TEST(ThumbCalibration, OrthogonalThumbIsCalibrated) {
  if (std::getenv("THENAR_SBC") == nullptr) GTEST_SKIP() << "asks for THENAR_SBC=N";
  const ThumbCalibration calibration = calibrate_thumb(sample::study_inputs(), settings_of(false));
  EXPECT_EQ(calibration.names.size(), 16U);
  expect_calibrated(calibration);
}

}  // namespace
}  // namespace thenar
