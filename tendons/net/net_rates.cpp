#include "tendons/net/net_rates.h"

namespace thenar::internal {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

namespace {

/// Nodes that bones take along; those that float slide on the bones that they touch.
Matrix3Xd carried(const TangentNet& tangent, const NetInput& input) {
  Matrix3Xd v = Matrix3Xd::Zero(3, tangent.rest.x.cols());
  for (std::size_t i = 0; i < tangent.row.size(); ++i)
    if (tangent.row[i] < 0)
      v.col(static_cast<Index>(i)) =
          input.body(tangent.net.nodes[i].link).at(tangent.x(static_cast<int>(i)));
  for (const TangentNode& node : tangent.nodes) {
    if (node.exit >= 0) v.col(node.node) = v.col(node.exit);
    if (node.exit >= 0 || node.contact.empty()) continue;
    Vector3d along(0, 0, 0);
    for (std::size_t i = 0; i < node.contact.size(); ++i) {
      const NetContact& contact = tangent.rest.contacts[node.contact[i]];
      along[static_cast<Index>(i)] = tangent.probe[node.contact[i]].normal.dot(
          input.body(tangent.net.surfaces[contact.surface].link).at(tangent.x(node.node)));
    }
    v.col(node.node) = node.bear.transpose() * along.head(node.bear.rows());
  }
  return v;
}

}  // namespace

BandRate band_rate(const TangentNet& tangent, Index b, const NetInput& input, const Matrix3Xd& v) {
  const NetBand& band = tangent.net.bands[static_cast<std::size_t>(b)];
  const BandState& now = tangent.band[static_cast<std::size_t>(b)];
  // Seen from the bone over which it bends.
  BodyRate bone;
  if (now.chord.bent) bone = input.body(tangent.net.surfaces[band.over].link);
  Eigen::Matrix<double, 6, 1> move;
  move << v.col(band.a) - bone.at(tangent.x(band.a)), v.col(band.b) - bone.at(tangent.x(band.b));
  const Eigen::Matrix<double, 6, 1> turn = now.chord.curve * move, &u = now.chord.slope;
  const double dL = u.dot(move), T = now.pull.tension;
  const double dT = input.tension(b) + now.pull.stiffness * dL;
  return {dL, dT, -dT * u.head<3>() - T * (bone.w.cross(u.head<3>()) + turn.head<3>()),
          -dT * u.tail<3>() - T * (bone.w.cross(u.tail<3>()) + turn.tail<3>())};
}

Matrix3Xd force_rate(const TangentNet& tangent, const NetInput& input, const Matrix3Xd& v) {
  Matrix3Xd f = Matrix3Xd::Zero(3, static_cast<Index>(tangent.nodes.size()));
  for (Index b = 0; b < input.tension.size(); ++b) {
    const NetBand& band = tangent.net.bands[static_cast<std::size_t>(b)];
    const int ka = tangent.row[band.a], kb = tangent.row[band.b];
    if (tangent.drawn[static_cast<std::size_t>(b)] >= 0 || (ka < 0 && kb < 0)) continue;
    const BandRate now = band_rate(tangent, b, input, v);
    if (ka >= 0) f.col(ka) += now.fa;
    if (kb >= 0) f.col(kb) += now.fb;
  }
  // Normals turn with the bone and with the place on it.
  for (std::size_t c = 0; c < tangent.probe.size(); ++c) {
    const NetContact& contact = tangent.rest.contacts[c];
    const BodyRate& bone = input.body(tangent.net.surfaces[contact.surface].link);
    const Vector3d move = v.col(contact.node) - bone.at(tangent.x(contact.node));
    f.col(tangent.row[contact.node]) +=
        contact.force * (bone.w.cross(tangent.probe[c].normal) + tangent.probe[c].curvature * move);
  }
  return f;
}

Matrix3Xd node_rates(const TangentNet& tangent, const NetInput& input) {
  Matrix3Xd v = carried(tangent, input);
  const Matrix3Xd f = force_rate(tangent, input, v);
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

}  // namespace thenar::internal
