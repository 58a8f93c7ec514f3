#include "pads/tissue_element.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "base/error.h"
#include "pads/element_sums.h"

namespace thenar {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Shape functions, weights and coordinates at Gauss points.
struct ElementTable {
  int nodes = 8, points = 8;
  std::vector<double> slope;   // dN/dxi (points, nodes, 3)
  std::vector<double> weight;  // (points)
  std::vector<double> value;   // N (points, nodes)
  std::vector<Vector3d> xi;    // (points)
};

namespace {

/// Lagrange functions of one axis, of degree 1 or 2, and their derivatives at x in -1..1.
struct Axis {
  std::array<double, 3> value{}, slope{};
};
Axis axis_at(int degree, double x) {
  if (degree == 1) return {{(1 - x) / 2, (1 + x) / 2, 0}, {-0.5, 0.5, 0}};
  return {{x * (x - 1) / 2, 1 - x * x, x * (x + 1) / 2}, {x - 0.5, -2 * x, x + 0.5}};
}

/// Appends the values and derivatives of all nodes' shape functions at a point.
void add_shapes(int degree, const Vector3d& xi, std::vector<double>& value,
                std::vector<double>& slope) {
  // Form tensor products of the functions of the axes, first axis fastest.
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
  // Set the two or three Gauss points and weights of one axis.
  const double at = degree == 1 ? 1 / std::sqrt(3.0) : std::sqrt(0.6);
  const std::array<double, 3> x = degree == 1 ? std::array{-at, at, 0.0} : std::array{-at, 0.0, at};
  const std::array<double, 3> w =
      degree == 1 ? std::array{1.0, 1.0, 0.0} : std::array{5.0 / 9, 8.0 / 9, 5.0 / 9};
  // Form tensor products, first axis fastest.
  for (std::size_t k = 0; k < static_cast<std::size_t>(n); ++k)
    for (std::size_t j = 0; j < static_cast<std::size_t>(n); ++j)
      for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
        table.xi.emplace_back(x[i], x[j], x[k]);
        table.weight.push_back(w[i] * w[j] * w[k]);
        add_shapes(degree, table.xi.back(), table.value, table.slope);
      }
  return table;
}

/// Returns dX/dxi at a point from the derivatives of the shape functions there.
Matrix3d jacobian_of(const double* slope, const Eigen::Matrix3Xd& X) {
  Matrix3d out = Matrix3d::Zero();
  for (Eigen::Index a = 0; a < X.cols(); ++a)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) out(i, j) += X(i, a) * slope[3 * a + j];
  return out;
}

/// Appends dN/dX = (dX/dxi)^-T dN/dxi of all nodes. @return det dX/dxi
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

/// Returns gradients in the layout of PointKinematics, with padding points.
/// @param list  (points, nodes, 3)
std::vector<double> side_by_side(const std::vector<double>& list, int points, int nodes) {
  const int padded = padded_points(points);
  std::vector<double> out;
  for (int k = 0; k < 3 * nodes; ++k)
    for (int q = 0; q < padded; ++q) out.push_back(list[std::min(q, points - 1) * 3 * nodes + k]);
  return out;
}

/// Returns the volume mean of the gradients over an element (nodes, 3).
std::vector<double> mean_gradient(const ElementShape& shape, int padded) {
  double volume = 0;
  for (const double w : shape.volume) volume += w;
  std::vector<double> out(shape.gradient.size() / static_cast<std::size_t>(padded), 0);
  for (std::size_t k = 0; k < out.size(); ++k)
    for (std::size_t q = 0; q < shape.volume.size(); ++q)
      out[k] += shape.volume[q] / volume * shape.gradient[k * static_cast<std::size_t>(padded) + q];
  return out;
}

/// Returns F at a point.
Matrix3d deformation_at(const PointKinematics& at, int points, int q) {
  Matrix3d F;
  for (int k = 0; k < 9; ++k) F.data()[k] = at.F[k * points + q];
  return F;
}

