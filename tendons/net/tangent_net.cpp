#include "tendons/net/tangent_net.h"

#include <limits>
#include <tuple>

#include <Eigen/QR>

#include "base/error.h"
#include "tendons/net/node_contact.h"

namespace thenar::internal {

using Eigen::Index;
using Eigen::Matrix3d;

TangentNet::TangentNet(const Net& of, const TreeState<double>& state, const NetDrive& drive,
                       const NetEquilibrium& at)
    : net(of), rest(at), scene(pose_scene(of, state, drive)), collapsed(of.bands.size(), -1) {
  number_nodes();
  release_penalties();
  probe_contacts();
  evaluate_bands();
  find_free_directions();
  factor();
}

void TangentNet::number_nodes() {
  // Number floating nodes in file order.
  for (std::size_t i = 0; i < net.nodes.size(); ++i) {
    row.push_back(net.nodes[i].free ? static_cast<int>(nodes.size()) : -1);
    if (!net.nodes[i].free) continue;
    nodes.emplace_back();
    nodes.back().node = static_cast<int>(i);
  }
  // Attach collapsed nodes to their exits.
  for (std::size_t d = 0; d < rest.collapsed.size(); ++d) {
    const NetBand& pulled = net.bands[rest.collapsed[d].band];
    require(row[pulled.a] < 0 || row[pulled.b] < 0,
            "net {}: {} has drawn two floating nodes together: no derivative", net.name,
            pulled.name);
    collapsed[rest.collapsed[d].band] = static_cast<int>(d);
    TangentNode& node = nodes[std::max(row[pulled.a], row[pulled.b])];
    node.exit = row[pulled.a] >= 0 ? pulled.b : pulled.a;
    ++node.collapsed;
  }
}

/// Gives bands of constant pull that have collapsed no node their own stiffness, however short they
/// are: the penalty spring of the search is not part of the net.
void TangentNet::release_penalties() {
  for (std::size_t b = 0; b < collapsed.size(); ++b)
    if (collapsed[b] < 0) scene.penalty[b] = std::numeric_limits<double>::infinity();
}

void TangentNet::probe_contacts() {
  for (std::size_t c = 0; c < rest.contacts.size(); ++c) {
    const NetContact& contact = rest.contacts[c];
    probe.push_back(probe_world(net, scene, contact.surface, x(contact.node)));
    nodes[row[contact.node]].contact.push_back(static_cast<int>(c));
  }
}

void TangentNet::evaluate_bands() {
  band.reserve(net.bands.size());
  for (std::size_t b = 0; b < net.bands.size(); ++b)
    band.push_back(
        band_state(net, scene, static_cast<int>(b), x(net.bands[b].a), x(net.bands[b].b)));
  // Clear bands of undetermined nodes, which are slack up to rounding.
  for (std::size_t b = 0; b < net.bands.size(); ++b)
    for (const int loose : rest.undetermined)
      if (net.bands[b].a == loose || net.bands[b].b == loose)
        band[b].pull.tension = band[b].pull.stiffness = 0;
}

void TangentNet::find_free_directions() {
  // Mark nodes held by a taut or stiff band.
  std::vector<bool> held(net.nodes.size(), false);
  for (std::size_t b = 0; b < band.size(); ++b)
    if (collapsed[b] < 0 && (band[b].pull.stiffness != 0 || band[b].pull.tension != 0))
      held[net.bands[b].a] = held[net.bands[b].b] = true;
  Index column = 0;
  // Find the directions tangent to all surfaces that the node touches.
  for (TangentNode& node : nodes) {
    node.column = column;
    node.free = Matrix3d::Identity();
    if (!node.contact.empty()) {
      Columns3 N(3, static_cast<Index>(node.contact.size()));
      for (Index i = 0; i < N.cols(); ++i) N.col(i) = probe[node.contact[i]].normal;
      const Eigen::CompleteOrthogonalDecomposition<Columns3> split(N);
      const Matrix3d Q = split.householderQ() * Matrix3d::Identity();
      node.free = Q.rightCols(3 - split.rank());
      node.to_contact = split.pseudoInverse();
    }
    // Fix collapsed and undetermined nodes.
    if (node.exit >= 0 || !held[node.node]) node.free.resize(3, 0);
    column += node.free.cols();
  }
}

void TangentNet::factor() {
  const Index size = nodes.empty() ? 0 : nodes.back().column + nodes.back().free.cols();
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(size, size);
  // Define how to add a block in the free directions of two nodes.
  const auto add = [&](int i, int j, const Matrix3d& K) {
    if (i < 0 || j < 0) return;
    const TangentNode &a = nodes[i], &b = nodes[j];
    H.block(a.column, b.column, a.free.cols(), b.free.cols()) +=
        a.free.transpose().lazyProduct((K * b.free).eval());
  };
  // Add the stiffness of the bands.
  for (std::size_t b = 0; b < band.size(); ++b) {
    if (collapsed[b] >= 0) continue;
    const int ends[] = {row[net.bands[b].a], row[net.bands[b].b]};
    const WrappedString& chord = band[b].chord;
    for (int i : {0, 1})
      for (int j : {0, 1})
        add(ends[i], ends[j],
            band[b].pull.stiffness * chord.slope.segment<3>(3 * i) *
                    chord.slope.segment<3>(3 * j).transpose() +
                band[b].pull.tension * chord.curve.block<3, 3>(3 * i, 3 * j));
  }
  // Add the curvature of the surfaces under normal forces.
  for (std::size_t c = 0; c < probe.size(); ++c) {
    const int k = row[rest.contacts[c].node];
    add(k, k, -rest.contacts[c].force * probe[c].curvature);
  }
  stiffness.compute(H);
}

namespace {

/// Builds a perturbation that moves only bones and hinges.
NetPerturbation with_bones(const Net& net, TreeVelocity bones) {
  return {std::move(bones), Eigen::VectorXd::Zero(static_cast<Eigen::Index>(net.bands.size())),
          Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(net.nodes.size())),
          Eigen::VectorXd::Zero(static_cast<Eigen::Index>(net.surfaces.size()))};
}

}  // namespace

