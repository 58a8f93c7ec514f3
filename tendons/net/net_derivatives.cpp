#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include "base/error.h"
#include "tendons/net/net_energy.h"
#include "tendons/net/net_statics.h"
#include "tendons/net/node_contact.h"

namespace thenar {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Velocity of a rigid body: of the point at the world's origin, and angular.
struct Motion {
  Vector3d v{0, 0, 0}, w{0, 0, 0};
  [[nodiscard]] Vector3d at(const Vector3d& p) const { return v + w.cross(p); }
};

/// How everything moves by one input, the floating nodes excepted.
struct Input {
  std::vector<Motion> link;           // the base first
  Eigen::VectorXd tension;            // of each band at a fixed length (bands)
  std::vector<Vector3d> axis, point;  // of the hinges
};

/// Rate of one band: of its tension and of the force on its ends.
struct BandRate {
  double tension;
  Vector3d fa, fb;
};

/// A balanced net, ready to be moved.
class Balanced {
 public:
  Balanced(const Net& net, const Tree<double>& tree, const TreeState<double>& state,
           const NetDrive& drive, const NetEquilibrium& rest, int coordinates);

  [[nodiscard]] NetSlopes slopes(const std::vector<Input>& inputs) const;
  [[nodiscard]] Input still() const;
  [[nodiscard]] Input turning(int coordinate) const;
  [[nodiscard]] double by_slack(Index band) const;  // d tension / d slack at fixed length [N/m]
  [[nodiscard]] double by_EA(Index band) const;     // d tension / d EA [1]
  [[nodiscard]] bool by_length(int muscle) const {
    return drive_.length.size() > 0 && std::isfinite(drive_.length(muscle));
  }

 private:
  [[nodiscard]] Vector3d x(int node) const { return rest_.x.col(node); }
  [[nodiscard]] BandRate rate(Index band, const Input& input, const Eigen::Matrix3Xd& v) const;
  [[nodiscard]] Eigen::Matrix3Xd velocities(const Input& input) const;
  [[nodiscard]] Eigen::VectorXd slope_rate(const Input& input, const Eigen::Matrix3Xd& v) const;
  [[nodiscard]] Eigen::VectorXd contact_rate(const Input& input, const Eigen::Matrix3Xd& v,
                                             const Eigen::VectorXd& g) const;
  [[nodiscard]] Eigen::VectorXd torque_rate(const Input& input, const Eigen::Matrix3Xd& v,
                                            const Eigen::VectorXd& g) const;
  void assemble();
  void pin_contacts();