/// Stores the weighted stress and tangent of a point.
void set_point(int points, int q, double w, const Voigt& tau, const VoigtTangent* c,
               PointStresses& out) {
  for (int p = 0; p < 6; ++p) {
    out.tau[p * points + q] = w * tau[p];
    if (c == nullptr) continue;
    for (int r = p; r < 6; ++r) out.c[tangent_entry(p, r) * points + q] = w * (*c)(p, r);
  }
}

/// Adds a pressure to a tangent:  c += s 1 x 1 - r 2 I.
void add_pressure_tangent(double s, double r, VoigtTangent& c) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) c(i, j) += s;
    c(i, i) -= 2 * r;
    c(i + 3, i + 3) -= r;
  }
}

/// Dilatation that replaces J in the volumetric energy, by kind of element.
template <int N>
class Dilatation {
 public:
  Dilatation(const DeformedElement& at, const PointKinematics& points)
      : kind_(at.kind), shape_(at.shape), tangent_(at.tangent_pressure) {
    const double K = bulk_modulus(at.tissue);
    if (kind_ == HexElement::kDisplacement) {
      // Q1: take J of each point.
      for (std::size_t q = 0; q < N; ++q) at_[q] = volumetric_response(K, points.J[q]);
    } else if (kind_ == HexElement::kMeanDilatation) {
      // Q1P0: average J over the element's volume.
      double sum = 0;
      for (std::size_t q = 0; q < N; ++q) {
        volume_ += shape_.volume[q];
        sum += shape_.volume[q] * points.J[q];
      }
      at_.fill(volumetric_response(K, sum / volume_));
    } else if (kind_ == HexElement::kCentroidDilatation) {
      // F-bar: take J of the mean of F, which must be positive, too.
      point_kinematics(N, kCentre, shape_.mean_gradient.data(), at.u.data(), centre_);
      for (const double w : shape_.volume) volume_ += w;
      fits_ = centre_.J[0] > 0;
      if (fits_) at_.fill(volumetric_response(K, centre_.J[0]));
    } else {
      project(K, points);
    }
  }

  /// Returns whether the dilatation is above 0 everywhere.
  [[nodiscard]] bool fits() const { return fits_; }
  [[nodiscard]] double energy() const {
    double sum = 0;
    for (std::size_t q = 0; q < N; ++q) sum += shape_.volume[q] * at_[q].energy;
    return sum;
  }
  /// Returns the pressure that acts with J at a Gauss point [Pa].
  [[nodiscard]] double pressure(std::size_t q) const {
    if (kind_ == HexElement::kCentroidDilatation) return 0;
    return kind_ == HexElement::kQuadratic ? shape_.modes.row(q).dot(pressure_) : at_[q].pressure;
  }
  /// Returns the pressure in the stiffness at a Gauss point [Pa].
  [[nodiscard]] double tangent_pressure(std::size_t q) const {
    if (tangent_ == nullptr || kind_ == HexElement::kDisplacement ||
        kind_ == HexElement::kCentroidDilatation)
      return pressure(q);
    return kind_ == HexElement::kQuadratic ? shape_.modes.row(q).dot(*tangent_) : (*tangent_)[0];
  }
  /// Returns the pressure after a displacement increment du, linearized [Pa] (4).
  [[nodiscard]] Eigen::Vector4d linear_pressure(const PointKinematics& points,
                                                const double* du) const {
    Eigen::Vector4d out(0, 0, 0, 0);
    // Compute the divergence of du at the points; dJ = J times the divergence.
    std::array<double, kMaxPoints> divergence{};
    const bool centre = kind_ == HexElement::kCentroidDilatation;
    const int count = centre ? kCentre : kPoints;
    const double* g = centre ? centre_.g : points.g;
    for (int i = 0; i < 3 * N; ++i)
      for (int q = 0; q < count; ++q) divergence[q] += g[i * count + q] * du[i];
    if (kind_ == HexElement::kCentroidDilatation) {
      // F-bar: linearize the pressure at the centre.
      out[0] = at_[0].pressure + at_[0].stiffness * centre_.J[0] * divergence[0];
    } else if (kind_ == HexElement::kMeanDilatation) {
      // Q1P0: linearize the pressure with the volume mean of dJ.
      double sum = 0;
      for (std::size_t q = 0; q < N; ++q) sum += shape_.volume[q] * points.J[q] * divergence[q];
      out[0] = at_[0].pressure + at_[0].stiffness * sum / volume_;
    } else if (kind_ == HexElement::kQuadratic) {
      // Q2P1: project dJ on the modes, then the pressure.
      Eigen::Vector4d mean(0, 0, 0, 0), p(0, 0, 0, 0);
      for (std::size_t q = 0; q < N; ++q)
        mean += shape_.volume[q] * points.J[q] * divergence[q] * shape_.modes.row(q).transpose();
      const Eigen::Vector4d theta = shape_.modes_inverse * mean;
      for (std::size_t q = 0; q < N; ++q) {
        const Eigen::Vector4d mode = shape_.modes.row(q);
        p += shape_.volume[q] * (at_[q].pressure + at_[q].stiffness * mode.dot(theta)) * mode;
      }
      out = shape_.modes_inverse * p;
    }
    return out;
  }
  /// Returns U'' J^2 at a point if the element uses the point's own J, otherwise 0.
  [[nodiscard]] double own_stiffness(std::size_t q, double J) const {
    return kind_ == HexElement::kDisplacement ? at_[q].stiffness * J * J : 0;
  }

