#include "tendons/net/net_energy.h"

#include <cmath>

namespace thenar::internal {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Transforms the derivatives and points of a chord from frame S to the world.
void transform_to_world(const Pose<double>& X, WrappedString& chord) {
  for (int i = 0; i < 6; i += 3) {
    chord.slope.segment<3>(i) = X.R * chord.slope.segment<3>(i).eval();
    for (int j = 0; j < 6; j += 3)
      chord.curve.block<3, 3>(i, j) = X.R * chord.curve.block<3, 3>(i, j).eval() * X.R.transpose();
  }
  chord.touch_a = X * chord.touch_a;
  chord.touch_b = X * chord.touch_b;
}

/// Computes d^2 phi / d(end i) d(end j).
Matrix3d block(const BandState& band, int i, int j) {
  return band.pull.stiffness * band.chord.slope.segment<3>(3 * i) *
             band.chord.slope.segment<3>(3 * j).transpose() +
         band.pull.tension * band.chord.curve.block<3, 3>(3 * i, 3 * j);
}

/// Computes the run of a regularised band as a chord whose slope is p / t.
WrappedString penalty_chord(double t, double penalty, const Vector3d& multiplier, const Vector3d& a,
                            const Vector3d& b) {
  // Compute the force at the present length, limited to the pull.
  WrappedString chord = straight_string(a, b);
  const Vector3d d = a - b, w = multiplier + penalty * d;
  const double pull = w.norm();
  const bool in = pull <= t;
  const Vector3d p = in ? w : Vector3d(t / pull * w);
  // Compute its derivative: of a spring, or of a force of constant size that turns.
  Matrix3d H = penalty / t * Matrix3d::Identity();
  if (!in) H = penalty / pull * (Matrix3d::Identity() - w * w.transpose() / (pull * pull));
  // Express it as a string, whose gradient times t is the force.
  chord.slope << p / t, -p / t;
  chord.curve << H, -H, -H, H;
  chord.length =
      (p.dot(d) - (p - multiplier).squaredNorm() / (2 * penalty)) / t + t / (2 * penalty);
  return chord;
}

/// Computes the response of band i at length L.
BandResponse band_response_of(const Net& net, const NetScene& scene, int i, double L) {
  if (scene.pull[i] >= 0) return {scene.pull[i] * L, scene.pull[i], 0};
  if (scene.law[i]) return scene.law[i]->response_at(L);
  return elastic_response(net, net.bands[i], scene.slack[i], L);
}

/// Computes a penalty stiffness above that of the bands at a regularised node: the sum of EA /
/// slack at both ends, with a margin.
double penalty_of(const Net& net, const NetScene& scene, int i) {
  const NetBand& band = net.bands[i];
  // Sum twenty times the stiffness of the bands at its ends.
  double stiffness = scene.pull[i] / 1e-5;
  for (std::size_t j = 0; j < net.bands.size(); ++j) {
    const NetBand& other = net.bands[j];
    const bool meets =
        other.a == band.a || other.a == band.b || other.b == band.a || other.b == band.b;
    if (meets && scene.pull[j] < 0 && !scene.law[j]) stiffness += 20 * other.EA / scene.slack[j];
  }
  return stiffness;
}

}  // namespace

BandResponse elastic_response(const Net& net, const NetBand& band, double slack, double length) {
  if (net.blend > 0) return smoothed_response(length, slack, band.EA, band.toe, net.blend);
  return band_response(length, slack, band.EA, band.toe);
}

bool is_regularised(const NetScene& scene, int i, double length) {
  return scene.pull[i] > 0 &&
         (length * scene.penalty[i] < scene.pull[i] || !scene.multiplier[i].isZero(0));
}

NetScene pose_surfaces(const Net& net, const TreeState<double>& state) {
  NetScene scene;
  for (const BoneSurface& s : net.surfaces) scene.surface.push_back(surface_pose(s, state));
  return scene;
}

