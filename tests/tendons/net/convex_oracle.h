#pragma once

/// A net without bones at rest, found by another way: as a convex program. Shares no code with the
/// solver of nets.
///
/// With an elongation e_b of every passive band and a length s_m of every pulling muscle,
///   minimise    sum phi_b(e_b) + sum t_m s_m
///   subject to  (e_b + slack_b)^2 >= |x_a - x_b|^2,  e_b >= 0
///               s_m^2 >= |x_a - x_b|^2 + 1e-18 m^2,  s_m >= 0,
/// whose functions are smooth, by Ipopt in millimetres and newtons. Its barrier leaves forces of
/// (1e-10 mJ) / (what a slack band lacks to be taut), too much for places to 1e-8 m. So its answer
/// is made exact by Newton steps in which the forces are summed in long double: E is convex, so
/// places where every force balances are a minimum, wherever they came from.

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Cholesky>

#include "hand/chain.h"
#include "solvers/nonlinear_program.h"
#include "tendons/net/net.h"

namespace thenar::oracle {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A band as the program sees it.
struct Line {
  int a, b;          // nodes
  double pull = -1;  // of a muscle given by tension; < 0: it follows its law [N]
  double slack, EA, toe;
};

/// Value, slope and second slope of phi, or of t L; in the unit of length of its arguments.
struct Stretch {
  double energy, tension, stiffness;
};

inline Stretch stretch(const Line& line, double slack, double elongation) {
  if (line.pull >= 0) return {line.pull * elongation, line.pull, 0};
  const double e = std::max(elongation, 0.0) / slack, E = line.EA;
  if (e <= line.toe && line.toe > 0) {
    const double q = e / line.toe;
    return {E * slack * e * e * q / 6, E * e * q / 2, E * q / slack};
  }
  const double h = line.toe / 2;
  return {E * slack * (e * e / 2 - h * e + line.toe * line.toe / 6), E * (e - h),
          elongation > 0 ? E / slack : 0};
}

/// The net at one posture under one drive.
struct Scene {
  std::vector<Line> lines;
  Matrix3Xd x;           // nodes, floating ones carried by their links [m]
  std::vector<int> row;  // of a floating node, -1: fixed
  int free = 0;
};

inline Scene pose(const Net& net, const TreeState<double>& state, const NetDrive& drive) {
  Scene scene;
  scene.x.resize(3, static_cast<Index>(net.nodes.size()));
  for (const NetNode& node : net.nodes) {
    scene.x.col(static_cast<Index>(scene.row.size())) = moved(state, node.link, node.p);
    scene.row.push_back(node.free ? scene.free++ : -1);
  }
  for (const NetBand& band : net.bands) {
    Line line{band.a, band.b, -1, band.slack, band.EA, band.toe};
    const bool by_length =
        band.muscle >= 0 && drive.length.size() > 0 && std::isfinite(drive.length(band.muscle));
    if (by_length) line.slack = drive.length(band.muscle);
    if (band.muscle >= 0 && !by_length) line.pull = drive.tension(band.muscle), line.slack = 0;
    scene.lines.push_back(line);
  }
  return scene;
}

/// The convex program. Variables: places of floating nodes, then one of every line [mm].
class Program {
 public:
  explicit Program(const Scene& scene) : scene_(scene), lines_(scene.lines.size()) {
    home_ = start();
  }

  [[nodiscard]] Matrix3Xd solve(const std::vector<double>& apexes) {
    NonlinearProgram program;
    const double inf = std::numeric_limits<double>::infinity();
    program.lower = VectorXd::Constant(size(), -inf);
    program.lower.tail(lines()).setZero();
    program.upper = VectorXd::Constant(size(), inf);
    program.row_lower = VectorXd::Zero(lines());
    program.row_upper = VectorXd::Constant(lines(), inf);
    program.objective = [this](const VectorXd& v) { return objective(v); };
    program.gradient = [this](const VectorXd& v) { return gradient(v); };
    program.constraints = [this](const VectorXd& v) { return constraints(v); };
    program.jacobian = [this](const VectorXd& v) { return jacobian(v); };
    program.hessian = [this](const VectorXd& v, double factor, const VectorXd& lambda) {
      return hessian(v, factor, lambda);
    };
    VectorXd v = home_;
    for (double apex : apexes) {
      apex_ = apex;
      for (Index i = 0; i < lines(); ++i)
        v(own(i)) = std::max(blunt_length(places(v), i) - kMm * line(i).slack, 0.0) + apex;
      const NonlinearResult result = solve_ipopt(program, v, {1e-8, 1e-6, 100});
      if (result.status == Status::kSolved) v = result.x;
    }
    return places(v) / kMm;
  }