  /// Adds the forces and stiffness that do not derive from a stress at a Gauss point.
  void add(const PointKinematics& points, bool with_stiffness, double* force, double* K) const {
    if (kind_ == HexElement::kCentroidDilatation) {
      add_centre(with_stiffness, force, K);
    } else if (kind_ == HexElement::kMeanDilatation && with_stiffness) {
      // Add the stiffness of V U(mean J) that couples points:  U'' / V b b',  b = d(V mean J) / du.
      std::array<double, 3 * N> b{};
      for (std::size_t q = 0; q < N; ++q) {
        const double w = shape_.volume[q] * points.J[q];
        for (std::size_t i = 0; i < 3 * N; ++i) b[i] += w * points.g[i * kPoints + q];
      }
      add_square(at_[0].stiffness / volume_, b.data(), b.data(), K);
    } else if (kind_ == HexElement::kQuadratic && with_stiffness) {
      add_modes(points, K);
    }
  }

 private:
  static constexpr int kPoints = padded_points(N), kCentre = padded_points(1);

  /// Adds the pressure of the centre, which acts there with the whole volume.
  void add_centre(bool with_stiffness, double* force, double* K) const {
    // Add the force of the pressure as a stress at the centre.
    PointStresses at{};
    const double J = centre_.J[0], own = at_[0].pressure * J;
    Voigt tau = Voigt::Zero();
    tau.head<3>().setConstant(own);
    set_point(kCentre, 0, volume_, tau, nullptr, at);
    add_forces(N, kCentre, centre_.g, at, force);
    if (!with_stiffness) return;
    // Add the stiffness there, with the pressure of the tangent.
    VoigtTangent c = VoigtTangent::Zero();
    const double pJ = tangent_ != nullptr ? (*tangent_)[0] * J : own;
    tau.head<3>().setConstant(pJ);
    add_pressure_tangent(at_[0].stiffness * J * J + pJ, pJ, c);
    set_point(kCentre, 0, volume_, tau, &c, at);
    add_stiffness(N, kCentre, centre_.g, at, K);
  }

  /// Adds to the upper triangle of the stiffness:  K += s b c'.
  static void add_square(double s, const double* b, const double* c, double* K) {
    for (int j = 0; j < 3 * N; ++j)
      for (int i = 0; i <= j; ++i) K[j * 3 * N + i] += s * b[i] * c[j];
  }