  const Net& net_;
  const Tree<double>& tree_;
  const TreeState<double>& state_;
  const NetDrive& drive_;
  const NetEquilibrium& rest_;
  int coordinates_;
  internal::NetScene scene_;
  std::vector<internal::BandState> band_;
  std::vector<int> drawn_;                // entry of rest.drawn of each band; -1: none
  std::vector<int> row_;                  // of each node among the free ones; -1: fixed
  std::vector<int> node_;                 // of each row
  std::vector<std::vector<int>> touch_;   // contacts of each row
  std::vector<int> exit_;                 // node that a row is drawn into; -1: none
  std::vector<SurfaceProbe> probe_;       // of each contact
  Eigen::MatrixXd H_;                     // of the Lagrangian (3 rows, 3 rows)
  Eigen::MatrixXd Z_;                     // free directions (3 rows, k)
  Eigen::LDLT<Eigen::MatrixXd> reduced_;  // Z' H Z
};

Balanced::Balanced(const Net& net, const Tree<double>& tree, const TreeState<double>& state,
                   const NetDrive& drive, const NetEquilibrium& rest, int coordinates)
    : net_(net),
      tree_(tree),
      state_(state),
      drive_(drive),
      rest_(rest),
      coordinates_(coordinates),
      scene_(internal::pose_scene(net, state, drive)),
      drawn_(net.bands.size(), -1) {
  for (const NetNode& node : net.nodes) {
    row_.push_back(node.free ? static_cast<int>(node_.size()) : -1);
    if (node.free) node_.push_back(static_cast<int>(row_.size()) - 1);
  }
  touch_.resize(node_.size());
  exit_.assign(node_.size(), -1);
  for (std::size_t d = 0; d < rest.drawn.size(); ++d) {
    const NetBand& band = net.bands[rest.drawn[d].band];
    require(row_[band.a] < 0 || row_[band.b] < 0,
            "net {}: {} has drawn two floating nodes together: no derivative", net.name, band.name);
    drawn_[rest.drawn[d].band] = static_cast<int>(d);
    if (row_[band.a] >= 0) exit_[row_[band.a]] = band.b;
    if (row_[band.b] >= 0) exit_[row_[band.b]] = band.a;
  }
  for (std::size_t c = 0; c < rest.contacts.size(); ++c)
    touch_[row_[rest.contacts[c].node]].push_back(static_cast<int>(c));
  for (const NetContact& c : rest.contacts)
    probe_.push_back(internal::probe_world(net, scene_, c.surface, x(c.node)));
  assemble();
  pin_contacts();
}

void Balanced::assemble() {
  const auto n = static_cast<Index>(3 * node_.size());
  H_ = Eigen::MatrixXd::Zero(n, n);
  for (std::size_t b = 0; b < net_.bands.size(); ++b) {
    const NetBand& band = net_.bands[b];
    band_.push_back(internal::band_state(net_, scene_, static_cast<int>(b), x(band.a), x(band.b)));
    if (drawn_[b] >= 0) continue;
    const internal::BandState& now = band_.back();
    const Eigen::Matrix<double, 6, 6> K =
        now.pull.stiffness * now.chord.slope * now.chord.slope.transpose() +
        now.pull.tension * now.chord.curve;
    const int row[] = {row_[band.a], row_[band.b]};
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        if (row[i] >= 0 && row[j] >= 0)
          H_.block<3, 3>(3 * row[i], 3 * row[j]) += K.block<3, 3>(3 * i, 3 * j);
  }
  for (std::size_t c = 0; c < rest_.contacts.size(); ++c) {
    const int at = 3 * row_[rest_.contacts[c].node];
    H_.block<3, 3>(at, at) -= rest_.contacts[c].force * probe_[c].curvature;
  }
}

/// Z: the tangents of every node, none where it is drawn in or loose.
void Balanced::pin_contacts() {
  std::vector<Eigen::MatrixXd> tangent(node_.size());
  Index count = 0;
  for (std::size_t k = 0; k < node_.size(); ++k) {
    const auto at = static_cast<Index>(3 * k);
    Eigen::MatrixXd N(3, static_cast<Index>(touch_[k].size()));
    for (Index i = 0; i < N.cols(); ++i) N.col(i) = probe_[touch_[k][i]].normal;
    const bool still = exit_[k] >= 0 || H_.block<3, 3>(at, at).isZero(0);
    if (still) {
      tangent[k].resize(3, 0);
    } else if (N.cols() == 0) {
      tangent[k] = Matrix3d::Identity();
    } else {
      const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(N);
      const Matrix3d Q = qr.householderQ();
      tangent[k] = Q.rightCols(3 - qr.rank());
    }
    count += tangent[k].cols();
  }
  Z_ = Eigen::MatrixXd::Zero(H_.rows(), count);
  Index column = 0;
  for (std::size_t k = 0; k < node_.size(); ++k) {
    Z_.block(static_cast<Index>(3 * k), column, 3, tangent[k].cols()) = tangent[k];
    column += tangent[k].cols();
  }
  reduced_.compute(Z_.transpose() * H_ * Z_);
}

Input Balanced::still() const {
  return {std::vector<Motion>(state_.size() + 1),
          Eigen::VectorXd::Zero(static_cast<Index>(net_.bands.size())),
          std::vector<Vector3d>(tree_.size(), Vector3d::Zero()),
          std::vector<Vector3d>(tree_.size(), Vector3d::Zero())};
}

Input Balanced::turning(int coordinate) const {
  Input input = still();
  for (std::size_t i = 0; i < tree_.size(); ++i) {
    const Motion& parent = input.link[static_cast<std::size_t>(tree_[i].parent + 1)];
    Motion& link = input.link[i + 1];
    link = parent;
    input.axis[i] = parent.w.cross(state_[i].axis);
    input.point[i] = parent.at(state_[i].point);
    if (tree_[i].coordinate != coordinate) continue;
    link.w += tree_[i].ratio * state_[i].axis;
    link.v -= tree_[i].ratio * state_[i].axis.cross(state_[i].point);
  }
  return input;
}

double Balanced::by_slack(Index b) const {
  if (scene_.pull[b] >= 0) return 0;
  return -band_[b].pull.stiffness * band_[b].chord.length / scene_.slack[b];
}

double Balanced::by_EA(Index b) const {
  return scene_.pull[b] >= 0 ? 0 : band_[b].pull.tension / net_.bands[b].EA;
}

Eigen::Matrix3Xd Balanced::velocities(const Input& input) const {
  Eigen::Matrix3Xd v = Eigen::Matrix3Xd::Zero(3, rest_.x.cols());
  for (std::size_t i = 0; i < row_.size(); ++i)
    if (row_[i] < 0)
      v.col(static_cast<Index>(i)) =
          input.link[static_cast<std::size_t>(net_.nodes[i].link + 1)].at(x(static_cast<int>(i)));
  return v;
}

BandRate Balanced::rate(Index b, const Input& input, const Eigen::Matrix3Xd& v) const {
  const NetBand& band = net_.bands[b];
  const internal::BandState& now = band_[b];
  Motion bone;
  if (now.chord.bent)
    bone = input.link[static_cast<std::size_t>(net_.surfaces[band.over].link + 1)];
  Eigen::Matrix<double, 6, 1> move;
  move << v.col(band.a) - bone.at(x(band.a)), v.col(band.b) - bone.at(x(band.b));
  const Eigen::Matrix<double, 6, 1> turn = now.chord.curve * move, &u = now.chord.slope;
  const double dT = input.tension(b) + now.pull.stiffness * u.dot(move), T = now.pull.tension;
  return {dT, -dT * u.head<3>() - T * (bone.w.cross(u.head<3>()) + turn.head<3>()),
          -dT * u.tail<3>() - T * (bone.w.cross(u.tail<3>()) + turn.tail<3>())};
}

/// Rate of the slope of E by the floating nodes, drawn bands left out.
Eigen::VectorXd Balanced::slope_rate(const Input& input, const Eigen::Matrix3Xd& v) const {
  Eigen::VectorXd g = Eigen::VectorXd::Zero(H_.rows());
  for (Index b = 0; b < static_cast<Index>(net_.bands.size()); ++b) {
    if (drawn_[b] >= 0) continue;
    const BandRate now = rate(b, input, v);
    if (row_[net_.bands[b].a] >= 0) g.segment<3>(3 * row_[net_.bands[b].a]) -= now.fa;
    if (row_[net_.bands[b].b] >= 0) g.segment<3>(3 * row_[net_.bands[b].b]) -= now.fb;
  }
  // Contacts: the normal turns with the bone and with the place on it.
  for (std::size_t c = 0; c < probe_.size(); ++c) {
    const NetContact& contact = rest_.contacts[c];
    const Motion& bone =
        input.link[static_cast<std::size_t>(net_.surfaces[contact.surface].link + 1)];
    const Vector3d move = v.col(contact.node) - bone.at(x(contact.node));
    g.segment<3>(3 * row_[contact.node]) -=
        contact.force * (bone.w.cross(probe_[c].normal) + probe_[c].curvature * move);
  }
  return g;
}

/// Rate of the contact forces: what of the slope's rate lies along the normals.
Eigen::VectorXd Balanced::contact_rate(const Input&, const Eigen::Matrix3Xd&,
                                       const Eigen::VectorXd& g) const {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(static_cast<Index>(probe_.size()));
  for (std::size_t k = 0; k < node_.size(); ++k) {
    Eigen::MatrixXd N(3, static_cast<Index>(touch_[k].size()));
    if (N.cols() == 0) continue;
    for (Index i = 0; i < N.cols(); ++i) N.col(i) = probe_[touch_[k][i]].normal;
    const Eigen::VectorXd f =
        N.completeOrthogonalDecomposition().solve(g.segment<3>(static_cast<Index>(3 * k)));
    for (Index i = 0; i < N.cols(); ++i) force(touch_[k][i]) = f(i);
  }
  return force;
}

/// Rate of  tau = sum over links and their hinges of  ratio axis . (m - point x f).
Eigen::VectorXd Balanced::torque_rate(const Input& input, const Eigen::Matrix3Xd& v,
                                      const Eigen::VectorXd& g) const {
  Eigen::VectorXd tau = Eigen::VectorXd::Zero(coordinates_);
  // A force on a link: p its point, with their rates.
  const auto add = [&](int link, const Vector3d& p, const Vector3d& dp, const Vector3d& f,
                       const Vector3d& df) {
    const Vector3d m = p.cross(f), dm = dp.cross(f) + p.cross(df);
    for_each_hinge_to_base(tree_, link, [&](int i) {
      const LinkState<double>& hinge = state_[i];
      tau(tree_[i].coordinate) +=
          tree_[i].ratio * (input.axis[i].dot(m - hinge.point.cross(f)) +
                            hinge.axis.dot(dm - input.point[i].cross(f) - hinge.point.cross(df)));
    });
  };
  for (Index b = 0; b < static_cast<Index>(net_.bands.size()); ++b) {
    const NetBand& band = net_.bands[b];
    const internal::BandState& now = band_[b];
    const Vector3d a = x(band.a), e = x(band.b), va = v.col(band.a), vb = v.col(band.b);
    BandRate dF;
    Vector3d fa, fb;
    if (drawn_[b] >= 0) {  // it gives what the rest of the node asks for
      const int k = std::max(row_[band.a], row_[band.b]);
      const double share = 1.0;
      const Vector3d on_node = share * g.segment<3>(3 * k);
      fa = rest_.drawn[drawn_[b]].force, fb = -fa;
      dF.fa = row_[band.a] >= 0 ? on_node : Vector3d(-on_node);
      dF.fb = -dF.fa;
    } else {
      dF = rate(b, input, v);
      fa = -now.pull.tension * now.chord.slope.head<3>();
      fb = -now.pull.tension * now.chord.slope.tail<3>();
    }
    if (row_[band.a] < 0) add(net_.nodes[band.a].link, a, va, fa, dF.fa);
    if (row_[band.b] < 0) add(net_.nodes[band.b].link, e, vb, fb, dF.fb);
    if (!now.chord.bent || drawn_[b] >= 0) continue;
    add(net_.surfaces[band.over].link, a, va, -fa, -dF.fa);
    add(net_.surfaces[band.over].link, e, vb, -fb, -dF.fb);
  }
  const Eigen::VectorXd dforce = contact_rate(input, v, g);
  for (std::size_t c = 0; c < probe_.size(); ++c) {
    const NetContact& contact = rest_.contacts[c];
    const Motion& bone =
        input.link[static_cast<std::size_t>(net_.surfaces[contact.surface].link + 1)];
    const Vector3d p = x(contact.node), vp = v.col(contact.node);
    const Vector3d dn = bone.w.cross(probe_[c].normal) + probe_[c].curvature * (vp - bone.at(p));
    add(net_.surfaces[contact.surface].link, p, vp, -contact.force * probe_[c].normal,
        -dforce(static_cast<Index>(c)) * probe_[c].normal - contact.force * dn);
  }
  return tau;
}

NetSlopes Balanced::slopes(const std::vector<Input>& inputs) const {
  const auto count = static_cast<Index>(inputs.size());
  const auto bands = static_cast<Index>(net_.bands.size());
  NetSlopes out{Eigen::MatrixXd(3 * rest_.x.cols(), count), Eigen::MatrixXd(bands, count),
                Eigen::MatrixXd(coordinates_, count)};
  for (Index i = 0; i < count; ++i) {
    const Input& input = inputs[static_cast<std::size_t>(i)];
    Eigen::Matrix3Xd v = velocities(input);
    // What bones force upon nodes: normals stay on the surface, drawn nodes follow their exit.
    for (std::size_t k = 0; k < node_.size(); ++k) {
      if (exit_[k] >= 0) v.col(node_[k]) = v.col(exit_[k]);
      Eigen::MatrixXd N(3, static_cast<Index>(touch_[k].size()));
      Eigen::VectorXd along(N.cols());
      for (Index c = 0; c < N.cols(); ++c) {
        const NetContact& contact = rest_.contacts[touch_[k][c]];
        const std::size_t link = static_cast<std::size_t>(net_.surfaces[contact.surface].link + 1);
        N.col(c) = probe_[touch_[k][c]].normal;
        along(c) = N.col(c).dot(input.link[link].at(x(contact.node)));
      }
      if (N.cols() > 0)
        v.col(node_[k]) = N.transpose().completeOrthogonalDecomposition().solve(along);
    }
    // What balance then asks for along the free directions.
    const Eigen::VectorXd move = Z_ * reduced_.solve(-Z_.transpose() * slope_rate(input, v));
    for (std::size_t k = 0; k < node_.size(); ++k)
      v.col(node_[k]) += move.segment<3>(static_cast<Index>(3 * k));
    const Eigen::VectorXd g = slope_rate(input, v);
    out.x.col(i) = Eigen::Map<const Eigen::VectorXd>(v.data(), v.size());
    for (Index b = 0; b < bands; ++b)
      out.tension(b, i) = drawn_[b] >= 0 ? 0 : rate(b, input, v).tension;
    out.tau.col(i) = torque_rate(input, v, g);
  }
  return out;
}

}  // namespace

