#include "pads/tissue_element.h"

#include <cmath>

#include <Eigen/LU>

#include "base/error.h"

namespace thenar {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Shape functions at Gauss points.
struct ElementTable {
  int nodes = 8, points = 8;
  std::vector<double> slope;   // dN/dxi (points, nodes, 3)
  std::vector<double> weight;  // (points)
  std::vector<double> centre;  // dN/dxi at xi = 0 (nodes, 3)
  std::vector<double> value;   // N (points, nodes)
  std::vector<Vector3d> xi;    // (points)
};

namespace {

/// Lagrange functions of one axis, of degree 1 or 2, and their slopes at x in -1..1.
struct Axis {
  std::array<double, 3> value{}, slope{};
};
Axis axis_at(int degree, double x) {
  if (degree == 1) return {{(1 - x) / 2, (1 + x) / 2, 0}, {-0.5, 0.5, 0}};
  return {{x * (x - 1) / 2, 1 - x * x, x * (x + 1) / 2}, {x - 0.5, -2 * x, x + 0.5}};
}

/// Values and slopes of all nodes at a point, added to the lists.
void add_shapes(int degree, const Vector3d& xi, std::vector<double>& value,
                std::vector<double>& slope) {
  const std::array<Axis, 3> axes{axis_at(degree, xi[0]), axis_at(degree, xi[1]),
                                 axis_at(degree, xi[2])};
  const auto n = static_cast<std::size_t>(degree + 1);
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i) {
        value.push_back(axes[0].value[i] * axes[1].value[j] * axes[2].value[k]);
        slope.push_back(axes[0].slope[i] * axes[1].value[j] * axes[2].value[k]);
        slope.push_back(axes[0].value[i] * axes[1].slope[j] * axes[2].value[k]);
        slope.push_back(axes[0].value[i] * axes[1].value[j] * axes[2].slope[k]);
      }
}

ElementTable build_table(int degree) {
  ElementTable table;
  const int n = degree + 1;
  table.nodes = table.points = n * n * n;
  const double at = degree == 1 ? 1 / std::sqrt(3.0) : std::sqrt(0.6);
  const std::array<double, 3> x = degree == 1 ? std::array{-at, at, 0.0} : std::array{-at, 0.0, at};
  const std::array<double, 3> w =
      degree == 1 ? std::array{1.0, 1.0, 0.0} : std::array{5.0 / 9, 8.0 / 9, 5.0 / 9};
  for (std::size_t k = 0; k < static_cast<std::size_t>(n); ++k)
    for (std::size_t j = 0; j < static_cast<std::size_t>(n); ++j)
      for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
        table.xi.emplace_back(x[i], x[j], x[k]);
        table.weight.push_back(w[i] * w[j] * w[k]);
        add_shapes(degree, table.xi.back(), table.value, table.slope);
      }
  std::vector<double> value_of_centre;
  add_shapes(degree, Vector3d(0, 0, 0), value_of_centre, table.centre);
  return table;
}

/// Nodes as columns at the slopes of one point: dX/dxi.
Matrix3d jacobian_of(const double* slope, const Eigen::Matrix3Xd& X) {
  Matrix3d out = Matrix3d::Zero();
  for (Eigen::Index a = 0; a < X.cols(); ++a)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) out(i, j) += X(i, a) * slope[3 * a + j];
  return out;
}

/// dN/dX = (dX/dxi)^-T dN/dxi of all nodes. @return det dX/dxi
double map_slopes(const double* slope, const Eigen::Matrix3Xd& X, std::vector<double>& out) {
  const Matrix3d inverse = jacobian_of(slope, X).inverse();
  for (Eigen::Index a = 0; a < X.cols(); ++a)
    for (int j = 0; j < 3; ++j) {
      double sum = 0;
      for (int i = 0; i < 3; ++i) sum += slope[3 * a + i] * inverse(i, j);
      out.push_back(sum);
    }
  return jacobian_of(slope, X).determinant();
}

