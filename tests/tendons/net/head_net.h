#pragma once

/// A net drawn over the head of a phalanx, where every way to bring it to rest meets what hoods do:
/// its nodes press on the bone, its ends bend over it, and some of its bands go slack.

#include <cmath>

#include "tests/tendons/net/sample_nets.h"

namespace thenar {

/// 15 floating nodes, three to a row, and 40 bands over a cylinder of radius 5 mm whose axis is
/// that of the joint, z; q[0] turns the next bone about it. In the order of bands: three muscles,
/// three slips to the next bone, fibres along (12), across (10), aslant (10) and two to the side of
/// the bone.
inline SampleNet net_over_head() {
  constexpr double kRadius = 0.005, kColumn = 0.004, kRow = 0.5;  // [m], [m], [rad]
  SampleNet sample;
  Net& net = sample.net;
  net.name = "over a head";
  sample.tree = {{-1, 0, 1, 0, {0, 0, -1}, {0, 0, 0}}};
  sample.q = Eigen::VectorXd::Constant(1, 0.6);
  net.surfaces = {{"head", -1, SurfaceShape::kCylinder, {kRadius, 0.008, 0}, {}}};
  const auto node = [&](int row, int column) { return 3 * row + column; };
  const auto place = [&](double radius, double angle, int column) {  // from dorsal, y, distally, x
    return Eigen::Vector3d(radius * std::sin(angle), radius * std::cos(angle),
                           kColumn * (column - 1));
  };
  for (int row = 0; row < 5; ++row)
    for (int column = 0; column < 3; ++column)
      add_node(net, true, -1, place(1.02 * kRadius, kRow * (row - 2), column), {0});

  const auto join = [&](int a, int b, double strain, double EA, int muscle = -1) {
    const double length = (net.nodes[a].p - net.nodes[b].p).norm();
    const int band = add_band(net, a, b, length / (1 + strain), EA, 0.02);
    net.bands[band].muscle = muscle;
    return band;
  };
  const auto bend = [&](int band) {
    net.bands[band].over = 0;
    net.bands[band].side = Eigen::Vector3d::UnitY();
  };
  for (int column = 0; column < 3; ++column) {
    net.muscles.push_back("m" + std::to_string(column));
    bend(join(node(0, column), add_node(net, false, -1, {-0.03, 0.004, 3 * kColumn * (column - 1)}),
              0, 1, column));
  }
  for (int column = 0; column < 3; ++column)
    bend(join(node(4, column), add_node(net, false, 0, place(0.0055, 1.3, column)), 0.01, 150));
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 3; ++column)
      join(node(row, column), node(row + 1, column), 0.01, 150);
  for (int row = 0; row < 5; ++row)
    for (int column = 0; column < 2; ++column)
      join(node(row, column), node(row, column + 1), 0.005, 50);
  for (int row = 0; row < 4; ++row) {
    join(node(row, 0), node(row + 1, 1), 0.005, 80);
    join(node(row, 2), node(row + 1, 1), 0.005, 80);
  }
  for (int column : {0, 2}) {
    join(node(1, 1), node(0, column), -0.02, 80);
    join(node(2, column), add_node(net, false, -1, {0.002, 0.0035, 3 * kColumn * (column - 1)}),
         0.01, 60);
  }
  sample.drive.tension = Eigen::Vector3d(4, 9, 3);
  return sample;
}

}  // namespace thenar
