// Random nets without bones against the convex program of convex_oracle.h. THENAR_NETS sets how
// many, of 4 to 30 floating nodes, THENAR_FIRST_NET the first; the default is quick: smaller ones.

#include "tests/tendons/net/convex_oracle.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>

#include "tendons/net/solve_net.h"
#include "tests/tendons/net/sample_nets.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// A force of 1e-9 N on each of 30 nodes moves a net by (sqrt(30) 1e-9 N) / curvature, so by less
// than 1e-8 m along directions that are stiffer than 0.55 N/m. Along softer ones, down to those of
// loose nodes, a residual of 1e-9 N leaves the place open; so it does where nothing but bands below
// 1e-8 N are in the way, which a node may as well leave slack: their stiffness is not counted.
constexpr double kSoft = 1.0;    // [N/m]
constexpr double kApart = 1e-8;  // [m]

int first_net() {
  const char* wanted = std::getenv("THENAR_FIRST_NET");
  return wanted ? std::atoi(wanted) : 0;
}

const char* wanted_nets() { return std::getenv("THENAR_NETS"); }
int nets() { return wanted_nets() ? std::atoi(wanted_nets()) : 80; }

SampleNet sample_of(int seed) {
  std::mt19937 rng(static_cast<unsigned>(seed));
  RandomNetOptions options;
  if (!wanted_nets()) options.max_free = 8;
  options.all_slack = seed % 40 == 7;
  return random_net(rng, options);
}

/// How far a net at rest is off the minimum.
struct EnergyGap {
  double place = 0;    // along directions that are not soft [m]
  double tension = 0;  // [N]
  double energy = 0;   // [J]
  double way = 0;      // sum of all nodes' distances, soft directions too [m]
};

EnergyGap gap_of(const Net& net, const NetEquilibrium& rest, const oracle::Rest& exact) {
  EnergyGap gap;
  VectorXd d(exact.H.rows());
  for (Index i = 0; i < rest.x.cols(); ++i) {
    const Eigen::Vector3d off = rest.x.col(i) - exact.x.col(i);
    const int row = exact.row[static_cast<std::size_t>(i)];
    gap.way += off.norm();
    if (row >= 0)
      d.segment<3>(3 * row) = off;
    else  // in an exit, or fixed
      gap.place = std::max(gap.place, off.norm());
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(exact.H_sure);
  const VectorXd along = eigen.eigenvectors().transpose() * d;
  for (Index k = 0; k < along.size(); ++k)
    if (eigen.eigenvalues()(k) > kSoft) gap.place = std::max(gap.place, std::abs(along(k)));
  std::vector<bool> held(net.bands.size(), false);  // no length: its force is not its pull
  for (const CollapsedBand& collapsed : rest.collapsed)
    held[static_cast<std::size_t>(collapsed.band)] = true;
  for (Index b = 0; b < rest.tension.size(); ++b)
    if (!held[static_cast<std::size_t>(b)])
      gap.tension = std::max(gap.tension, std::abs(rest.tension(b) - exact.tension(b)));
  gap.energy = std::abs(rest.energy - exact.energy);
  return gap;
}

TEST(ConvexNets, RestWhereAnIndependentProgramSays) {
  int count[5] = {0, 0, 0, 0, 0}, unsure = 0;
  EnergyGap worst;
  for (int seed = first_net(); seed < first_net() + nets(); ++seed) {
    const SampleNet sample = sample_of(seed);
    const NetEquilibrium rest = NetSolver(sample.net).solve(sample.state(), sample.drive);
    ++count[static_cast<int>(rest.status)];
    const oracle::Rest exact = oracle::rest_of(sample.net, sample.state(), sample.drive);
    if (exact.residual > 1e-11) {
      ++unsure;
      std::printf("seed %d: oracle left %.2g N, status %d\n", seed, exact.residual,
                  static_cast<int>(rest.status));
      continue;
    }
    const EnergyGap gap = gap_of(sample.net, rest, exact);
    if (rest.status >= NetStatus::kStalled) {
      std::printf("seed %d: stalled with %.2g N, off by %.2g m\n", seed, rest.residual, gap.place);
      continue;
    }
    EXPECT_EQ(rest.status == NetStatus::kNodeCollapsed, exact.collapsed > 0) << "seed " << seed;
    EXPECT_LT(gap.place, kApart) << "seed " << seed;
    EXPECT_LT(gap.tension, 1e-6) << "seed " << seed;
    // E is convex and its slope is below 1e-9 N a node; rounding of a sum of 1e2 terms below 1 J.
    EXPECT_LT(gap.energy, 1e-9 * gap.way + 1e-14) << "seed " << seed;
    worst.place = std::max(worst.place, gap.place);
    worst.tension = std::max(worst.tension, gap.tension);
    worst.energy = std::max(worst.energy, gap.energy);
  }
  std::printf("balanced %d, unstable %d, drawn in %d, stalled %d, oracle unsure %d\n", count[0],
              count[1], count[2], count[3], unsure);
  std::printf("worst: place %.2g m, tension %.2g N, energy %.2g J\n", worst.place, worst.tension,
              worst.energy);
  EXPECT_EQ(count[static_cast<int>(NetStatus::kUnstable)], 0);
  EXPECT_EQ(count[static_cast<int>(NetStatus::kStalled)], 0);
  EXPECT_LE(unsure, nets() / 100);
}

}  // namespace
}  // namespace thenar