/// Kinematics at one point: F = 1 + sum u_a dN_a/dX, and spatial gradients F^-T dN/dX.
template <int N>
struct Point {
  Matrix3d F;
  double J = 0;
  std::array<double, 3 * N> g;  // (nodes, 3)
};

template <int N>
Matrix3d deformation(const double* gradient, const double* u) {
  Matrix3d F = Matrix3d::Identity();
  for (int a = 0; a < N; ++a)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) F(i, j) += u[3 * a + i] * gradient[3 * a + j];
  return F;
}

template <int N>
void push_gradients(const double* gradient, Point<N>& point) {
  const Matrix3d inverse = point.F.inverse();
  for (int a = 0; a < N; ++a)
    for (int j = 0; j < 3; ++j)
      point.g[static_cast<std::size_t>(3 * a + j)] = gradient[3 * a] * inverse(0, j) +
                                                     gradient[3 * a + 1] * inverse(1, j) +
                                                     gradient[3 * a + 2] * inverse(2, j);
}

/// force += w B' tau.
template <int N>
void add_force(double w, const Voigt& tau, const double* g, double* force) {
  for (int a = 0; a < N; ++a, g += 3, force += 3) {
    force[0] += w * (g[0] * tau[0] + g[1] * tau[3] + g[2] * tau[5]);
    force[1] += w * (g[0] * tau[3] + g[1] * tau[1] + g[2] * tau[4]);
    force[2] += w * (g[0] * tau[5] + g[1] * tau[4] + g[2] * tau[2]);
  }
}

/// Upper triangle of stiffness += w (B' c B + (g_a . tau g_b) 1).
template <int N>
void add_stiffness(double w, const VoigtTangent& c, const Voigt& tau, const double* g, double* K) {
  constexpr int kRows = 3 * N;
  // Columns of a matrix are stored one after the other.
  for (int b = 0; b < N; ++b) {
    const double x = w * g[3 * b], y = w * g[3 * b + 1], z = w * g[3 * b + 2];
    // T = c B_b (6 x 3), and tau g_b.
    double T[3][6];
    for (int p = 0; p < 6; ++p) {
      T[0][p] = c(p, 0) * x + c(p, 3) * y + c(p, 5) * z;
      T[1][p] = c(p, 1) * y + c(p, 3) * x + c(p, 4) * z;
      T[2][p] = c(p, 2) * z + c(p, 4) * y + c(p, 5) * x;
    }
    const double s0 = tau[0] * x + tau[3] * y + tau[5] * z;
    const double s1 = tau[3] * x + tau[1] * y + tau[4] * z;
    const double s2 = tau[5] * x + tau[4] * y + tau[2] * z;
    for (int a = 0; a <= b; ++a) {
      const double* h = g + 3 * a;
      const double geometric = h[0] * s0 + h[1] * s1 + h[2] * s2;
      for (int j = 0; j < 3; ++j) {
        double* column = K + (3 * b + j) * kRows + 3 * a;
        const double* t = T[j];
        column[0] += h[0] * t[0] + h[1] * t[3] + h[2] * t[5];
        column[1] += h[1] * t[1] + h[0] * t[3] + h[2] * t[4];
        column[2] += h[2] * t[2] + h[1] * t[4] + h[0] * t[5];
        column[j] += geometric;
      }
    }
  }
}

/// c += s 1 x 1 - r 2 I.
void add_pressure_tangent(double s, double r, VoigtTangent& c) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) c(i, j) += s;
    c(i, i) -= 2 * r;
    c(i + 3, i + 3) -= r;
  }
}