bool has_radius(const BoneSurface& surface) {
  return surface.shape == SurfaceShape::kSphere || surface.shape == SurfaceShape::kCylinder ||
         surface.shape == SurfaceShape::kCapsule;
}

NetPerturbation zero_perturbation(const Net& net, std::size_t links) {
  const std::vector<Eigen::Vector3d> none(links, Eigen::Vector3d::Zero());
  return with_bones(net, {std::vector<BodyTwist>(links + 1), none, none});
}

void add_pull_rates(const Net& net, const Eigen::VectorXd& pull, NetPerturbation& input) {
  for (std::size_t b = 0; b < net.bands.size(); ++b)
    if (net.bands[b].muscle >= 0) input.tension[b] += pull[net.bands[b].muscle];
}

NetPerturbation joint_perturbation(const Net& net, const Tree<double>& tree,
                                   const TreeState<double>& state, int coordinate) {
  return with_bones(net, joint_velocity_tree(tree, state, coordinate));
}

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

namespace {

/// Computes the velocities of nodes moved by bones; floating nodes keep in contact.
Matrix3Xd bone_driven_rates(const TangentNet& tangent, const NetPerturbation& input) {
  Matrix3Xd v = Matrix3Xd::Zero(3, tangent.rest.x.cols());
  // Move fixed nodes with their links, and within them.
  for (std::size_t i = 0; i < tangent.row.size(); ++i)
    if (tangent.row[i] < 0)
      v.col(static_cast<Index>(i)) =
          input.body(tangent.net.nodes[i].link).velocity_at(tangent.x(static_cast<int>(i))) +
          input.node.col(static_cast<Index>(i));
  // Move collapsed nodes with their exits.
  for (const TangentNode& node : tangent.nodes) {
    if (node.exit >= 0) v.col(node.node) = v.col(node.exit);
    if (node.exit >= 0 || node.contact.empty()) continue;
    // Move floating nodes with the bones along the normals.
    Vector3d along(0, 0, 0);
    for (std::size_t i = 0; i < node.contact.size(); ++i) {
      const NetContact& contact = tangent.rest.contacts[node.contact[i]];
      along[i] = tangent.probe[node.contact[i]].normal.dot(
                     input.body(tangent.net.surfaces[contact.surface].link)
                         .velocity_at(tangent.x(node.node))) +
                 input.radius[contact.surface];
    }
    v.col(node.node) = node.to_contact.transpose() * along.head(node.to_contact.rows());
  }
  return v;
}

}  // namespace

