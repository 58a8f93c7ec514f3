// Tests for tendons/net/net_statics.cpp and net_derivatives.cpp.

#include "tendons/net/net_statics.h"

#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>

#include "base/error.h"
#include "tendons/net/net_derivatives.h"
#include "tendons/net/net_tendons.h"
#include "tests/matrix_near.h"
#include "tests/tendons/net/net_derivatives.h"
#include "tests/tendons/net/sample_nets.h"

namespace thenar {
namespace {

using Eigen::VectorXd;

/// Solves from `start`, or from the links, tightly: differences are taken of the results.
NetEquilibrium rest_of(const SampleNet& sample, const Eigen::Matrix3Xd* start = nullptr) {
  NetSolverOptions options;
  options.tolerance = 1e-12;
  options.max_iterations = 60;
  NetEquilibrium rest = NetSolver(sample.net, options).solve(sample.state(), sample.drive, start);
  // Where rounding ends above that, the promised tolerance must do.
  if (rest.status == NetStatus::kStalled && rest.residual < 1e-10 && rest.length.minCoeff() > 1e-4)
    rest.status = NetStatus::kBalanced;
  return rest;
}

/// Derivative of f at 0 by Richardson's differences, exact to h^4.
template <typename F>
auto slope_of(const F& f, double h) {
  return ((8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h)).eval();
}

/// Random nets that are well held: balanced, not about to change which bands are slack, and no
/// stiffer than 2e5 N/m.
std::vector<SampleNet> held_nets(bool bones, int count) {
  std::vector<SampleNet> held;
  for (unsigned seed = 1; static_cast<int>(held.size()) < count; ++seed) {
    std::mt19937 rng(seed);
    RandomNetOptions options;
    options.bones = bones;
    options.max_free = 5;
    SampleNet sample = random_net(rng, options);
    const NetEquilibrium rest = rest_of(sample);
    bool clear = rest.status == NetStatus::kBalanced && rest.undetermined.empty();
    if (bones) clear = clear && !rest.contacts.empty();
    for (const NetContact& c : rest.contacts) clear = clear && std::abs(c.force) > 1e-2;
    // Lengths over bones are known to 1e-14 m: stiffer bands make more than rounding of it.
    for (const NetBand& band : sample.net.bands) clear = clear && band.EA < 2e5 * band.slack;
    for (Eigen::Index b = 0; b < rest.length.size(); ++b) {
      const NetBand& band = sample.net.bands[static_cast<std::size_t>(b)];
      const double strain = rest.length(b) / band.slack - 1;
      if (band.muscle < 0)
        clear = clear && std::abs(strain) > 2e-3 && std::abs(strain - band.toe) > 2e-3;
    }
    if (clear) held.push_back(std::move(sample));
  }
  return held;
}

// tau = -dE*/dq: the minimised energy knows nothing of contact forces or wrenches.
TEST(NetTorque, IsMinusTheSlopeOfTheMinimisedEnergy) {
  for (bool bones : {false, true})
    for (const SampleNet& sample : held_nets(bones, 4)) {
      const NetEquilibrium rest = rest_of(sample);
      const VectorXd tau =
          net_torque(sample.net, sample.tree, sample.state(), rest, sample.coordinates());
      for (int l = 0; l < sample.coordinates(); ++l) {
        const auto energy = [&](double dq) {
          SampleNet moved = sample;
          moved.q(l) += dq;
          return VectorXd::Constant(1, rest_of(moved, &rest.x).energy);
        };
        const double slope = slope_of(energy, 2e-4)(0);
        EXPECT_NEAR(tau(l), -slope, 1e-9 * std::abs(slope) + 2e-10);  // [N m]
      }
    }
}

TEST(NetWrenches, SumToZeroOverAllLinks) {
  for (bool bones : {false, true})
    for (const SampleNet& sample : held_nets(bones, 4)) {
      Wrench sum;
      for (const LinkWrench& w : net_wrenches(sample.net, sample.state(), rest_of(sample)))
        sum += w.wrench;
      // Each of at most 5 free nodes, within 0.1 m of the origin, is balanced to 1e-10 N.
      EXPECT_LT(sum.force.norm(), 5e-10);   // [N]
      EXPECT_LT(sum.moment.norm(), 5e-11);  // [N m]
    }
}

/// What follows an input, each of its own unit.
struct Followers {
  VectorXd x, tension, tau;  // [m], [N], [N m]; as slopes, each by the input's unit
  Followers operator+(const Followers& o) const {
    return {x + o.x, tension + o.tension, tau + o.tau};
  }
  Followers operator-(const Followers& o) const {
    return {x - o.x, tension - o.tension, tau - o.tau};
  }
  Followers operator*(double c) const { return {c * x, c * tension, c * tau}; }
};

Followers followers(const SampleNet& sample, const NetEquilibrium& rest) {
  return {Eigen::Map<const VectorXd>(rest.x.data(), rest.x.size()), rest.tension,
          net_torque(sample.net, sample.tree, sample.state(), rest, sample.coordinates())};
}

/// StaticsRounding of solutions over a step of 1: places to 1e-14 m, forces of bands that are that
/// much longer, 1000 N for 1 cm, and their torques at arms of 1 cm; differences take 1.5 of each.
struct StaticsRounding {
  double x = 1e-14, tension = 1e-9, tau = 1e-11;
};

/// Differences of solutions against one column of slopes.
template <typename Change>
void expect_slope(const SampleNet& sample, const NetEquilibrium& rest, const NetJacobian& slopes,
                  Eigen::Index i, double h, const Change& change) {
  const auto at = [&](double by) {
    SampleNet moved = sample;
    change(moved, by);
    return followers(moved, rest_of(moved, &rest.x));
  };
  const Followers slope = ((at(h) - at(-h)) * 8 - (at(2 * h) - at(-2 * h))) * (1 / (12 * h));
  const auto near = [&](const char* what, const auto& got, const VectorXd& expected,
                        double rounding) {
    EXPECT_TRUE(
        matrix_near(got, expected, 2e-6 * expected.cwiseAbs().maxCoeff() + 1.5 * rounding / h))
        << what;
  };
  const StaticsRounding digits;
  near("x", slopes.x.col(i), slope.x, digits.x);
  near("tension", slopes.tension.col(i), slope.tension, digits.tension);
  near("tau", slopes.tau.col(i), slope.tau, digits.tau);
}

class NetDerivativesOf : public testing::TestWithParam<bool> {};

TEST_P(NetDerivativesOf, PostureMatchDifferences) {
  for (const SampleNet& sample : held_nets(GetParam(), 4)) {
    const NetEquilibrium rest = rest_of(sample);
    const NetDerivatives d = net_derivatives(sample.net, sample.tree, sample.state(), sample.drive,
                                             rest, sample.coordinates());
    for (int l = 0; l < sample.coordinates(); ++l)
      expect_slope(sample, rest, d.by_posture, l, 1e-4,
                   [l](SampleNet& moved, double by) { moved.q(l) += by; });
  }
}

TEST_P(NetDerivativesOf, DriveMatchDifferences) {
  for (const SampleNet& sample : held_nets(GetParam(), 4)) {
    const NetEquilibrium rest = rest_of(sample);
    const NetDerivatives d = net_derivatives(sample.net, sample.tree, sample.state(), sample.drive,
                                             rest, sample.coordinates());
    for (Eigen::Index m = 0; m < sample.drive.tension.size(); ++m) {
      const bool by_length = std::isfinite(sample.drive.length(m));
      if (!by_length && sample.drive.tension(m) == 0) continue;  // a tension cannot fall below zero
      expect_slope(sample, rest, d.by_drive, m, by_length ? 1e-7 : 1e-4 * sample.drive.tension(m),
                   [m](SampleNet& moved, double by) {
                     double& t = moved.drive.tension(m);
                     double& length = moved.drive.length(m);
                     (std::isfinite(length) ? length : t) += by;
                   });
    }
  }
}

TEST_P(NetDerivativesOf, BandsMatchDifferences) {
  for (const SampleNet& sample : held_nets(GetParam(), 2)) {
    const NetEquilibrium rest = rest_of(sample);
    const NetDerivatives d = net_derivatives(sample.net, sample.tree, sample.state(), sample.drive,
                                             rest, sample.coordinates());
    for (std::size_t b = 0; b < sample.net.bands.size(); ++b) {
      const auto i = static_cast<Eigen::Index>(b);
      expect_slope(sample, rest, d.by_EA, i, 1e-4 * sample.net.bands[b].EA,
                   [b](SampleNet& moved, double by) { moved.net.bands[b].EA += by; });
      if (sample.net.bands[b].muscle < 0)
        expect_slope(sample, rest, d.by_slack, i, 1e-7,
                     [b](SampleNet& moved, double by) { moved.net.bands[b].slack += by; });
    }
  }
}

TEST_P(NetDerivativesOf, PlacesMatchDifferences) {
  for (const SampleNet& sample : held_nets(GetParam(), 3)) {
    const NetEquilibrium rest = rest_of(sample);
    const TreeState<double> state = sample.state();
    const NetDerivatives d =
        net_derivatives(sample.net, sample.tree, state, sample.drive, rest, sample.coordinates());
    for (std::size_t i = 0; i < sample.net.nodes.size(); ++i) {
      const NetNode& node = sample.net.nodes[i];
      const auto first = static_cast<Eigen::Index>(3 * i);
      if (node.free) {
        EXPECT_EQ(d.by_place.tau.middleCols(first, 3).norm(), 0);
        continue;
      }
      for (Eigen::Index c = 0; c < 3; ++c) {
        Eigen::Vector3d along = Eigen::Vector3d::Unit(c);
        if (node.link >= 0)
          along = state[static_cast<std::size_t>(node.link)].X.R.transpose() * along;
        expect_slope(sample, rest, d.by_place, first + c, 2e-6,
                     [&](SampleNet& moved, double by) { moved.net.nodes[i].p += by * along; });
      }
    }
  }
}

// Bands that bend over a bone, and nodes that rest on it, give way to it as it thickens.
TEST(NetDerivatives, RadiiMatchDifferences) {
  int moved_by_radius = 0;
  for (const SampleNet& sample : held_nets(true, 12)) {
    const NetEquilibrium rest = rest_of(sample);
    // A band that ends inside the bone it bends over has no length of its own there.
    if (net_status(sample.net, sample.state(), rest) == TendonStatus::kBandInsideBone) continue;
    const NetDerivatives d = net_derivatives(sample.net, sample.tree, sample.state(), sample.drive,
                                             rest, sample.coordinates());
    for (std::size_t s = 0; s < sample.net.surfaces.size(); ++s) {
      const SurfaceShape shape = sample.net.surfaces[s].shape;
      if (shape == SurfaceShape::kEllipsoid || shape == SurfaceShape::kTorus) continue;
      const auto i = static_cast<Eigen::Index>(s);
      expect_slope(sample, rest, d.by_radius, i, 1e-6,
                   [s](SampleNet& moved, double by) { moved.net.surfaces[s].size[0] += by; });
      moved_by_radius += d.by_radius.tau.col(i).norm() > 0 ? 1 : 0;
    }
  }
  EXPECT_GE(moved_by_radius, 4);
}

TEST_P(NetDerivativesOf, LengthByPostureMatchesDifferences) {
  for (const SampleNet& sample : held_nets(GetParam(), 4)) {
    const NetEquilibrium rest = rest_of(sample);
    const Eigen::MatrixXd slopes = length_by_posture(sample.net, sample.tree, sample.state(),
                                                     sample.drive, rest, {sample.coordinates()});
    for (int l = 0; l < sample.coordinates(); ++l) {
      const auto length = [&](double dq) {
        SampleNet moved = sample;
        moved.q(l) += dq;
        return rest_of(moved, &rest.x).length;
      };
      EXPECT_TRUE(matrix_near(slopes.col(l), slope_of(length, 1e-4),
                              2e-6 * slopes.cwiseAbs().maxCoeff() + 1e-9));
    }
  }
}

// By solving anew under another tension; a second derivative of min E, so symmetric and not
// positive.
TEST_P(NetDerivativesOf, PulledLengthByDriveMatchesDifferences) {
  for (const SampleNet& sample : held_nets(GetParam(), 4)) {
    if ((sample.drive.length.array().isFinite()).any()) continue;
    const NetEquilibrium rest = rest_of(sample);
    const Eigen::MatrixXd slopes =
        muscle_compliance(sample.net, sample.state(), sample.drive, rest);
    const double size = slopes.cwiseAbs().maxCoeff();
    EXPECT_TRUE(matrix_near(slopes, slopes.transpose(), 1e-9 * size));
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(slopes);
    EXPECT_LE(eigen.eigenvalues().maxCoeff(), 1e-9 * size);
    for (Eigen::Index m = 0; m < slopes.cols(); ++m) {
      if (sample.drive.tension(m) == 0) continue;
      const auto pulled = [&](double by) {
        SampleNet moved = sample;
        moved.drive.tension(m) += by;
        const VectorXd length = rest_of(moved, &rest.x).length;
        VectorXd out = VectorXd::Zero(slopes.rows());
        for (std::size_t b = 0; b < moved.net.bands.size(); ++b)
          if (moved.net.bands[b].muscle >= 0)
            out[moved.net.bands[b].muscle] += length[static_cast<Eigen::Index>(b)];
        return out;
      };
      EXPECT_TRUE(matrix_near(slopes.col(m), slope_of(pulled, 1e-3 * sample.drive.tension(m)),
                              1e-5 * size + 1e-12));
    }
  }
}

// d tau/dt by how lengths follow the posture is d tau/dt by how nodes follow the tension.
TEST_P(NetDerivativesOf, TorqueByDriveIsReciprocal) {
  for (const SampleNet& sample : held_nets(GetParam(), 8)) {
    const NetEquilibrium rest = rest_of(sample);
    const Eigen::MatrixXd forward = net_derivatives(sample.net, sample.tree, sample.state(),
                                                    sample.drive, rest, sample.coordinates())
                                        .by_drive.tau;
    EXPECT_TRUE(matrix_near(torque_by_drive(sample.net, sample.tree, sample.state(), sample.drive,
                                            rest, sample.coordinates()),
                            forward, 1e-9 * std::max(1.0, forward.norm())));
  }
}

INSTANTIATE_TEST_SUITE_P(BonesOrNone, NetDerivativesOf, testing::Bool());

TEST(NetDerivatives, RefuseANetThatIsNotBalancedOrAtASaddle) {
  const SampleNet sample = sample_net_on_bone(6, 12);
  NetEquilibrium rest = rest_of(sample);
  EXPECT_EQ(why_not_differentiable(sample.net, rest), "");
  for (NetStatus status : {NetStatus::kStalled, NetStatus::kFarSideWrap, NetStatus::kUnstable}) {
    rest.status = status;
    EXPECT_NE(why_not_differentiable(sample.net, rest), "");
    EXPECT_THROW(
        (void)net_derivatives(sample.net, sample.tree, sample.state(), sample.drive, rest, 1),
        InputError);
    EXPECT_THROW(
        (void)torque_by_drive(sample.net, sample.tree, sample.state(), sample.drive, rest, 1),
        InputError);
  }
}

/// Random nets in which a muscle has collapsed a node into its exit, well held otherwise.
std::vector<SampleNet> drawn_nets(int count) {
  std::vector<SampleNet> collapsed;
  for (unsigned seed = 1; static_cast<int>(collapsed.size()) < count; ++seed) {
    std::mt19937 rng(seed);
    RandomNetOptions options;
    options.max_free = 5;
    options.weak = 1;
    SampleNet sample = random_net(rng, options);
    const NetEquilibrium rest = rest_of(sample);
    bool clear = rest.status == NetStatus::kNodeCollapsed && rest.undetermined.empty() &&
                 why_not_differentiable(sample.net, rest).empty();
    for (Eigen::Index b = 0; b < rest.length.size(); ++b) {
      const NetBand& band = sample.net.bands[static_cast<std::size_t>(b)];
      const double strain = rest.length(b) / band.slack - 1;
      if (band.muscle < 0)
        clear = clear && std::abs(strain) > 2e-3 && std::abs(strain - band.toe) > 2e-3;
    }
    for (const CollapsedBand& held : rest.collapsed)  // neither let go nor just caught
      clear = clear && held.force.norm() <
                           0.9 * sample.drive.tension(
                                     sample.net.bands[static_cast<std::size_t>(held.band)].muscle);
    if (clear) collapsed.push_back(std::move(sample));
  }
  return collapsed;
}

/// tau by solving anew after a change.
template <typename Change>
VectorXd torque_after(const SampleNet& sample, const NetEquilibrium& rest, const Change& change) {
  SampleNet moved = sample;
  change(moved);
  return net_torque(moved.net, moved.tree, moved.state(), rest_of(moved, &rest.x),
                    moved.coordinates());
}

// A node in its exit rides on it: its muscle may pull harder, and nothing else changes.
TEST(NetDerivatives, OfADrawnInNetMatchDifferences) {
  for (const SampleNet& sample : drawn_nets(4)) {
    const NetEquilibrium rest = rest_of(sample);
    const int n = sample.coordinates();
    const Eigen::MatrixXd by_drive =
        torque_by_drive(sample.net, sample.tree, sample.state(), sample.drive, rest, n);
    const NetDerivatives d =
        net_derivatives(sample.net, sample.tree, sample.state(), sample.drive, rest, n);
    for (Eigen::Index m = 0; m < sample.drive.tension.size(); ++m) {
      const double t = sample.drive.tension(m);
      if (std::isfinite(sample.drive.length(m)) || t == 0) continue;
      const VectorXd expected = slope_of(
          [&](double by) {
            return torque_after(sample, rest, [&](SampleNet& s) { s.drive.tension(m) += by; });
          },
          1e-4 * t);
      EXPECT_TRUE(matrix_near(by_drive.col(m), expected, 1e-8));  // [m/rad]
      EXPECT_TRUE(matrix_near(d.by_drive.tau.col(m), expected, 1e-8));
    }
    for (int l = 0; l < n; ++l) {
      const VectorXd expected = slope_of(
          [&](double by) {
            return torque_after(sample, rest, [&](SampleNet& s) { s.q(l) += by; });
          },
          1e-4);
      EXPECT_TRUE(matrix_near(d.by_posture.tau.col(l), expected,
                              2e-6 * expected.cwiseAbs().maxCoeff() + 1e-9));  // [N m/rad]
    }
  }
}

// Two bands of length L at +-60 degrees hold a node a few micrometres before the exit of its
// muscle, nearer than where the solver takes a spring for the pull. By hand, dx/dt = 1 / K with
//   K = 2 (EA / s cos^2 60 + T / L sin^2 60).
TEST(NetDerivatives, OfAMuscleOfAFewMicrometresAreThoseOfItsPull) {
  constexpr double kShort = 3e-6, L = 0.02, EA = 200, t = 3;  // [m], [m], [N], [N]
  const double c = 0.5, s = std::sqrt(0.75), slack = L / (1 + t / EA);
  Net net;
  net.name = "Y";
  add_node(net, true, -1, {0, 0, 0});
  add_node(net, false, -1, {kShort, 0, 0});
  add_node(net, false, -1, {-L * c, L * s, 0});
  add_node(net, false, -1, {-L * c, -L * s, 0});
  add_pull(net, 0, 1, 0);
  add_band(net, 0, 2, slack, EA);
  add_band(net, 0, 3, slack, EA);
  net.muscles = {"pull"};
  const NetDrive drive{VectorXd::Constant(1, t), {}};
  const NetEquilibrium rest = NetSolver(net).solve({}, drive);
  ASSERT_EQ(rest.status, NetStatus::kBalanced);
  ASSERT_NEAR(rest.length(0), kShort, 1e-9);
  const NetDerivatives d = net_derivatives(net, {}, {}, drive, rest, 0);
  const double K = 2 * (EA / slack * c * c + t / L * s * s);
  EXPECT_NEAR(d.by_drive.x(0, 0), 1 / K, 1e-6 / K);
  EXPECT_NEAR(d.by_drive.tension(0, 0), 1, 1e-12);
  EXPECT_NEAR(d.by_drive.tension(1, 0), EA / slack * c / K, 1e-6);
}

}  // namespace
}  // namespace thenar
