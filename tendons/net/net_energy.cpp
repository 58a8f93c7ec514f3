#include "tendons/net/net_energy.h"

#include <cmath>

namespace thenar::internal {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Turns the derivatives and points of a chord from frame S to the world.
void turn(const Pose<double>& X, Chord& chord) {
  for (int i = 0; i < 6; i += 3) {
    chord.slope.segment<3>(i) = X.R * chord.slope.segment<3>(i).eval();
    for (int j = 0; j < 6; j += 3)
      chord.curve.block<3, 3>(i, j) = X.R * chord.curve.block<3, 3>(i, j).eval() * X.R.transpose();
  }
  chord.touch_a = X * chord.touch_a;
  chord.touch_b = X * chord.touch_b;
}

/// d^2 phi / d(end i) d(end j).
Matrix3d block(const BandState& band, int i, int j) {
  return band.pull.stiffness * band.chord.slope.segment<3>(3 * i) *
             band.chord.slope.segment<3>(3 * j).transpose() +
         band.pull.tension * band.chord.curve.block<3, 3>(3 * i, 3 * j);
}

}  // namespace

NetScene pose_surfaces(const Net& net, const TreeState<double>& state) {
  NetScene scene;
  for (const BoneSurface& s : net.surfaces)
    scene.surface.push_back(s.link < 0 ? s.X : state[s.link].X * s.X);
  return scene;
}

NetScene pose_scene(const Net& net, const TreeState<double>& state, const NetDrive& drive) {
  NetScene scene = pose_surfaces(net, state);
  for (const NetBand& band : net.bands) {
    const bool by_length =
        band.muscle >= 0 && drive.length.size() > 0 && std::isfinite(drive.length(band.muscle));
    scene.slack.push_back(by_length ? drive.length(band.muscle) : band.slack);
    scene.pull.push_back(band.muscle < 0 || by_length ? -1 : drive.tension(band.muscle));
  }
  return scene;
}

Chord band_chord(const Net& net, const NetScene& scene, int i, const Vector3d& a,
                 const Vector3d& b) {
  const NetBand& band = net.bands[i];
  if (band.over < 0) return straight_chord(a, b);
  const Pose<double> X = scene.surface[band.over], back = X.inverse();
  Chord chord = chord_over(net.surfaces[band.over], back * a, back * b, band.side);
  turn(X, chord);
  return chord;
}

BandState band_state(const Net& net, const NetScene& scene, int i, const Vector3d& a,
                     const Vector3d& b) {
  BandState out{band_chord(net, scene, i, a, b), {}};
  if (scene.pull[i] >= 0)
    out.pull = {scene.pull[i] * out.chord.length, scene.pull[i], 0};
  else
    out.pull = band_pull(out.chord.length, scene.slack[i], net.bands[i].EA, net.bands[i].toe);
  return out;
}

void evaluate(const NetPlan& plan, const NetScene& scene, const std::vector<Vector3d>& x,
              NetEnergy& out) {
  out.energy = 0;
  for (Vector3d& g : out.g) g.setZero();
  for (Matrix3d& H : out.H.diagonal) H.setZero();
  for (Matrix3d& H : out.H.off) H.setZero();
  for (int i = 0; i < static_cast<int>(plan.bands.size()); ++i) {
    const BandPlan& at = plan.bands[i];
    const NetBand& band = plan.net.bands[i];
    const BandState now = band_state(plan.net, scene, i, x[band.a], x[band.b]);
    out.energy += now.pull.energy;
    if (at.ka >= 0) {
      out.g[at.ka] += now.pull.tension * now.chord.slope.head<3>();
      out.H.diagonal[at.ka] += block(now, 0, 0);
    }
    if (at.kb >= 0) {
      out.g[at.kb] += now.pull.tension * now.chord.slope.tail<3>();
      out.H.diagonal[at.kb] += block(now, 1, 1);
    }
    if (at.slot >= 0) out.H.off[at.slot] += at.flip ? block(now, 1, 0) : block(now, 0, 1);
  }
}

}  // namespace thenar::internal