namespace {

/// Derivative of a bent string by the radius of its bone at fixed ends.
struct RadiusSlope {
  double length;                      // [1]
  Eigen::Matrix<double, 6, 1> slope;  // derivative of the string's slope [1/m]
};

/// Computes the derivative of a bent string by the radius. Across the axis (of a sphere: in the
/// plane of the ends and the centre) the string is
///   P = f_a + f_b + r arc,  f = sqrt(rho^2 - r^2),  dP/dr = arc,
/// since the changes of f and arc at both tangent points cancel. An end's direction w = (f e + r t)
/// / rho,  with e away from the centre and t across e, turns by  dw/dr = -n / f,  n = (r e - f t) /
/// rho. Unrolled from a cylinder, with z the climb:  L^2 = P^2 + z^2,  slope = (P w + z d) / L. 1 /
/// f is that of the string's second derivative, with the same bound: an end that lies on the bone
/// is lifted by it, and both must cancel.
RadiusSlope slope_by_radius(const RoundBone& bone, const WrappedString& chord, const Vector3d& a,
                            const Vector3d& b) {
  const double L = chord.length;
  const Vector3d d = bone.sphere ? Vector3d::Zero().eval() : bone.d;
  const double climb = d.dot(a - b), P = std::sqrt((L - climb) * (L + climb));
  RadiusSlope out;
  double arc = P;  // total length; reduced to the arc below
  for (int i : {0, 1}) {
    // Compute the end from the axis or centre, its direction, and the normal of its run.
    const Vector3d from = (i == 0 ? a : b) - bone.center, across = from - d * d.dot(from);
    const double z = i == 0 ? climb : -climb;
    const Vector3d w = (L * chord.slope.segment<3>(3 * i) - z * d) / P;
    const Vector3d n = (across - w * w.dot(across)).normalized();
    const double per_run = L / P * n.dot(chord.curve.block<3, 3>(3 * i, 3 * i) * n);
    out.slope.segment<3>(3 * i) = -P / L * per_run * n;
    arc -= across.dot(w);
  }
  arc /= bone.radius;
  // Add the change of length, and of the inclination to the axis.
  out.length = P / L * arc;
  for (int i : {0, 1}) {
    const double z = i == 0 ? climb : -climb;
    out.slope.segment<3>(3 * i) +=
        arc * z / (L * L * P) * (z * chord.slope.segment<3>(3 * i) - L * d);
  }
  return out;
}

}  // namespace