/// What stands for J in the volumetric energy.
template <int N>
class Dilatation {
 public:
  Dilatation(HexElement kind, const ElementShape& shape, const Tissue& tissue,
             const std::array<Point<N>, N>& points, const double* u,
             const Eigen::Vector4d* tangent_pressure)
      : kind_(kind), shape_(shape), tangent_(tangent_pressure) {
    const double K = bulk_modulus(tissue);
    if (kind == HexElement::kDisplacement) {
      for (int q = 0; q < N; ++q)
        at_[static_cast<std::size_t>(q)] =
            volumetric_response(K, points[static_cast<std::size_t>(q)].J);
    } else if (kind == HexElement::kMeanDilatation) {
      volume_ = 0;
      double sum = 0;
      for (std::size_t q = 0; q < N; ++q) {
        volume_ += shape.volume[q];
        sum += shape.volume[q] * points[q].J;
      }
      at_.fill(volumetric_response(K, sum / volume_));
    } else if (kind == HexElement::kCentroidDilatation) {
      centre_.F = deformation<N>(shape.centre_gradient.data(), u);
      centre_.J = centre_.F.determinant();
      volume_ = 0;
      for (const double w : shape.volume) volume_ += w;
      fits_ = centre_.J > 0;
      if (!fits_) return;
      push_gradients<N>(shape.centre_gradient.data(), centre_);
      at_.fill(volumetric_response(K, centre_.J));
    } else {
      project(K, points);
    }
  }

  /// Whether the dilatation is above 0 everywhere.
  [[nodiscard]] bool fits() const { return fits_; }
  [[nodiscard]] double energy() const {
    double sum = 0;
    for (std::size_t q = 0; q < N; ++q) sum += shape_.volume[q] * at_[q].energy;
    return sum;
  }
  /// Pressure that acts with J at a point.
  [[nodiscard]] double pressure(std::size_t q) const {
    if (kind_ == HexElement::kCentroidDilatation) return 0;
    return kind_ == HexElement::kQuadratic
               ? shape_.modes.row(static_cast<Eigen::Index>(q)).dot(pressure_)
               : at_[q].pressure;
  }
  /// The same as the stiffness sees it.
  [[nodiscard]] double tangent_pressure(std::size_t q) const {
    if (tangent_ == nullptr || kind_ == HexElement::kDisplacement ||
        kind_ == HexElement::kCentroidDilatation)
      return pressure(q);
    return kind_ == HexElement::kQuadratic
               ? shape_.modes.row(static_cast<Eigen::Index>(q)).dot(*tangent_)
               : (*tangent_)[0];
  }
  /// p + dp of a change whose spatial gradient has the trace `divergence` (points), linearised.
  [[nodiscard]] Eigen::Vector4d linear_pressure(const std::array<Point<N>, N>& points,
                                                const double* du) const {
    Eigen::Vector4d out(0, 0, 0, 0);
    const auto divergence = [&](const Point<N>& at) {
      double sum = 0;
      for (std::size_t i = 0; i < 3 * N; ++i) sum += at.g[i] * du[i];
      return sum;
    };
    if (kind_ == HexElement::kCentroidDilatation) {
      out[0] = at_[0].pressure + at_[0].stiffness * centre_.J * divergence(centre_);
    } else if (kind_ == HexElement::kMeanDilatation) {
      double sum = 0;
      for (std::size_t q = 0; q < N; ++q)
        sum += shape_.volume[q] * points[q].J * divergence(points[q]);
      out[0] = at_[0].pressure + at_[0].stiffness * sum / volume_;
    } else if (kind_ == HexElement::kQuadratic) {
      Eigen::Vector4d mean(0, 0, 0, 0), p(0, 0, 0, 0);
      for (std::size_t q = 0; q < N; ++q)
        mean += shape_.volume[q] * points[q].J * divergence(points[q]) *
                shape_.modes.row(static_cast<Eigen::Index>(q)).transpose();
      const Eigen::Vector4d theta = shape_.modes_inverse * mean;
      for (std::size_t q = 0; q < N; ++q) {
        const Eigen::Vector4d mode = shape_.modes.row(static_cast<Eigen::Index>(q));
        p += shape_.volume[q] * (at_[q].pressure + at_[q].stiffness * mode.dot(theta)) * mode;
      }
      out = shape_.modes_inverse * p;
    }
    return out;
  }
  /// U'' J^2 at a point, where J is its own.
  [[nodiscard]] double own_stiffness(std::size_t q, double J) const {
    return kind_ == HexElement::kDisplacement ? at_[q].stiffness * J * J : 0;
  }