NetDerivatives net_derivatives(const Net& net, const Tree<double>& tree,
                               const TreeState<double>& state, const NetDrive& drive,
                               const NetEquilibrium& rest, int coordinates) {
  require(rest.status != NetStatus::kStalled, "net {}: not balanced, residual {} N", net.name,
          rest.residual);
  const Balanced balanced(net, tree, state, drive, rest, coordinates);
  std::vector<Input> posture, pull, EA, slack;
  for (int l = 0; l < coordinates; ++l) posture.push_back(balanced.turning(l));
  for (int m = 0; m < static_cast<int>(net.muscles.size()); ++m) {
    pull.push_back(balanced.still());
    for (std::size_t b = 0; b < net.bands.size(); ++b)
      if (net.bands[b].muscle == m)
        pull.back().tension(static_cast<Index>(b)) =
            balanced.by_length(m) ? balanced.by_slack(static_cast<Index>(b)) : 1;
  }
  for (Index b = 0; b < static_cast<Index>(net.bands.size()); ++b) {
    EA.push_back(balanced.still());
    EA.back().tension(b) = balanced.by_EA(b);
    slack.push_back(balanced.still());
    const int m = net.bands[b].muscle;
    slack.back().tension(b) = m >= 0 && balanced.by_length(m) ? 0 : balanced.by_slack(b);
  }
  return {balanced.slopes(posture), balanced.slopes(pull), balanced.slopes(EA),
          balanced.slopes(slack)};
}

}  // namespace thenar