NetScene pose_scene(const Net& net, const TreeState<double>& state, const NetDrive& drive) {
  NetScene scene = pose_surfaces(net, state);
  // Set geometry and law of each band.
  for (const NetBand& band : net.bands) {
    scene.bone.push_back(
        band.over < 0 ? RoundBone{}
                      : round_bone(net.surfaces[band.over], scene.surface[band.over], band.side));
    const bool by_length =
        band.muscle >= 0 && drive.length.size() > 0 && std::isfinite(drive.length(band.muscle));
    scene.slack.push_back(by_length ? drive.length(band.muscle) : band.slack);
    scene.law.push_back(band.muscle < 0 || drive.law.empty() ? nullptr : drive.law[band.muscle]);
    const bool by_tension = band.muscle >= 0 && !by_length && !scene.law.back();
    scene.pull.push_back(by_tension ? drive.tension(band.muscle) : -1);
  }
  // Start with no collapsed node.
  scene.multiplier.assign(net.bands.size(), Vector3d::Zero());
  scene.collapsed.assign(net.bands.size(), false);
  for (int i = 0; i < static_cast<int>(net.bands.size()); ++i)
    scene.penalty.push_back(scene.pull[i] > 0 ? penalty_of(net, scene, i) : 0);
  return scene;
}

WrappedString band_string(const Net& net, const NetScene& scene, int i, const Vector3d& a,
                          const Vector3d& b) {
  const NetBand& band = net.bands[i];
  if (band.over < 0) return straight_string(a, b);
  // Wrap the string in the surface's frame.
  const Pose<double> X = scene.surface[band.over], back = X.inverse();
  WrappedString chord = wrap_string(net.surfaces[band.over], back * a, back * b, band.side);
  transform_to_world(X, chord);
  return chord;
}

BandState band_state(const Net& net, const NetScene& scene, int i, const Vector3d& a,
                     const Vector3d& b) {
  BandState out{band_string(net, scene, i, a, b), {}};
  if (!out.chord.bent && is_regularised(scene, i, out.chord.length))
    out.chord = penalty_chord(scene.pull[i], scene.penalty[i], scene.multiplier[i], a, b);
  out.pull = band_response_of(net, scene, i, out.chord.length);
  return out;
}