  /// Forces and stiffness that are no stress at a Gauss point.
  void add(const std::array<Point<N>, N>& points, bool with_stiffness, double* force,
           double* K) const {
    if (kind_ == HexElement::kCentroidDilatation) {
      Voigt tau = Voigt::Zero();
      tau.head<3>().setConstant(at_[0].pressure * centre_.J);
      add_force<N>(volume_, tau, centre_.g.data(), force);
      if (!with_stiffness) return;
      VoigtTangent c = VoigtTangent::Zero();
      const double pJ = (tangent_ != nullptr ? (*tangent_)[0] : at_[0].pressure) * centre_.J;
      tau.head<3>().setConstant(pJ);
      add_pressure_tangent(at_[0].stiffness * centre_.J * centre_.J + pJ, pJ, c);
      add_stiffness<N>(volume_, c, tau, centre_.g.data(), K);
    } else if (kind_ == HexElement::kMeanDilatation && with_stiffness) {
      std::array<double, 3 * N> b{};
      for (std::size_t q = 0; q < N; ++q) {
        const double w = shape_.volume[q] * points[q].J;
        for (std::size_t i = 0; i < 3 * N; ++i) b[i] += w * points[q].g[i];
      }
      add_square(at_[0].stiffness / volume_, b.data(), b.data(), K);
    } else if (kind_ == HexElement::kQuadratic && with_stiffness) {
      add_modes(points, K);
    }
  }

 private:
  /// K += s b c', upper triangle.
  static void add_square(double s, const double* b, const double* c, double* K) {
    for (int j = 0; j < 3 * N; ++j)
      for (int i = 0; i <= j; ++i) K[j * 3 * N + i] += s * b[i] * c[j];
  }

  /// theta = projection of J on the modes; p = projection of U'(theta).
  void project(double bulk, const std::array<Point<N>, N>& points) {
    Eigen::Vector4d mean(0, 0, 0, 0);
    for (std::size_t q = 0; q < N; ++q)
      mean += shape_.volume[q] * points[q].J *
              shape_.modes.row(static_cast<Eigen::Index>(q)).transpose();
    const Eigen::Vector4d theta = shape_.modes_inverse * mean;
    Eigen::Vector4d p(0, 0, 0, 0);
    for (std::size_t q = 0; q < N; ++q) {
      const double J = shape_.modes.row(static_cast<Eigen::Index>(q)).dot(theta);
      if (!(J > 0)) {
        fits_ = false;
        return;
      }
      at_[q] = volumetric_response(bulk, J);
      p += shape_.volume[q] * at_[q].pressure *
           shape_.modes.row(static_cast<Eigen::Index>(q)).transpose();
    }
    pressure_ = shape_.modes_inverse * p;
  }

  void add_modes(const std::array<Point<N>, N>& points, double* K) const {
    // H = sum of U'' times modes, B = d (M theta) / d u.
    Eigen::Matrix4d H = Eigen::Matrix4d::Zero();
    Eigen::Matrix<double, 3 * N, 4> B = Eigen::Matrix<double, 3 * N, 4>::Zero();
    for (std::size_t q = 0; q < N; ++q) {
      const Eigen::Vector4d mode = shape_.modes.row(static_cast<Eigen::Index>(q));
      H += shape_.volume[q] * at_[q].stiffness * mode * mode.transpose();
      B += shape_.volume[q] * points[q].J *
           Eigen::Map<const Eigen::Matrix<double, 3 * N, 1>>(points[q].g.data()) * mode.transpose();
    }
    const Eigen::Matrix4d middle = shape_.modes_inverse * H * shape_.modes_inverse;
    const Eigen::Matrix<double, 3 * N, 4> left = B * middle;
    for (int m = 0; m < 4; ++m) add_square(1, left.col(m).data(), B.col(m).data(), K);
  }

