#pragma once

/// Nets shared by tests, timings and rivals.

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "hand/chain.h"
#include "tendons/net/net.h"
#include "tendons/wrapping/wrapped_string.h"

namespace thenar {

/// A net with the bones it lies on and what pulls it.
struct SampleNet {
  Net net;
  Tree<double> tree;
  NetDrive drive;
  Eigen::VectorXd q;  // posture [rad]
  [[nodiscard]] TreeState<double> state() const { return pose_tree(tree, q); }
  [[nodiscard]] int coordinates() const { return static_cast<int>(q.size()); }
};

/// Adds a node and returns its number.
inline int add_node(Net& net, bool free, int link, const Eigen::Vector3d& p,
                    std::vector<int> surfaces = {}) {
  const int number = static_cast<int>(net.nodes.size());
  net.nodes.push_back({"n" + std::to_string(number), free, link, p, std::move(surfaces)});
  return number;
}

/// Adds a passive band and returns its number.
inline int add_band(Net& net, int a, int b, double slack, double EA, double toe = 0) {
  const int number = static_cast<int>(net.bands.size());
  NetBand band{"b" + std::to_string(number), a, b};
  band.slack = slack, band.EA = EA, band.toe = toe;
  net.bands.push_back(band);
  return number;
}

/// Adds a band that a muscle pulls.
inline void add_pull(Net& net, int a, int b, int muscle) {
  net.bands[static_cast<std::size_t>(add_band(net, a, b, 0, 0))].muscle = muscle;
}

/// A net over the head of a phalanx: a cylinder of radius 6 mm along z, the axis of the hinge that
/// q[0] flexes. Floating nodes lie on it three to a row, from the dorsal side distally. In the
/// order in which `bands` takes them: three muscles, three slips to the next bone, fibres along,
/// across and aslant, and fibres to the sides of the bone.
inline SampleNet sample_net_on_bone(int free_nodes, int bands) {
  constexpr double kRadius = 0.006, kColumn[] = {-0.004, 0.0, 0.004}, kFirst = 0.6, kLast = 1.8;
  SampleNet sample;
  Net& net = sample.net;
  net.name = "on bone";
  sample.tree = {{-1, 0, 1, 0, {0, 0, -1}, {0, 0, 0}}};
  sample.q = Eigen::VectorXd::Constant(1, 0.3);
  net.surfaces = {{"head", -1, SurfaceShape::kCylinder, {kRadius, 0.01, 0}, {}}};
  const auto on_bone = [&](double angle, double z) {
    return Eigen::Vector3d(kRadius * std::cos(angle), kRadius * std::sin(angle), z);
  };
  const int rows = (free_nodes + 2) / 3;
  std::vector<std::vector<int>> grid(static_cast<std::size_t>(rows));
  for (int i = 0; i < free_nodes; ++i) {
    const int row = i / 3;
    const double angle = kFirst + (kLast - kFirst) * row / std::max(rows - 1, 1);
    grid[row].push_back(add_node(net, true, -1, on_bone(angle, kColumn[i % 3]), {0}));
  }
  // Slack lengths make the given strain at this place, along the bone where it is in the way.
  const auto join = [&](int a, int b, double strain, bool over, int muscle = -1) {
    const Eigen::Vector3d &pa = net.nodes[a].p, &pb = net.nodes[b].p;
    const BoneSurface& bone = net.surfaces[0];
    const double length = wrap_string(bone, pa, pb, {0, 1, 0}).length;
    NetBand& band = net.bands[add_band(net, a, b, length / (1 + strain), 150, 0.02)];
    band.muscle = muscle;
    if (over) band.over = 0;
  };
  for (int c = 0; c < 3; ++c) {
    net.muscles.push_back("m" + std::to_string(c));
    const int exit = add_node(net, false, -1, {-0.02, 0.0, 1.5 * kColumn[c]});
    join(grid.back()[std::min<std::size_t>(c, grid.back().size() - 1)], exit, 0, true, c);
  }
  for (std::size_t c = 0; c < grid[0].size(); ++c)
    join(grid[0][c], add_node(net, false, 0, {0.012, -0.006, 0.7 * kColumn[c]}), 0.04, true);
  for (int r = 0; r + 1 < rows; ++r)
    for (std::size_t c = 0; c < grid[r + 1].size(); ++c)
      join(grid[r][c], grid[r + 1][c], 0.04, true);
  for (int r = 0; r < rows; ++r)
    for (std::size_t c = 0; c + 1 < grid[r].size(); ++c)
      join(grid[r][c], grid[r][c + 1], 0.01, false);
  for (int r = 0; r + 1 < rows; ++r)
    for (std::size_t c = 0; c + 1 < grid[r + 1].size(); ++c) {
      join(grid[r][c], grid[r + 1][c + 1], 0.01, true);
      join(grid[r][c + 1], grid[r + 1][c], -0.02, true);
    }
  for (int r = 0; r < rows; ++r)
    for (int side : {-1, 1}) {
      const Eigen::Vector3d edge = net.nodes[side < 0 ? grid[r].front() : grid[r].back()].p;
      const int seat = add_node(net, false, -1, edge + Eigen::Vector3d(0.001, 0.001, side * 0.004));
      join(side < 0 ? grid[r].front() : grid[r].back(), seat, 0.01, false);
    }
  if (bands < static_cast<int>(net.bands.size())) net.bands.resize(bands);
  sample.drive.tension = Eigen::Vector3d(4, 9, 3);
  return sample;
}

/// What random_net() draws.
struct RandomNetOptions {
  int min_free = 4, max_free = 30;
  bool bones = false;  // surfaces that nodes rest on and bands bend over
  bool all_slack = false;
  double toe = 0.5;   // part of passive bands with a toe region
  double weak = 0.1;  // part of nets in which muscles pull from anywhere and nothing need hold them
};

namespace sample_internal {

inline Eigen::Vector3d draw_point(std::mt19937& rng, double reach) {
  std::uniform_real_distribution<double> draw(-reach, reach);
  return {draw(rng), draw(rng), draw(rng)};
}

inline BoneSurface draw_bone(std::mt19937& rng, int link) {
  std::uniform_real_distribution<double> radius(0.002, 0.008);
  BoneSurface bone;
  bone.link = link;
  bone.shape = kSurfaceShapeNames[rng() % kSurfaceShapeNames.size()].value;
  bone.size = {radius(rng), radius(rng), radius(rng)};
  if (bone.shape == SurfaceShape::kTorus) bone.size[1] = bone.size[0] + radius(rng);
  bone.X.R = rotation_about(draw_point(rng, 1).normalized().eval(), 6.28 * radius(rng) / 0.008);
  bone.X.p = draw_point(rng, 0.015);
  return bone;
}

inline void add_bones(std::mt19937& rng, Net& net) {
  const int count = 1 + static_cast<int>(rng() % 3);
  for (int s = 0; s < count; ++s) {
    net.surfaces.push_back(draw_bone(rng, static_cast<int>(rng() % 3) - 1));
    net.surfaces.back().name = "s" + std::to_string(s);
  }
  for (NetNode& node : net.nodes)
    for (int s = 0; node.free && s < count; ++s)
      if (rng() % 3) node.surfaces.push_back(s);
  for (NetBand& band : net.bands) {
    const int s = static_cast<int>(rng() % static_cast<unsigned>(count));
    const BoneSurface& bone = net.surfaces[s];
    const bool is_round =
        bone.shape == SurfaceShape::kSphere || bone.shape == SurfaceShape::kCylinder;
    if (rng() % 3 || !is_round) continue;
    const Pose<double> to_S = bone.X.inverse();
    const Eigen::Vector3d a = to_S * net.nodes[band.a].p, b = to_S * net.nodes[band.b].p;
    if (probe(bone, a).gap < 1e-3 || probe(bone, b).gap < 1e-3) continue;
    band.over = s;
    band.side = a + b;  // the side on which it lies
    // Ends that float stay outside of what they bend over.
    for (int end : {band.a, band.b}) {
      NetNode& node = net.nodes[end];
      if (node.free && std::count(node.surfaces.begin(), node.surfaces.end(), s) == 0)
        node.surfaces.push_back(s);
    }
  }
}

}  // namespace sample_internal

/// A random net in a cube of 6 cm on a chain of two bones: joined, with anchors on all bones and
/// one to four muscles, some of them idle, one in eight given by length. Muscles leave away from
/// the net, against a band that holds; in weak nets they may draw a node into their exit.
inline SampleNet random_net(std::mt19937& rng, const RandomNetOptions& options = {}) {
  using sample_internal::draw_point;
  const auto below = [&](int n) { return static_cast<int>(rng() % static_cast<unsigned>(n)); };
  std::uniform_real_distribution<double> unit(0, 1);
  SampleNet sample;
  Net& net = sample.net;
  net.name = "random";
  sample.tree = {{-1, 0, 1, 0, draw_point(rng, 1).normalized(), draw_point(rng, 0.01)},
                 {0, 1, 1, 0, draw_point(rng, 1).normalized(), draw_point(rng, 0.02)}};
  sample.q = Eigen::Vector2d(unit(rng) - 0.3, 1.5 * unit(rng) - 0.3);
  const int free = options.min_free + below(options.max_free - options.min_free + 1);
  const int anchors = 3 + below(6), muscles = 1 + below(4);
  for (int i = 0; i < free; ++i) add_node(net, true, below(3) - 1, draw_point(rng, 0.03));
  for (int i = 0; i < anchors; ++i) add_node(net, false, below(3) - 1, draw_point(rng, 0.03));
  const auto join = [&](int a, int b) {
    const double length = (net.nodes[a].p - net.nodes[b].p).norm();
    const double slack = length * (options.all_slack ? 2.5 : 0.7 + 0.4 * unit(rng));
    const double toe = unit(rng) < options.toe ? 0.05 * unit(rng) : 0;
    add_band(net, a, b, slack, std::pow(10.0, 1.5 + 1.5 * unit(rng)), toe);
  };
  for (int i = 0; i < free; ++i)
    join(i, i == 0 || below(3) == 0 ? free + below(anchors) : below(i));
  for (int extra = below(2 * free); extra > 0; --extra) {
    const int a = below(free), b = below(free + anchors);
    if (a != b) join(a, b);
  }
  const bool weak = unit(rng) < options.weak;
  sample.drive.tension.resize(muscles);
  sample.drive.length.setConstant(muscles, std::numeric_limits<double>::quiet_NaN());
  for (int m = 0; m < muscles; ++m) {
    net.muscles.push_back("m" + std::to_string(m));
    const int at = below(free);
    const Eigen::Vector3d away = draw_point(rng, 1).normalized(), p = net.nodes[at].p;
    const int exit = add_node(net, false, -1,
                              weak ? draw_point(rng, 0.05) : p + (0.05 + 0.03 * unit(rng)) * away);
    // What holds against it: a passive band to an anchor on the other side.
    if (!weak)
      join(at, add_node(net, false, below(3) - 1,
                        p - 0.03 * unit(rng) * away - 0.01 * away + draw_point(rng, 0.01)));
    const double length = (net.nodes[exit].p - net.nodes[at].p).norm();
    net.bands[add_band(net, at, exit, length, 100)].muscle = m;
    sample.drive.tension(m) =
        options.all_slack || below(6) == 0 ? 0 : std::pow(10.0, 1.6 * unit(rng) - 0.8);
    if (below(8) == 0) sample.drive.length(m) = length * (0.8 + 0.4 * unit(rng));
  }
  if (options.bones) sample_internal::add_bones(rng, net);
  return sample;
}

}  // namespace thenar