namespace {

/// Adds  c u v'  to A.
inline void add_outer(Matrix3d& A, double c, const Vector3d& u, const Vector3d& v) {
  for (int j = 0; j < 3; ++j) {
    const double w = c * v(j);
    for (int i = 0; i < 3; ++i) A(i, j) += w * u(i);
  }
}

/// Adds a band that bends over a bone.
void add_bent(const BandPlan& at, const BandGeometry& run, double T, double k, NetEnergy& out) {
  if (at.ka >= 0) {
    out.g[at.ka] += T * run.ua;
    Matrix3d& H = out.H.diagonal[at.ka];
    add_outer(H, k, run.ua, run.ua);
    add_outer(H, T * run.vaa, run.va, run.va);
    add_outer(H, T * run.wa, run.na, run.na);
  }
  if (at.kb >= 0) {
    out.g[at.kb] += T * run.ub;
    Matrix3d& H = out.H.diagonal[at.kb];
    add_outer(H, k, run.ub, run.ub);
    add_outer(H, T * run.vbb, run.vb, run.vb);
    add_outer(H, T * run.wb, run.nb, run.nb);
  }
  if (at.slot < 0) return;
  Matrix3d& H = out.H.off[at.slot];
  add_outer(H, k, at.flip ? run.ub : run.ua, at.flip ? run.ua : run.ub);
  add_outer(H, T * run.vab, at.flip ? run.vb : run.va, at.flip ? run.va : run.vb);
}

/// Adds a straight band.
void add_straight(const BandPlan& at, const Vector3d& u, double T, double k, double L,
                  NetEnergy& out) {
  const double across = T / L;
  Matrix3d K = Matrix3d::Zero();
  add_outer(K, k - across, u, u);
  for (int i = 0; i < 3; ++i) K(i, i) += across;
  if (at.ka >= 0) {
    out.g[at.ka] += T * u;
    out.H.diagonal[at.ka] += K;
  }
  if (at.kb >= 0) {
    out.g[at.kb] -= T * u;
    out.H.diagonal[at.kb] += K;
  }
  if (at.slot >= 0) out.H.off[at.slot] -= K;
}

/// Adds bands of zero length, regularised bands, and bands with an end inside a bone.
void add_degenerate(const BandPlan& at, const BandState& now, NetEnergy& out) {
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

/// Adds band i and returns its response.
BandResponse add_band(const NetPlan& plan, const NetScene& scene, int i, const Vector3d& a,
                      const Vector3d& b, NetEnergy& out) {
  BandGeometry run;
  // Add a band over a bone in closed form.
  const WrapState bend =
      plan.net.bands[i].over < 0 ? WrapState::kStraight : wrap_over(scene.bone[i], a, b, run);
  if (bend == WrapState::kBent) {
    const BandResponse pull = band_response_of(plan.net, scene, i, run.length);
    out.length[i] = run.length;
    if (pull.tension > 0) add_bent(plan.bands[i], run, pull.tension, pull.stiffness, out);
    return pull;
  }
  // Add straight bands; degenerate ones by their strings.
  const Vector3d d = a - b;
  const double L = d.norm();
  if (bend == WrapState::kDegenerate || L == 0 || is_regularised(scene, i, L)) {
    const BandState now = band_state(plan.net, scene, i, a, b);
    out.length[i] = now.chord.bent ? now.chord.length : L;
    add_degenerate(plan.bands[i], now, out);
    return now.pull;
  }
  const BandResponse pull = band_response_of(plan.net, scene, i, L);
  out.length[i] = L;
  if (pull.tension > 0) add_straight(plan.bands[i], d / L, pull.tension, pull.stiffness, L, out);
  return pull;
}

}  // namespace

void evaluate(const NetPlan& plan, const NetScene& scene, const std::vector<Vector3d>& x,
              NetEnergy& out) {
  // Reset energy, gradient and Hessian, then add all bands.
  out.energy = out.size = 0;
  for (Vector3d& g : out.g) g.setZero();
  for (Matrix3d& H : out.H.diagonal) H.setZero();
  for (Matrix3d& H : out.H.off) H.setZero();
  for (int i = 0; i < static_cast<int>(plan.bands.size()); ++i) {
    if (scene.collapsed[i]) continue;
    const NetBand& band = plan.net.bands[i];
    const BandResponse pull = add_band(plan, scene, i, x[band.a], x[band.b], out);
    out.tension[i] = pull.tension;
    out.energy += pull.energy;
    out.size += std::abs(pull.energy);
  }
}

namespace {

/// Numbers the free nodes, in file order; -1 for others.
std::vector<int> number_free(const Net& net) {
  std::vector<int> number;
  int next = 0;
  for (const NetNode& node : net.nodes) number.push_back(node.free ? next++ : -1);
  return number;
}

/// Builds the sparsity pattern of the stiffness matrix.
BlockPattern pattern_of(const Net& net) {
  // Collect the free nodes and the bands between them.
  const std::vector<int> number = number_free(net);
  std::vector<std::pair<int, int>> edges;
  int free = 0;
  for (int i : number) free += i >= 0 ? 1 : 0;
  for (const NetBand& band : net.bands)
    if (number[band.a] >= 0 && number[band.b] >= 0)
      edges.emplace_back(number[band.a], number[band.b]);
  return {free, edges};
}

/// Checks a net and returns it.
const Net& checked(const Net& net) {
  check_net(net);
  return net;
}

}  // namespace

NetPlan::NetPlan(const Net& given) : net(checked(given)), pattern(pattern_of(net)) {
  // Put the free nodes into elimination order.
  row = number_free(net);
  node.resize(pattern.size());
  for (int i = 0; i < static_cast<int>(row.size()); ++i)
    if (row[i] >= 0) {
      row[i] = pattern.place(row[i]);
      node[row[i]] = i;
    }
  // Find the blocks of each band, and the bands that wrap at each node.
  wrapping_bands.resize(node.size());
  for (const NetBand& band : net.bands) {
    BandPlan plan{row[band.a], row[band.b], -1, row[band.a] < row[band.b]};
    if (plan.ka >= 0 && plan.kb >= 0)
      plan.slot = plan.flip ? pattern.slot(plan.kb, plan.ka) : pattern.slot(plan.ka, plan.kb);
    if (band.over >= 0)
      for (int k : {plan.ka, plan.kb})
        if (k >= 0) wrapping_bands[k].push_back(static_cast<int>(bands.size()));
    bands.push_back(plan);
  }
}

}  // namespace thenar::internal