BandRate band_rate(const TangentNet& tangent, Index b, const NetPerturbation& input,
                   const Matrix3Xd& v) {
  const NetBand& band = tangent.net.bands[b];
  const BandState& now = tangent.band[b];
  // Compute the motion of the ends relative to the bone over which it bends.
  BodyTwist bone;
  if (now.chord.bent) bone = input.body(tangent.net.surfaces[band.over].link);
  Eigen::Matrix<double, 6, 1> move;
  move << v.col(band.a) - bone.velocity_at(tangent.x(band.a)),
      v.col(band.b) - bone.velocity_at(tangent.x(band.b));
  // Compute the rates of length, tension and direction.
  Eigen::Matrix<double, 6, 1> turn = now.chord.curve * move;
  const Eigen::Matrix<double, 6, 1>& u = now.chord.slope;
  double dL = u.dot(move);
  if (now.chord.bent && input.radius[band.over] != 0) {
    const RadiusSlope grown =
        slope_by_radius(tangent.scene.bone[b], now.chord, tangent.x(band.a), tangent.x(band.b));
    dL += input.radius[band.over] * grown.length;
    turn += input.radius[band.over] * grown.slope;
  }
  const double T = now.pull.tension;
  const double dT = input.tension(b) + now.pull.stiffness * dL;
  return {dL, dT, -dT * u.head<3>() - T * (bone.w.cross(u.head<3>()) + turn.head<3>()),
          -dT * u.tail<3>() - T * (bone.w.cross(u.tail<3>()) + turn.tail<3>())};
}

Matrix3Xd force_rate(const TangentNet& tangent, const NetPerturbation& input, const Matrix3Xd& v) {
  Matrix3Xd f = Matrix3Xd::Zero(3, static_cast<Index>(tangent.nodes.size()));
  for (Index b = 0; b < input.tension.size(); ++b) {
    const NetBand& band = tangent.net.bands[b];
    const int ka = tangent.row[band.a], kb = tangent.row[band.b];
    if (tangent.collapsed[b] >= 0 || (ka < 0 && kb < 0)) continue;
    const BandRate now = band_rate(tangent, b, input, v);
    if (ka >= 0) f.col(ka) += now.fa;
    if (kb >= 0) f.col(kb) += now.fb;
  }
  // Add the rotation of contact normals with the bone and along it.
  for (std::size_t c = 0; c < tangent.probe.size(); ++c) {
    const NetContact& contact = tangent.rest.contacts[c];
    const BodyTwist& bone = input.body(tangent.net.surfaces[contact.surface].link);
    const Vector3d move = v.col(contact.node) - bone.velocity_at(tangent.x(contact.node));
    f.col(tangent.row[contact.node]) +=
        contact.force * (bone.w.cross(tangent.probe[c].normal) + tangent.probe[c].curvature * move);
  }
  return f;
}

Matrix3Xd node_rates(const TangentNet& tangent, const NetPerturbation& input) {
  // Compute the motion with the bones alone, and the force that it leaves unbalanced.
  Matrix3Xd v = bone_driven_rates(tangent, input);
  const Matrix3Xd f = force_rate(tangent, input, v);
  // Add the response along the free directions.
  Eigen::VectorXd along(tangent.stiffness.rows());
  for (std::size_t k = 0; k < tangent.nodes.size(); ++k) {
    const TangentNode& node = tangent.nodes[k];
    along.segment(node.column, node.free.cols()) =
        node.free.transpose() * f.col(static_cast<Index>(k));
  }
  const Eigen::VectorXd move = tangent.stiffness.solve(along);
  for (const TangentNode& node : tangent.nodes)
    v.col(node.node) += node.free * move.segment(node.column, node.free.cols());
  return v;
}

