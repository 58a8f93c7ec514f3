// Tests for posterior/run/posterior_axes.cpp: offsets of axes from the draws of their tilts and
// shifts, written anew.

#include "posterior/run/posterior_axes.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/spatial.h"
#include "base/units.h"
#include "posterior/hand_posterior.h"
#include "posterior/run/posterior_quantities.h"
#include "tests/posterior/run/small_run.h"

namespace thenar {
namespace {

/// The axes of MCP flexion and abduction tilt and shift; those of PIP and DIP stand still.
const PosteriorRun& skewed() {
  static const PosteriorRun run = [] {
    FitInputs inputs = sample::small_inputs();
    inputs.settings.text =
        "source = 'Synek2019'\n"
        "[[parameter]]\nmatch = 'axis/MCP3_*/direction/*'\nstate = 'free'\nsd_deg = 8\n"
        "[[parameter]]\nmatch = 'axis/MCP3_*/point/*'\nstate = 'free'\nsd_mm = 3\n";
    return sample_posterior(inputs, sample::quick_settings(100));
  }();
  return run;
}

const PosteriorQuantity* find(const std::vector<PosteriorQuantity>& all, const std::string& name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& q) { return q.name == name; });
  return found == all.end() ? nullptr : &*found;
}

/// Axis of a joint at draw k of all chains together: point and unit direction, from its tilts
/// [deg] and shifts [mm].
Hinge<double> axis_at(const std::vector<PosteriorQuantity>& all, const TendonDigit& digit,
                      const std::string& joint, Eigen::Index k) {
  const auto& hinges = digit.names.hinges;
  Hinge<double> hinge = digit.model.tree[static_cast<std::size_t>(
      std::find(hinges.begin(), hinges.end(), joint) - hinges.begin())];
  const Tangents e = tangents(hinge.direction);
  const auto value = [&](const std::string& of) {
    const PosteriorQuantity* q = find(all, "axis/" + joint + of);
    return q == nullptr ? 0 : q->draws.reshaped()[k];
  };
  hinge.point += 1e-3 * (value("/point/1") * e.e1 + value("/point/2") * e.e2 +
                         value("/point/along") * hinge.direction);
  hinge.direction += radians(value("/direction/1")) * e.e1 + radians(value("/direction/2")) * e.e2;
  hinge.direction.normalize();
  return hinge;
}

TEST(PosteriorAxes, AreThoseOfTiltsAndShifts) {
  const PosteriorRun& run = skewed();
  const TendonDigit& digit = run.posterior->problem().digit();
  const std::vector<PosteriorQuantity> all = posterior_quantities(run, 2);
  const std::vector<PosteriorAxes> found = posterior_axes(run);
  const auto mcp = std::find_if(found.begin(), found.end(), [](const auto& of) {
    return of.axes.name == "MCP3_FE-MCP3_AA" || of.axes.name == "MCP3_AA-MCP3_FE";
  });
  ASSERT_NE(mcp, found.end());
  EXPECT_EQ(mcp->whose, "");
  // Means over all draws, from lines and cross products.
  const Eigen::Index draws = run.draws.draws() * run.draws.chains();
  const std::string& name = mcp->axes.name;
  const Eigen::Vector3d distal = -digit.model.tip_axes.col(0);
  double angle = 0, distance = 0, beyond = 0, distal_draws = 0;
  for (Eigen::Index k = 0; k < draws; ++k) {
    const Hinge<double> first = axis_at(all, digit, name.substr(0, 7), k);
    const Hinge<double> second = axis_at(all, digit, name.substr(8), k);
    const Eigen::Vector3d n = first.direction.cross(second.direction).normalized();
    const double along = n.dot(second.point - first.point);
    angle += degrees(std::acos(std::abs(first.direction.dot(second.direction))));
    distance += 1e3 * std::abs(along);
    beyond += 1e3 * along * n.dot(distal);
    distal_draws += along * n.dot(distal) > 0 ? 1 : 0;
  }
  const auto count = static_cast<double>(draws);
  EXPECT_NEAR(mcp->angle.mean, angle / count, 1e-9);
  EXPECT_NEAR(mcp->distance.mean, distance / count, 1e-9);
  EXPECT_NEAR(mcp->beyond.mean, beyond / count, 1e-9);
  EXPECT_DOUBLE_EQ(mcp->second_distal, distal_draws / count);
}

// The finger's MCP axes meet, and tilts and shifts are as likely to either side beforehand.
TEST(PosteriorAxes, AreAsLikelyInEitherOrderBeforehand) {
  for (const PosteriorAxes& of : posterior_axes(skewed(), 4000)) {
    if (of.axes.name.find("PIP") != std::string::npos) {
      EXPECT_EQ(of.second_distal_prior, 1) << of.axes.name;  // a phalanx lies between them
    } else {
      EXPECT_NEAR(of.second_distal_prior, 0.5, 4 * 0.5 / std::sqrt(4000)) << of.axes.name;
    }
  }
}

TEST(PosteriorAxes, LeaveOutAxesThatStandStill) {
  for (const PosteriorAxes& of : posterior_axes(skewed()))
    EXPECT_EQ(of.axes.name.find("DIP"), std::string::npos) << of.axes.name;
  EXPECT_TRUE(posterior_axes(sample::sampled()).empty());
}

}  // namespace
}  // namespace thenar