  /// Computes theta, the projection of J on the modes, and p, the projection of U'(theta).
  void project(double bulk, const PointKinematics& points) {
    // Project the dilatation.
    Eigen::Vector4d mean(0, 0, 0, 0);
    for (std::size_t q = 0; q < N; ++q)
      mean += shape_.volume[q] * points.J[q] * shape_.modes.row(q).transpose();
    const Eigen::Vector4d theta = shape_.modes_inverse * mean;
    // Project the pressure U'(J); J must be positive at all points.
    Eigen::Vector4d p(0, 0, 0, 0);
    for (std::size_t q = 0; q < N; ++q) {
      const double J = shape_.modes.row(q).dot(theta);
      if (!(J > 0)) {
        fits_ = false;
        return;
      }
      at_[q] = volumetric_response(bulk, J);
      p += shape_.volume[q] * at_[q].pressure * shape_.modes.row(q).transpose();
    }
    pressure_ = shape_.modes_inverse * p;
  }

  /// Adds the stiffness of the dilatation modes.
  void add_modes(const PointKinematics& points, double* K) const {
    // Sum the matrices  H = sum of w U'' mode mode',  B = d (M theta) / d u.
    Eigen::Matrix4d H = Eigen::Matrix4d::Zero();
    Eigen::Matrix<double, 3 * N, 4> B = Eigen::Matrix<double, 3 * N, 4>::Zero();
    for (std::size_t q = 0; q < N; ++q) {
      const Eigen::Vector4d mode = shape_.modes.row(q);
      H += shape_.volume[q] * at_[q].stiffness * mode * mode.transpose();
      const Eigen::Vector4d weighted = shape_.volume[q] * points.J[q] * mode;
      for (int i = 0; i < 3 * N; ++i)
        B.row(i) += points.g[static_cast<std::size_t>(i * kPoints) + q] * weighted.transpose();
    }
    // Add the stiffness  B M^-1 H M^-1 B',  of rank four.
    const Eigen::Matrix4d middle = shape_.modes_inverse * H * shape_.modes_inverse;
    const Eigen::Matrix<double, 3 * N, 4> left = B * middle;
    for (int m = 0; m < 4; ++m) add_square(1, left.col(m).data(), B.col(m).data(), K);
  }

  HexElement kind_;
  const ElementShape& shape_;
  const Eigen::Vector4d* tangent_;  // null: the pressure itself
  std::array<VolumetricResponse, N> at_;
  PointKinematics centre_;
  Eigen::Vector4d pressure_ = Eigen::Vector4d::Zero();
  double volume_ = 0;
  bool fits_ = true;
};

/// Energy, forces and stiffness of an element of N points, summed over its Gauss points.
template <int N>
class PointSums {
 public:
  /// @param points, dilatation  of the same element; must outlive the object
  PointSums(const DeformedElement& at, const PointKinematics& points,
            const Dilatation<N>& dilatation, ElementRequest request, ElementResponse& out)
      : at_(at),
        points_(points),
        dilatation_(dilatation),
        with_force_(request != ElementRequest::kEnergy),
        with_stiffness_(request == ElementRequest::kStiffness),
        relaxes_(!at.step->decay.empty()),
        out_(out) {
    // Reset the requested results; give the padding points zero weight.
    out.energy = dilatation.energy();
    if (with_force_) out.force.setZero(3 * N);
    if (with_stiffness_) out.stiffness.setZero(3 * N, 3 * N);
    if (with_force_) out.elastic.resize(N);
    for (int q = N; q < kPoints; ++q)
      set_point(kPoints, q, 0, Voigt::Zero(), &iso_.tangent, stresses_);
  }