  HexElement kind_;
  const ElementShape& shape_;
  const Eigen::Vector4d* tangent_;  // null: the pressure itself
  std::array<VolumetricResponse, N> at_;
  Point<N> centre_;
  Eigen::Vector4d pressure_ = Eigen::Vector4d::Zero();
  double volume_ = 0;
  bool fits_ = true;
};

template <int N>
void respond(HexElement kind, const ElementShape& shape, const Tissue& tissue, const double* u,
             const RelaxationStep* step, const ElementHistory* history,
             const Eigen::Vector4d* tangent_pressure, ElementAsk ask, ElementResponse& out) {
  // Deformation at all points.
  std::array<Point<N>, N> points;
  out.inverted = false;
  for (std::size_t q = 0; q < N; ++q) {
    const double* gradient = shape.gradient.data() + q * 3 * N;
    points[q].F = deformation<N>(gradient, u);
    points[q].J = points[q].F.determinant();
    if (!(points[q].J > 0)) {
      out.inverted = true;
      return;
    }
    if (ask != ElementAsk::kEnergy) push_gradients<N>(gradient, points[q]);
  }
  const Dilatation<N> dilatation(kind, shape, tissue, points, u, tangent_pressure);
  if (!dilatation.fits()) {
    out.inverted = true;
    return;
  }
  const bool with_force = ask != ElementAsk::kEnergy,
             with_stiffness = ask == ElementAsk::kStiffness;
  out.energy = dilatation.energy();
  if (with_force) out.force.setZero(3 * N);
  if (with_stiffness) out.stiffness.setZero(3 * N, 3 * N);
  if (with_force) out.elastic.resize(N);
  const double now = step != nullptr ? step->now : 1;
  const bool relaxes = step != nullptr && !step->decay.empty();
  IsochoricResponse iso;
  for (std::size_t q = 0; q < N; ++q) {
    const Point<N>& at = points[q];
    const double w = shape.volume[q];
    isochoric_response(tissue, at.F, with_stiffness, iso);
    out.energy += w * now * iso.energy;
    Voigt past = Voigt::Zero();  // stress that is left of the past, second Piola-Kirchhoff
    if (relaxes) {
      for (std::size_t i = 0; i < step->decay.size(); ++i)
        past += step->decay[i] * history->terms[i * N + q] - step->change[i] * history->elastic[q];
      const Matrix3d C = at.F.transpose() * at.F;
      out.energy += 0.5 * w * tensor_of(past).cwiseProduct(C - Matrix3d::Identity()).sum();
    }
    if (!with_force) continue;
    if (relaxes) {
      const Matrix3d inverse = at.F.inverse();
      out.elastic[q] = voigt_of(inverse * tensor_of(iso.stress) * inverse.transpose());
    }
    // Kirchhoff stress: isochoric now, of the past, and pressure.
    Voigt tau = now * iso.stress;
    if (relaxes) tau += voigt_of(at.F * tensor_of(past) * at.F.transpose());
    const double pJ = dilatation.pressure(q) * at.J;
    tau.head<3>().array() += pJ;
    add_force<N>(w, tau, at.g.data(), out.force.data());
    if (!with_stiffness) continue;
    iso.tangent *= now;
    const double tangent_pJ = dilatation.tangent_pressure(q) * at.J;
    tau.head<3>().array() += tangent_pJ - pJ;
    add_pressure_tangent(tangent_pJ + dilatation.own_stiffness(q, at.J), tangent_pJ, iso.tangent);
    add_stiffness<N>(w, iso.tangent, tau, at.g.data(), out.stiffness.data());
  }
  if (with_force) dilatation.add(points, with_stiffness, out.force.data(), out.stiffness.data());
}

