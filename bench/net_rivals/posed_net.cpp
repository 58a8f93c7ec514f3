#include "bench/net_rivals/posed_net.h"

#include <cmath>
#include <utility>

#include "tendons/wrapping/wrapped_string.h"

namespace thenar::bench {
namespace {

/// The law of NetBand: a parabola of recruited fibres up to `toe`, a straight line beyond.
BandPull elastic(double EA, double toe, double slack, double length) {
  const double strain = (length - slack) / slack;
  if (strain <= 0) return {0, 0};
  if (strain < toe) return {EA * strain * strain / (2 * toe), EA * strain / toe / slack};
  return {EA * (strain - toe / 2), EA / slack};
}

/// The chord of a band in its surface's frame, turned back into the world.
WrappedString chord_in_world(const BoneSurface& surface, const Pose<double>& X_WS,
                             const Eigen::Vector3d& side_S, const Eigen::Vector3d& a,
                             const Eigen::Vector3d& b) {
  const Pose<double> X_SW = X_WS.inverse();
  WrappedString chord = wrap_string(surface, X_SW * a, X_SW * b, side_S);
  Eigen::Matrix<double, 6, 6> R = Eigen::Matrix<double, 6, 6>::Zero();
  R.topLeftCorner<3, 3>() = R.bottomRightCorner<3, 3>() = X_WS.R;
  chord.slope = R * chord.slope;
  chord.curve = R * chord.curve * R.transpose();
  return chord;
}

}  // namespace

PosedNet::PosedNet(const Net& net, const TreeState<double>& state, NetDrive drive)
    : net_(net), drive_(std::move(drive)), linked_(3, static_cast<Eigen::Index>(net.nodes.size())) {
  for (std::size_t i = 0; i < net.nodes.size(); ++i) {
    const NetNode& node = net.nodes[i];
    const int index = static_cast<int>(i);
    linked_.col(index) = moved(state, node.link, node.p);
    if (!node.free) continue;
    free_.push_back(index);
    for (const int surface : node.surfaces) pairs_.push_back({index, surface});
  }
  for (const BoneSurface& surface : net.surfaces)
    surface_.push_back(
        surface.link < 0 ? surface.X : state[static_cast<std::size_t>(surface.link)].X * surface.X);
}

Eigen::Matrix3Xd PosedNet::with_links() const { return linked_; }

Eigen::Matrix3Xd PosedNet::from(const Eigen::Matrix3Xd& start) const {
  Eigen::Matrix3Xd x = linked_;
  for (const int i : free_) x.col(i) = start.col(i);
  return x;
}

bool PosedNet::is_elastic(const NetBand& band) const {
  return band.muscle < 0 || (drive_.length.size() > 0 && std::isfinite(drive_.length[band.muscle]));
}

BandPull PosedNet::pull(int index, double length) const {
  const NetBand& band = net_.bands[static_cast<std::size_t>(index)];
  if (!is_elastic(band)) return {drive_.tension[band.muscle], 0};
  const double slack = band.muscle < 0 ? band.slack : drive_.length[band.muscle];
  return elastic(band.EA, band.toe, slack, length);
}

double PosedNet::recruited(int index) const {
  const NetBand& band = net_.bands[static_cast<std::size_t>(index)];
  if (!is_elastic(band)) return 0;
  return band.EA / (band.muscle < 0 ? band.slack : drive_.length[band.muscle]);
}

BandForce PosedNet::band(int index, const Eigen::Matrix3Xd& x) const {
  const NetBand& band = net_.bands[static_cast<std::size_t>(index)];
  const Eigen::Vector3d a = x.col(band.a), b = x.col(band.b);
  const WrappedString chord =
      band.over < 0
          ? straight_string(a, b)
          : chord_in_world(net_.surfaces[static_cast<std::size_t>(band.over)],
                           surface_[static_cast<std::size_t>(band.over)], band.side, a, b);
  const BandPull at = pull(index, chord.length);
  return {at, chord.slope, -at.tension * chord.slope,
          at.stiffness * chord.slope * chord.slope.transpose() + at.tension * chord.curve};
}

Eigen::Matrix3Xd PosedNet::band_forces(const Eigen::Matrix3Xd& x) const {
  Eigen::Matrix3Xd f = Eigen::Matrix3Xd::Zero(3, x.cols());
  for (std::size_t k = 0; k < net_.bands.size(); ++k) {
    const NetBand& band = net_.bands[k];
    if (band.over < 0) {  // the common case, without slopes
      const Eigen::Vector3d d = x.col(band.b) - x.col(band.a);
      const double length = d.norm();
      if (length == 0) continue;
      const Eigen::Vector3d pulled = pull(static_cast<int>(k), length).tension / length * d;
      f.col(band.a) += pulled;
      f.col(band.b) -= pulled;
    } else {
      const Pose<double>& X = surface_[static_cast<std::size_t>(band.over)];
      const Pose<double> X_SW = X.inverse();
      const WrappedString chord =
          wrap_string(net_.surfaces[static_cast<std::size_t>(band.over)], X_SW * x.col(band.a),
                      X_SW * x.col(band.b), band.side);
      const double tension = pull(static_cast<int>(k), chord.length).tension;
      f.col(band.a) -= tension * (X.R * chord.slope.head<3>());
      f.col(band.b) -= tension * (X.R * chord.slope.tail<3>());
    }
  }
  return f;
}

Eigen::VectorXd PosedNet::tensions(const Eigen::Matrix3Xd& x) const {
  Eigen::VectorXd t(static_cast<Eigen::Index>(net_.bands.size()));
  for (Eigen::Index k = 0; k < t.size(); ++k) t[k] = band(static_cast<int>(k), x).pull.tension;
  return t;
}

BoneProbe PosedNet::bone(int pair, const Eigen::Matrix3Xd& x) const {
  const auto [node, surface] = pairs_[static_cast<std::size_t>(pair)];
  const Pose<double>& X = surface_[static_cast<std::size_t>(surface)];
  const SurfaceProbe at =
      probe(net_.surfaces[static_cast<std::size_t>(surface)], X.inverse() * x.col(node));
  return {pair, node, at.gap, X.R * at.normal, X.R * at.curvature * X.R.transpose()};
}

}  // namespace thenar::bench