  /// Adds the energy of a point, and stores its stress and tangent if requested.
  void add_point(std::size_t q) {
    // Compute the isochoric response of the point, as if nothing relaxed.
    const Matrix3d F = deformation_at(points_, kPoints, static_cast<int>(q));
    const double w = at_.shape.volume[q];
    isochoric_response(at_.tissue, F, with_stiffness_, iso_);
    out_.energy += w * at_.step->now * iso_.energy;
    // Add the energy of the history, which is linear in C.
    Voigt past = Voigt::Zero();
    if (relaxes_) {
      past = remaining_stress(q);
      const Matrix3d C = F.transpose() * F;
      out_.energy += 0.5 * w * tensor_of(past).cwiseProduct(C - Matrix3d::Identity()).sum();
    }
    if (with_force_) store_stress(q, F, past);
  }

  /// Computes force and stiffness from all points, if requested.
  void integrate() {
    if (!with_force_) return;
    add_forces(N, kPoints, points_.g, stresses_, out_.force.data());
    if (with_stiffness_) {
      // The geometric stiffness uses the pressure of the tangent.
      for (int p = 0; p < 3; ++p)
        for (std::size_t q = 0; q < N; ++q)
          stresses_.tau[static_cast<std::size_t>(p * kPoints) + q] += more_[q];
      add_stiffness(N, kPoints, points_.g, stresses_, out_.stiffness.data());
    }
    // Add the contributions of the dilatation that couple points.
    dilatation_.add(points_, with_stiffness_, out_.force.data(), out_.stiffness.data());
  }

 private:
  static constexpr int kPoints = padded_points(N);

  /// Computes the second Piola-Kirchhoff stress of the history at a point [Pa].
  [[nodiscard]] Voigt remaining_stress(std::size_t q) const {
    const MemoryStep& step = *at_.step;
    Voigt past = Voigt::Zero();
    for (std::size_t i = 0; i < step.decay.size(); ++i)
      past +=
          step.decay[i] * at_.history->terms[i * N + q] - step.change[i] * at_.history->elastic[q];
    return past;
  }

  /// Stores the Kirchhoff stress of a point, and its tangent if requested.
  void store_stress(std::size_t q, const Matrix3d& F, const Voigt& past) {
    const double w = at_.shape.volume[q], J = points_.J[q];
    // Pull the elastic stress back to the reference for the history.
    if (relaxes_) {
      const Matrix3d inverse = F.inverse();
      out_.elastic[q] = voigt_of(inverse * tensor_of(iso_.stress) * inverse.transpose());
    }
    // Sum the isochoric part, the history pushed forward, and the pressure.
    Voigt tau = at_.step->now * iso_.stress;
    if (relaxes_) tau += voigt_of(F * tensor_of(past) * F.transpose());
    tau.head<3>().array() += dilatation_.pressure(q) * J;
    // Use the tangent's pressure in the stiffness, which may differ from that in the forces.
    if (with_stiffness_) {
      iso_.tangent *= at_.step->now;
      const double tangent_pJ = dilatation_.tangent_pressure(q) * J;
      add_pressure_tangent(tangent_pJ + dilatation_.own_stiffness(q, J), tangent_pJ, iso_.tangent);
      more_[q] = w * (tangent_pJ - dilatation_.pressure(q) * J);
    }
    set_point(kPoints, static_cast<int>(q), w, tau, with_stiffness_ ? &iso_.tangent : nullptr,
              stresses_);
  }

  const DeformedElement& at_;
  const PointKinematics& points_;
  const Dilatation<N>& dilatation_;
  bool with_force_, with_stiffness_;
  bool relaxes_;  // the tissue has a history
  ElementResponse& out_;
  IsochoricResponse iso_;  // response of the present point
  PointStresses stresses_;
  std::array<double, N> more_{};  // pressure of the stiffness over that of forces, times J w [J]
};

