#include <tuple>

#include "tendons/net/net_rates.h"

namespace thenar::internal {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// A force on a link at a point, with their rates.
struct ForceRate {
  int link;
  Vector3d p, dp, f, df;
};

/// Bands on their fixed ends, and on the bones over which they bend.
/// @param left  force_rate(): what a drawn band has to make up for
void add_bands(const TangentNet& tangent, const NetInput& input, const Matrix3Xd& v,
               const Matrix3Xd& left, std::vector<ForceRate>& all) {
  for (std::size_t b = 0; b < tangent.band.size(); ++b) {
    const NetBand& band = tangent.net.bands[b];
    const BandState& now = tangent.band[b];
    const int drawn = tangent.drawn[b];
    BandRate rate = band_rate(tangent, static_cast<Index>(b), input, v);
    Vector3d fa = -now.pull.tension * now.chord.slope.head<3>(),
             fb = -now.pull.tension * now.chord.slope.tail<3>();
    if (drawn >= 0) {
      const int k = std::max(tangent.row[band.a], tangent.row[band.b]);
      const Vector3d on_node = -left.col(k) / tangent.nodes[static_cast<std::size_t>(k)].drawn;
      rate.fa = tangent.row[band.a] >= 0 ? on_node : Vector3d(-on_node);
      rate.fb = -rate.fa;
      fa = tangent.rest.drawn[static_cast<std::size_t>(drawn)].force, fb = -fa;
    }
    const bool bent = now.chord.bent && drawn < 0;
    const int over = bent ? tangent.net.surfaces[band.over].link : -1;
    for (const auto& [end, f, df] :
         {std::tie(band.a, fa, rate.fa), std::tie(band.b, fb, rate.fb)}) {
      const NetNode& node = tangent.net.nodes[static_cast<std::size_t>(end)];
      if (!node.free) all.push_back({node.link, tangent.x(end), v.col(end), f, df});
      if (bent) all.push_back({over, tangent.x(end), v.col(end), -f, -df});
    }
  }
}

/// Floating nodes on the bones that they touch.
void add_contacts(const TangentNet& tangent, const NetInput& input, const Matrix3Xd& v,
                  const Matrix3Xd& left, std::vector<ForceRate>& all) {
  for (std::size_t k = 0; k < tangent.nodes.size(); ++k) {
    const TangentNode& node = tangent.nodes[k];
    if (node.contact.empty()) continue;
    VectorXd force = -node.bear * left.col(static_cast<Index>(k));
    if (node.exit >= 0) force.setZero();  // the band that drew it makes up for all
    for (std::size_t i = 0; i < node.contact.size(); ++i) {
      const NetContact& contact = tangent.rest.contacts[node.contact[i]];
      const SurfaceProbe& probe = tangent.probe[node.contact[i]];
      const int link = tangent.net.surfaces[contact.surface].link;
      const Vector3d p = tangent.x(node.node), dp = v.col(node.node);
      const BodyRate& bone = input.body(link);
      const Vector3d turn = bone.w.cross(probe.normal) + probe.curvature * (dp - bone.at(p));
      all.push_back({link, p, dp, -contact.force * probe.normal,
                     -force[static_cast<Index>(i)] * probe.normal - contact.force * turn});
    }
  }
}

}  // namespace

VectorXd torque_rate(const TangentNet& tangent, const Tree<double>& tree,
                     const TreeState<double>& state, const NetInput& input, const Matrix3Xd& v,
                     int coordinates) {
  std::vector<ForceRate> all;
  const Matrix3Xd left = force_rate(tangent, input, v);
  add_bands(tangent, input, v, left, all);
  add_contacts(tangent, input, v, left, all);
  VectorXd tau = VectorXd::Zero(coordinates);
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