 private:
  static constexpr double kMm = 1000, kTether = 1e-5;  // [1/m], [N/mm]
  [[nodiscard]] Index lines() const { return static_cast<Index>(lines_); }
  [[nodiscard]] Index size() const { return 3 * scene_.free + lines(); }
  [[nodiscard]] Index own(Index i) const { return 3 * scene_.free + i; }
  [[nodiscard]] const Line& line(Index i) const {
    return scene_.lines[static_cast<std::size_t>(i)];
  }
  [[nodiscard]] Index place(int node) const {
    return 3 * scene_.row[static_cast<std::size_t>(node)];
  }
  /// Length that the variable of line i stands for.
  [[nodiscard]] double reach(const VectorXd& v, Index i) const {
    return v(own(i)) + kMm * line(i).slack;
  }

  [[nodiscard]] Matrix3Xd places(const VectorXd& v) const {
    Matrix3Xd x = kMm * scene_.x;
    for (int i = 0; i < static_cast<int>(scene_.row.size()); ++i)
      if (place(i) >= 0) x.col(i) = v.segment<3>(place(i));
    return x;
  }

  /// Nodes with their links.
  [[nodiscard]] VectorXd start() const {
    VectorXd v = VectorXd::Zero(size());
    for (int i = 0; i < static_cast<int>(scene_.row.size()); ++i)
      if (place(i) >= 0) v.segment<3>(place(i)) = kMm * scene_.x.col(i);
    return v;
  }

  [[nodiscard]] double objective(const VectorXd& v) const {
    double sum = kTether / 2 * (v - home_).head(own(0)).squaredNorm();
    for (Index i = 0; i < lines(); ++i)
      sum += stretch(line(i), kMm * line(i).slack, v(own(i))).energy;
    return sum;
  }

  [[nodiscard]] VectorXd gradient(const VectorXd& v) const {
    VectorXd g = VectorXd::Zero(size());
    g.head(own(0)) = kTether * (v - home_).head(own(0));
    for (Index i = 0; i < lines(); ++i)
      g(own(i)) = stretch(line(i), kMm * line(i).slack, v(own(i))).tension;
    return g;
  }

  /// sqrt(|x_a - x_b|^2 + apex_^2)
  [[nodiscard]] double blunt_length(const Matrix3Xd& x, Index i) const {
    return std::hypot((x.col(line(i).a) - x.col(line(i).b)).norm(), apex_);
  }

  [[nodiscard]] VectorXd constraints(const VectorXd& v) const {
    const Matrix3Xd x = places(v);
    VectorXd c(lines());
    for (Index i = 0; i < lines(); ++i) c(i) = v(own(i)) + kMm * line(i).slack - blunt_length(x, i);
    return c;
  }

  [[nodiscard]] MatrixXd jacobian(const VectorXd& v) const {
    const Matrix3Xd x = places(v);
    MatrixXd J = MatrixXd::Zero(lines(), size());
    for (Index i = 0; i < lines(); ++i) {
      const Eigen::RowVector3d u =
          (x.col(line(i).a) - x.col(line(i).b)).transpose() / blunt_length(x, i);
      J(i, own(i)) = 1;
      if (place(line(i).a) >= 0) J.block<1, 3>(i, place(line(i).a)) -= u;
      if (place(line(i).b) >= 0) J.block<1, 3>(i, place(line(i).b)) += u;
    }
    return J;
  }

  [[nodiscard]] MatrixXd hessian(const VectorXd& v, double factor, const VectorXd& lambda) const {
    const Matrix3Xd x = places(v);
    MatrixXd H = MatrixXd::Zero(size(), size());
    H.diagonal().head(own(0)).setConstant(factor * kTether);
    for (Index i = 0; i < lines(); ++i) {
      H(own(i), own(i)) = factor * stretch(line(i), kMm * line(i).slack, v(own(i))).stiffness;
      const double L = blunt_length(x, i);
      const Eigen::Vector3d u = (x.col(line(i).a) - x.col(line(i).b)) / L;
      const Matrix3d K = (Matrix3d::Identity() - u * u.transpose()) / L;
      const Index ends[] = {place(line(i).a), place(line(i).b)};
      for (int p = 0; p < 2; ++p)
        for (int q = 0; q < 2; ++q)
          if (ends[p] >= 0 && ends[q] >= 0)
            H.block<3, 3>(ends[p], ends[q]) += (p == q ? -1 : 1) * lambda(i) * K;
    }
    return H;
  }