template <int N>
void compute_response(const DeformedElement& at, ElementRequest request, ElementResponse& out) {
  // Compute the deformation at all points, and the dilatation of this kind of element; both count
  // as inverted unless they are positive.
  PointKinematics points;
  point_kinematics(N, padded_points(N), at.shape.gradient.data(), at.u.data(), points);
  out.inverted = !std::all_of(points.J, points.J + N, [](double J) { return J > 0; });
  if (out.inverted) return;
  const Dilatation<N> dilatation(at, points);
  out.inverted = !dilatation.fits();
  if (out.inverted) return;
  PointSums<N> sums(at, points, dilatation, request, out);
  for (std::size_t q = 0; q < N; ++q) sums.add_point(q);
  sums.integrate();
}

template <int N>
Eigen::Vector4d linear_pressure_of(const DeformedElement& at, const double* du) {
  PointKinematics points;
  point_kinematics(N, padded_points(N), at.shape.gradient.data(), at.u.data(), points);
  return Dilatation<N>(at, points).linear_pressure(points, du);
}

}  // namespace

int node_count(HexElement kind) { return kind == HexElement::kQuadratic ? 27 : 8; }
int gauss_point_count(HexElement kind) { return node_count(kind); }

const ElementTable& element_table(HexElement kind) {
  static const ElementTable linear = build_table(1), quadratic = build_table(2);
  return kind == HexElement::kQuadratic ? quadratic : linear;
}

ElementShape element_shape(HexElement kind, const Eigen::Matrix3Xd& X) {
  const ElementTable& table = element_table(kind);
  ElementShape shape;
  // Compute gradients and volumes of the Gauss points.
  for (int q = 0; q < table.points; ++q) {
    const double det = map_slopes(table.slope.data() + q * 3 * table.nodes, X, shape.gradient);
    require(det > 0, "an element folds onto itself at Gauss point {}: {:g} m^3", q, det);
    shape.volume.push_back(table.weight[q] * det);
  }
  // Convert to the layout for sums over four points at a time.
  shape.gradient = side_by_side(shape.gradient, table.points, table.nodes);
  if (kind == HexElement::kCentroidDilatation) {
    // F-bar: compute the gradients of the mean of F.
    const std::vector<double> mean = mean_gradient(shape, padded_points(table.points));
    shape.mean_gradient = side_by_side(mean, 1, table.nodes);
  }
  if (kind == HexElement::kQuadratic) {
    // Q2P1: compute the modes 1, xi, eta, zeta, and the inverse of their Gram matrix.
    shape.modes.resize(table.points, 4);
    for (int q = 0; q < table.points; ++q) shape.modes.row(q) << 1, table.xi[q].transpose();
    const Eigen::Map<const Eigen::VectorXd> w(shape.volume.data(), table.points);
    shape.modes_inverse = (shape.modes.transpose() * w.asDiagonal() * shape.modes).inverse();
  }
  return shape;
}

Matrix3d element_deformation(const ElementShape& shape, const Eigen::Matrix3Xd& u,
                             std::size_t point) {
  const std::size_t points = shape.gradient.size() / static_cast<std::size_t>(3 * u.cols());
  Matrix3d F = Matrix3d::Identity();
  for (Eigen::Index a = 0; a < u.cols(); ++a)
    for (Eigen::Index j = 0; j < 3; ++j)
      F.col(j) += u.col(a) * shape.gradient[static_cast<std::size_t>(3 * a + j) * points + point];
  return F;
}

double shape_value(HexElement kind, std::size_t point, std::size_t node) {
  const ElementTable& table = element_table(kind);
  return table.value[point * static_cast<std::size_t>(table.nodes) + node];
}

void element_response(const DeformedElement& at, ElementRequest request, ElementResponse& out) {
  if (node_count(at.kind) == 27)
    compute_response<27>(at, request, out);
  else
    compute_response<8>(at, request, out);
}

Eigen::Vector4d linear_pressure(const DeformedElement& at, const Eigen::Matrix3Xd& du) {
  return node_count(at.kind) == 27 ? linear_pressure_of<27>(at, du.data())
                                   : linear_pressure_of<8>(at, du.data());
}

}  // namespace thenar