namespace {

using Eigen::VectorXd;

/// Force on a link at a point, with rates of both.
struct ForceRate {
  int link;
  Vector3d p, dp, f, df;
};

/// Adds the forces of bands on their fixed ends, and on the bones over which they bend.
/// @param unbalanced  force_rate(), which collapsed bands balance
void add_bands(const TangentNet& tangent, const NetPerturbation& input, const Matrix3Xd& v,
               const Matrix3Xd& unbalanced, std::vector<ForceRate>& all) {
  for (std::size_t b = 0; b < tangent.band.size(); ++b) {
    const NetBand& band = tangent.net.bands[b];
    const BandState& now = tangent.band[b];
    const int collapsed = tangent.collapsed[b];
    BandRate rate = band_rate(tangent, static_cast<Index>(b), input, v);
    // Compute the force of the band on its two ends.
    Vector3d fa = -now.pull.tension * now.chord.slope.head<3>(),
             fb = -now.pull.tension * now.chord.slope.tail<3>();
    // Let a collapsed band balance the force on its node.
    if (collapsed >= 0) {
      const int k = std::max(tangent.row[band.a], tangent.row[band.b]);
      const Vector3d on_node = -unbalanced.col(k) / tangent.nodes[k].collapsed;
      rate.fa = tangent.row[band.a] >= 0 ? on_node : Vector3d(-on_node);
      rate.fb = -rate.fa;
      fa = tangent.rest.collapsed[collapsed].force, fb = -fa;
    }
    // Add the links of fixed ends, and the bone over which it bends.
    const bool bent = now.chord.bent && collapsed < 0;
    const int over = bent ? tangent.net.surfaces[band.over].link : -1;
    for (const auto& [end, f, df] :
         {std::tie(band.a, fa, rate.fa), std::tie(band.b, fb, rate.fb)}) {
      const NetNode& node = tangent.net.nodes[end];
      if (!node.free) all.push_back({node.link, tangent.x(end), v.col(end), f, df});
      if (bent) all.push_back({over, tangent.x(end), v.col(end), -f, -df});
    }
  }
}

/// Adds the forces of floating nodes on the bones that they touch.
void add_contacts(const TangentNet& tangent, const NetPerturbation& input, const Matrix3Xd& v,
                  const Matrix3Xd& unbalanced, std::vector<ForceRate>& all) {
  for (std::size_t k = 0; k < tangent.nodes.size(); ++k) {
    const TangentNode& node = tangent.nodes[k];
    if (node.contact.empty()) continue;
    // Compute the change of the contact forces.
    VectorXd force = -node.to_contact * unbalanced.col(static_cast<Index>(k));
    if (node.exit >= 0) force.setZero();  // the band that collapsed it balances all
    for (std::size_t i = 0; i < node.contact.size(); ++i) {
      const NetContact& contact = tangent.rest.contacts[node.contact[i]];
      const SurfaceProbe& probe = tangent.probe[node.contact[i]];
      const int link = tangent.net.surfaces[contact.surface].link;
      // Add the force on the bone at a moving point, along a rotating normal.
      const Vector3d p = tangent.x(node.node), dp = v.col(node.node);
      const BodyTwist& bone = input.body(link);
      const Vector3d turn =
          bone.w.cross(probe.normal) + probe.curvature * (dp - bone.velocity_at(p));
      all.push_back({link, p, dp, -contact.force * probe.normal,
                     -force[i] * probe.normal - contact.force * turn});
    }
  }
}

}  // namespace

VectorXd torque_rate(const TangentNet& tangent, const Tree<double>& tree,
                     const TreeState<double>& state, const NetPerturbation& input,
                     const Matrix3Xd& v, int coordinates) {
  // Collect the forces on links, with their rates.
  std::vector<ForceRate> all;
  const Matrix3Xd unbalanced = force_rate(tangent, input, v);
  add_bands(tangent, input, v, unbalanced, all);
  add_contacts(tangent, input, v, unbalanced, all);
  VectorXd tau = VectorXd::Zero(coordinates);
  // Sum the rates of their moments about the hinges.
  for (const auto& [link, p, dp, f, df] : all) {
    const Vector3d m = p.cross(f), dm = dp.cross(f) + p.cross(df);
    for_each_hinge_to_base(tree, link, [&, &f = f, &df = df](int i) {
      const LinkState<double>& hinge = state[i];
      tau(tree[i].coordinate) +=
          tree[i].ratio * (input.axis[i].dot(m - hinge.point.cross(f)) +
                           hinge.axis.dot(dm - input.point[i].cross(f) - hinge.point.cross(df)));
    });
  }
  return tau;
}

}  // namespace thenar::internal