  const Scene& scene_;
  std::size_t lines_;
  double apex_ = 1;  // [mm]
  VectorXd home_;
};

/// A minimum with what tells that it is one.
struct Rest {
  Matrix3Xd x;           // [m]
  VectorXd tension;      // [N]
  double energy = 0;     // [J]
  double residual = 0;   // largest force that is left on a node [N]
  MatrixXd H;            // stiffness of the free nodes; collapsed ones count as fixed [N/m]
  MatrixXd H_sure;       // the same of bands that pull with more than 1e-8 N [N/m]
  std::vector<int> row;  // of a free node that is not collapsed in
  int collapsed = 0;     // nodes in an exit
};

/// Sums forces in long double.
class Exact {
 public:
  Exact(const Scene& scene, const Matrix3Xd& near) : scene_(scene), exit_(scene.row.size(), -1) {
    x_ = near.cast<long double>();
    for (Index i = 0; i < x_.cols(); ++i)  // Ipopt has seen them in other units
      if (scene.row[static_cast<std::size_t>(i)] < 0)
        x_.col(i) = scene.x.col(i).cast<long double>();
  }

  /// Nodes within `in_exit` [m] of the exit of a muscle count as collapsed into it. Those that the
  /// rest of their bands pull out again are let go, and the nearest one is collapsed in where
  /// forces are left.
  [[nodiscard]] Rest solve(double in_exit) {
    while (draw(in_exit)) continue;
    for (int round = 0; round < 12; ++round) {
      newton();
      const bool rests = rest_.residual < 1e-11;
      if (!(rests ? let_go() : draw(1e-3))) break;
    }
    rest_.x = x_.cast<double>();
    rest_.energy = static_cast<double>(energy_);
    return rest_;
  }

 private:
  using Places = Eigen::Matrix<long double, 3, Eigen::Dynamic>;
  using Longs = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

  static constexpr double kSure = 1e-8;  // [N]

  [[nodiscard]] Places step_from(const Places& from, const VectorXd& d) const {
    Places x = from;
    for (Index i = 0; i < x.cols(); ++i)
      if (row(i) >= 0) x.col(i) += d.segment<3>(3 * row(i)).cast<long double>();
    return x;
  }
  [[nodiscard]] int row(Index node) const { return rest_.row[static_cast<std::size_t>(node)]; }

  /// Tension by the law, with its slope.
  static void law(const Line& line, long double length, long double& T, long double& k) {
    T = line.pull, k = 0;
    if (line.pull >= 0) return;
    const long double s = line.slack, e = (length - s) / s, toe = line.toe;
    T = e <= 0 ? 0 : e < toe ? line.EA * e * e / (2 * toe) : line.EA * (e - toe / 2);
    k = e <= 0 ? 0 : e < toe ? line.EA * e / (toe * s) : line.EA / s;
  }

  static long double law_energy(const Line& line, long double length) {
    if (line.pull >= 0) return line.pull * length;
    const long double s = line.slack, e = (length - s) / s, toe = line.toe, h = toe / 2;
    if (e <= 0) return 0;
    return line.EA * s * (e < toe ? e * e * e / (6 * toe) : ((e - h) * (e - h) + h * h / 3) / 2);
  }

  void evaluate(const Places& x) {
    x_ = x;
    g_ = Longs::Zero(rows_);
    rest_.H = rest_.H_sure = MatrixXd::Zero(rows_, rows_);
    rest_.tension.resize(static_cast<Index>(scene_.lines.size()));
    energy_ = 0;
    pull_.setZero(3, x.cols());
    Index number = 0;
    for (const Line& line : scene_.lines) add(line, rest_.tension(number++));
    rest_.residual = 0;
    for (Index i = 0; i < rows_; i += 3)
      rest_.residual = std::max<double>(rest_.residual, g_.segment<3>(i).norm());
  }

  void add(const Line& line, double& tension) {
    const Eigen::Matrix<long double, 3, 1> d = x_.col(line.a) - x_.col(line.b);
    const long double L = d.norm();
    long double T = 0, k = 0;
    law(line, L, T, k);
    tension = static_cast<double>(T);
    energy_ += law_energy(line, L);
    if (T <= 0 || L == 0) return;
    const Eigen::Matrix<long double, 3, 1> u = d / L;
    pull_.col(line.a) += (T * u).cast<double>();
    const Eigen::Vector3d ud = u.cast<double>();
    const auto across = static_cast<double>(T / L), along = static_cast<double>(k);
    const Matrix3d K = (along - across) * ud * ud.transpose() + across * Matrix3d::Identity();
    const int ends[] = {row(line.a), row(line.b)};
    for (int p = 0; p < 2; ++p) {
      if (ends[p] < 0) continue;
      g_.segment<3>(3 * ends[p]) += (p == 0 ? T : -T) * u;
      for (int q = 0; q < 2; ++q) {
        if (ends[q] < 0) continue;
        rest_.H.block<3, 3>(3 * ends[p], 3 * ends[q]) += (p == q ? 1 : -1) * K;
        if (T > kSure) rest_.H_sure.block<3, 3>(3 * ends[p], 3 * ends[q]) += (p == q ? 1 : -1) * K;
      }
    }
    pull_.col(line.b) -= (T * u).cast<double>();
  }