template <int N>
Eigen::Vector4d linear_pressure_of(HexElement kind, const ElementShape& shape, const Tissue& tissue,
                                   const double* u, const double* du) {
  std::array<Point<N>, N> points;
  for (std::size_t q = 0; q < N; ++q) {
    const double* gradient = shape.gradient.data() + q * 3 * N;
    points[q].F = deformation<N>(gradient, u);
    points[q].J = points[q].F.determinant();
    push_gradients<N>(gradient, points[q]);
  }
  return Dilatation<N>(kind, shape, tissue, points, u, nullptr).linear_pressure(points, du);
}

}  // namespace

std::string name_of(HexElement kind) {
  constexpr std::array kNames{"Q1", "Q1P0", "F-bar", "Q2P1"};
  return kNames[static_cast<std::size_t>(kind)];
}

int nodes_of(HexElement kind) { return kind == HexElement::kQuadratic ? 27 : 8; }
int points_of(HexElement kind) { return nodes_of(kind); }

const ElementTable& element_table(HexElement kind) {
  static const ElementTable linear = build_table(1), quadratic = build_table(2);
  return kind == HexElement::kQuadratic ? quadratic : linear;
}

ElementShape element_shape(HexElement kind, const Eigen::Matrix3Xd& X) {
  const ElementTable& table = element_table(kind);
  ElementShape shape;
  for (int q = 0; q < table.points; ++q) {
    const double det = map_slopes(table.slope.data() + q * 3 * table.nodes, X, shape.gradient);
    require(det > 0, "an element folds onto itself at Gauss point {}: {:g} m^3", q, det);
    shape.volume.push_back(table.weight[static_cast<std::size_t>(q)] * det);
  }
  if (kind == HexElement::kCentroidDilatation)
    map_slopes(table.centre.data(), X, shape.centre_gradient);
  if (kind == HexElement::kQuadratic) {
    shape.modes.resize(table.points, 4);
    for (int q = 0; q < table.points; ++q)
      shape.modes.row(q) << 1, table.xi[static_cast<std::size_t>(q)].transpose();
    const Eigen::Map<const Eigen::VectorXd> w(shape.volume.data(), table.points);
    shape.modes_inverse = (shape.modes.transpose() * w.asDiagonal() * shape.modes).inverse();
  }
  return shape;
}

Matrix3d element_deformation(const ElementShape& shape, const Eigen::Matrix3Xd& u,
                             std::size_t point) {
  const auto nodes = static_cast<std::size_t>(u.cols());
  const double* gradient = shape.gradient.data() + point * 3 * nodes;
  return nodes == 27 ? deformation<27>(gradient, u.data()) : deformation<8>(gradient, u.data());
}

double shape_value(HexElement kind, std::size_t point, std::size_t node) {
  const ElementTable& table = element_table(kind);
  return table.value[point * static_cast<std::size_t>(table.nodes) + node];
}

void element_response(HexElement kind, const ElementShape& shape, const Tissue& tissue,
                      const Eigen::Matrix3Xd& u, const RelaxationStep* step,
                      const ElementHistory* history, const Eigen::Vector4d* tangent_pressure,
                      ElementAsk ask, ElementResponse& out) {
  if (nodes_of(kind) == 27)
    respond<27>(kind, shape, tissue, u.data(), step, history, tangent_pressure, ask, out);
  else
    respond<8>(kind, shape, tissue, u.data(), step, history, tangent_pressure, ask, out);
}

Eigen::Vector4d linear_pressure(HexElement kind, const ElementShape& shape, const Tissue& tissue,
                                const Eigen::Matrix3Xd& u, const Eigen::Matrix3Xd& du) {
  if (nodes_of(kind) == 27) return linear_pressure_of<27>(kind, shape, tissue, u.data(), du.data());
  return linear_pressure_of<8>(kind, shape, tissue, u.data(), du.data());
}

}  // namespace thenar