  /// Newton's steps, shortened until E falls (Armijo) or half of the force is gone. The extra
  /// stiffness fades with the force; what is left of it keeps loose nodes where they are.
  void newton() {
    number_rows();
    evaluate(x_);
    for (int step = 0; step < 100 && rest_.residual > 1e-15; ++step) {
      const double extra = 1e-6 + std::min(1e3 * rest_.residual, 10.0);  // [N/m]
      const MatrixXd A = rest_.H + extra * MatrixXd::Identity(rows_, rows_);
      const VectorXd d = A.ldlt().solve(-g_.cast<double>());
      const long double slope = g_.dot(d.cast<long double>()), energy = energy_;
      const Places from = x_;
      const double before = rest_.residual;
      double part = 1;
      for (; part > 1e-9; part /= 2) {
        evaluate(step_from(from, part * d));
        if (rest_.residual < before / 2 || energy_ < energy + 1e-4L * part * slope) break;
      }
      if (part > 1e-9) continue;
      evaluate(from);
      break;
    }
  }

  void number_rows() {
    rest_.row.assign(exit_.size(), -1);
    rest_.collapsed = rows_ = 0;
    for (std::size_t i = 0; i < exit_.size(); ++i) {
      if (scene_.row[i] >= 0 && exit_[i] < 0) rest_.row[i] = rows_, rows_ += 1;
      if (exit_[i] >= 0) ++rest_.collapsed;
    }
    rows_ *= 3;
  }

  /// Puts the node that is nearest to the exit of one of its muscles into it, if it is that near.
  bool draw(double near) {
    const Line* nearest = nullptr;
    for (const Line& line : scene_.lines) {
      if (line.pull <= 0 || scene_.row[line.a] < 0 || scene_.row[line.b] >= 0) continue;
      const double length = static_cast<double>((x_.col(line.a) - x_.col(line.b)).norm());
      if (exit_[line.a] < 0 && length < near) nearest = &line, near = length;
    }
    if (nearest == nullptr) return false;
    exit_[nearest->a] = nearest->b;
    x_.col(nearest->a) = x_.col(nearest->b);
    return true;
  }

  /// A node stays in its exit if the rest of its bands pulls with no more than the muscles there.
  bool let_go() {
    VectorXd most = VectorXd::Zero(x_.cols());
    for (const Line& line : scene_.lines)
      if (line.pull > 0 && exit_[line.a] == line.b) most(line.a) += line.pull;
    bool any = false;
    for (Index i = 0; i < x_.cols(); ++i) {
      const double over = pull_.col(i).norm() - most(i);
      if (exit_[static_cast<std::size_t>(i)] < 0 || over <= 0) continue;
      any = true;
      rest_.residual = std::max(rest_.residual, over);
      exit_[static_cast<std::size_t>(i)] = -1;
      x_.col(i) -= (1e-5 * pull_.col(i).normalized()).cast<long double>();
    }
    return any;
  }

  const Scene& scene_;
  std::vector<int> exit_;  // of each node: the node that it is collapsed into, or -1
  Places x_;
  Longs g_;
  Matrix3Xd pull_;  // of all bands on every node, reversed [N]
  long double energy_ = 0;
  int rows_ = 0;
  Rest rest_;
};

/// The net at rest.
inline Rest rest_of(const Net& net, const TreeState<double>& state, const NetDrive& drive) {
  const Scene scene = pose(net, state, drive);
  Rest best;
  best.residual = std::numeric_limits<double>::infinity();
  const std::vector<double> plans[] = {
      {1, 0.1, 0.01}, {0.3, 0.03, 0.003}, {3, 0.01}, {0.1}};  // [mm]
  for (const std::vector<double>& apexes : plans) {
    const Matrix3Xd near = Program(scene).solve(apexes);
    for (double in_exit : {1e-4, 1e-6}) {
      const Rest rest = Exact(scene, near).solve(in_exit);
      if (rest.residual < best.residual) best = rest;
      if (best.residual < 1e-11) return best;
    }
  }
  return best;
}

}  // namespace thenar::oracle
