#include "bench/pad_rivals/tetrahedra.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SparseCholesky>

#include "base/error.h"

namespace thenar::bench {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double>;
using Slopes = Eigen::Matrix<double, 3, 4>;

constexpr double kForceTolerance = 1e-9;  // of residuals, over the force [1]
constexpr double kGapTolerance = 1e-9;    // [m]
constexpr int kMaxIterations = 60;
constexpr int kMaxHalvings = 12;

struct Tetrahedron {
  std::array<int, 4> unknown{};  // the first of each node; -1: fixed
  Slopes slope;                  // dN/dX [1/m]
  double volume = 0;             // [m^3]
  double pressure = 0;           // of the tangent [Pa]
  std::array<int, 144> entry{};  // of the matrix's values; -1: none
};

/// Six tetrahedra of a cell: from its first node to the triangles of the faces that do not have it.
/// Each face is cut from its own first node, so neighbours agree.
std::vector<std::array<int, 4>> cut(const HexCell& cell) {
  const int apex = *std::min_element(cell.corners.begin(), cell.corners.end());
  std::vector<std::array<int, 4>> out;
  for (const std::array<int, 4>& face : hex_faces()) {
    // Around the face, its first node in front.
    std::array<int, 4> ring{};
    for (std::size_t i = 0; i < 4; ++i)
      ring[i] = cell.corners[static_cast<std::size_t>(face[i < 2 ? i : 5 - i])];
    if (std::find(ring.begin(), ring.end(), apex) != ring.end()) continue;
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
    out.push_back({apex, ring[0], ring[1], ring[2]});
    out.push_back({apex, ring[0], ring[2], ring[3]});
  }
  return out;
}

class TetrahedraPad {
 public:
  TetrahedraPad(const PadShape& shape, const PadCells& cells, const Tissue& tissue)
      : mu_(tissue.shear_modulus), bulk_(bulk_modulus(tissue)) {
    require(tissue.law == TissueLaw::kNeoHookean && tissue.relaxation.empty(),
            "tetrahedra are neo-Hookean and elastic");
    const HexMesh mesh = pad_mesh(shape, cells);
    const std::vector<bool> held = held_by_bone(mesh), skin = skin_nodes(mesh);
    std::vector<int> unknown(held.size(), -1);
    int count = 0;
    for (int node = 0; node < mesh.nodes(); ++node) {
      const auto at = static_cast<std::size_t>(node);
      if (held[at]) continue;
      unknown[at] = count;
      if (skin[at]) skin_.push_back({count + 2, mesh.place(node)[2]});
      count += 3;
    }
    for (const int index : mesh.active())
      for (std::array<int, 4> nodes : cut(mesh.cells()[static_cast<std::size_t>(index)]))
        add(mesh, nodes, unknown);
    x_ = VectorXd::Zero(count);
    touches_.assign(skin_.size(), false);
    build_pattern(count);
  }

  TetrahedraPress press(double from, double to) {
    TetrahedraPress out;
    out.elements = tetrahedra_.size();
    out.unknowns = static_cast<std::size_t>(x_.size());
    out.solved = go(from, to, 0);
    out.force = force_;
    out.factorisations = factorisations_;
    return out;
  }

 private:
  struct SkinNode {
    int unknown;    // of its height
    double height;  // at rest [m]
  };

  void add(const HexMesh& mesh, std::array<int, 4> nodes, const std::vector<int>& unknown) {
    Matrix3d edges;
    const auto set_edges = [&] {
      for (std::size_t i = 0; i < 3; ++i)
        edges.col(static_cast<Eigen::Index>(i)) = mesh.place(nodes[i + 1]) - mesh.place(nodes[0]);
    };
    set_edges();
    if (edges.determinant() < 0) {
      std::swap(nodes[2], nodes[3]);
      set_edges();
    }
    Tetrahedron t;
    t.volume = edges.determinant() / 6;
    require(t.volume > 0, "a tetrahedron is flat");
    const Matrix3d inverse = edges.inverse();
    t.slope.rightCols<3>() = inverse.transpose();
    t.slope.col(0) = -t.slope.rightCols<3>().rowwise().sum();
    for (std::size_t i = 0; i < 4; ++i) t.unknown[i] = unknown[static_cast<std::size_t>(nodes[i])];
    tetrahedra_.push_back(t);
  }

  /// Unknown of row 0..11 of an element; -1: fixed.
  static int row_of(const Tetrahedron& t, std::size_t i) {
    return t.unknown[i / 3] < 0 ? -1 : t.unknown[i / 3] + static_cast<int>(i % 3);
  }

  void build_pattern(int count) {
    std::vector<Eigen::Triplet<double>> all;
    const auto each = [&](auto visit) {
      for (Tetrahedron& t : tetrahedra_)
        for (std::size_t i = 0; i < 12; ++i)
          for (std::size_t j = 0; j < 12; ++j) {
            const int r = row_of(t, i), c = row_of(t, j);
            if (c >= 0 && r >= c) visit(t, 12 * i + j, r, c);
          }
    };
    each([&](Tetrahedron&, std::size_t, int r, int c) { all.emplace_back(r, c, 1.0); });
    matrix_.resize(count, count);
    matrix_.setFromTriplets(all.begin(), all.end());
    for (Tetrahedron& t : tetrahedra_) t.entry.fill(-1);
    each([&](Tetrahedron& t, std::size_t place, int r, int c) {
      const int* begin = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[c];
      const int* end = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[c + 1];
      t.entry[place] = static_cast<int>(std::lower_bound(begin, end, r) - matrix_.innerIndexPtr());
    });
    solver_.analyzePattern(matrix_);
  }

  /// Forces and stiffness of all elements. @return whether none is inverted
  bool assemble() {
    residual_ = VectorXd::Zero(x_.size());
    std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), 0.0);
    for (const Tetrahedron& t : tetrahedra_)
      if (!add_element(t)) return false;
    return true;
  }

  Matrix3d gradient(const Tetrahedron& t, const VectorXd& x) const {
    Matrix3d H = Matrix3d::Zero();
    for (std::size_t a = 0; a < 4; ++a)
      if (t.unknown[a] >= 0)
        H += x.segment<3>(t.unknown[a]) * t.slope.col(static_cast<Eigen::Index>(a)).transpose();
    return H;
  }

  bool add_element(const Tetrahedron& t) {
    const Matrix3d F = Matrix3d::Identity() + gradient(t, x_);
    const double J = F.determinant();
    if (!(J > 0)) return false;
    const VolumetricResponse volumetric = volumetric_response(bulk_, J);
    // Kirchhoff stress: mu dev(bbar), and J times the pressure.
    const Matrix3d b = std::pow(J, -2.0 / 3) * F * F.transpose();
    const double trace = b.trace();
    const Matrix3d iso = mu_ * (b - trace / 3 * Matrix3d::Identity());
    const Slopes g = F.transpose().inverse() * t.slope;
    const Slopes forces = t.volume * (iso + J * volumetric.pressure * Matrix3d::Identity()) * g;
    // c = 2/3 mu tr (II - I x I / 3) - 2/3 (iso x I + I x iso) + (J p + J^2 U'') I x I - 2 J p II.
    const double Jp = J * t.pressure;
    const double minor = t.volume * (2.0 / 3 * mu_ * trace - 2 * Jp);
    const double major = t.volume * (Jp + J * J * volumetric.stiffness - 2.0 / 9 * mu_ * trace);
    const Slopes s = t.volume * iso * g;
    const Slopes geometric = s + t.volume * Jp * g;
    for (Eigen::Index a = 0; a < 4; ++a) {
      if (const int row = t.unknown[static_cast<std::size_t>(a)]; row >= 0)
        residual_.segment<3>(row) += forces.col(a);
      for (Eigen::Index c = 0; c < 4; ++c) {
        Matrix3d block = (major * g.col(a) - 2.0 / 3 * s.col(a)) * g.col(c).transpose() -
                         2.0 / 3 * g.col(a) * s.col(c).transpose() +
                         0.5 * minor * g.col(c) * g.col(a).transpose();
        block.diagonal().array() +=
            0.5 * minor * g.col(a).dot(g.col(c)) + g.col(a).dot(geometric.col(c));
        for (Eigen::Index i = 0; i < 3; ++i)
          for (Eigen::Index j = 0; j < 3; ++j) {
            const int at = t.entry[static_cast<std::size_t>(12 * (3 * a + i) + 3 * c + j)];
            if (at >= 0) matrix_.valuePtr()[at] += block(i, j);
          }
      }
    }
    return true;
  }

  /// What a step makes of pressures, linear.
  void predict_pressure(const VectorXd& dx) {
    for (Tetrahedron& t : tetrahedra_) {
      const Matrix3d F = Matrix3d::Identity() + gradient(t, x_);
      const double J = F.determinant();
      const VolumetricResponse at = volumetric_response(bulk_, J);
      t.pressure = at.pressure + at.stiffness * J * (gradient(t, dx) * F.inverse()).trace();
    }
  }

  /// Newton's method with the plane at a height. @return whether it converged
  bool solve(double plane) {
    bool changed = false;
    for (std::size_t k = 0; k < skin_.size(); ++k)
      touches_[k] = touches_[k] || skin_[k].height + x_[skin_[k].unknown] > plane;
    for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
      if (!assemble()) return false;
      // Converged: all free forces in balance, nothing inside, nothing pulls.
      VectorXd balance = residual_;
      force_ = 0;
      double gap = 0;
      for (std::size_t k = 0; k < skin_.size(); ++k)
        if (touches_[k]) {
          force_ -= residual_[skin_[k].unknown];
          balance[skin_[k].unknown] = 0;
          gap = std::max(gap, std::abs(plane - skin_[k].height - x_[skin_[k].unknown]));
        }
      if (!changed && gap <= kGapTolerance &&
          balance.lpNorm<Eigen::Infinity>() <= kForceTolerance * force_)
        return true;
      if (!step(plane, changed)) return false;
    }
    return false;
  }

  bool step(double plane, bool& changed) {
    // Heights that are set: known steps on the right, ones on the diagonal.
    std::vector<bool> set(static_cast<std::size_t>(x_.size()), false);
    VectorXd known = VectorXd::Zero(x_.size());
    for (std::size_t k = 0; k < skin_.size(); ++k)
      if (touches_[k]) {
        const int at = skin_[k].unknown;
        set[static_cast<std::size_t>(at)] = true;
        known[at] = plane - skin_[k].height - x_[at];
      }
    VectorXd right = -residual_ - matrix_.selfadjointView<Eigen::Lower>() * known;
    SparseMatrix reduced = matrix_;
    for (int c = 0; c < reduced.outerSize(); ++c)
      for (SparseMatrix::InnerIterator it(reduced, c); it; ++it)
        if (set[static_cast<std::size_t>(it.row())] || set[static_cast<std::size_t>(c)])
          it.valueRef() = it.row() == c ? 1 : 0;
    for (Eigen::Index i = 0; i < right.size(); ++i)
      if (set[static_cast<std::size_t>(i)]) right[i] = known[i];
    solver_.factorize(reduced);
    ++factorisations_;
    if (solver_.info() != Eigen::Success) return false;
    const VectorXd dx = solver_.solve(right);
    if (!dx.allFinite()) return false;
    // Those that would pull are let go; those that would be inside touch.
    const VectorXd after = residual_ + matrix_.selfadjointView<Eigen::Lower>() * dx;
    predict_pressure(dx);
    x_ += dx;
    changed = false;
    for (std::size_t k = 0; k < skin_.size(); ++k) {
      const int at = skin_[k].unknown;
      const bool touches = touches_[k] ? after[at] < 0 : skin_[k].height + x_[at] > plane;
      changed = changed || touches != touches_[k];
      touches_[k] = touches;
    }
    return true;
  }

  /// To a height, in halves where it fails.
  bool go(double from, double to, int halvings) {
    const VectorXd x = x_;
    const std::vector<bool> touches = touches_;
    const std::vector<Tetrahedron> tetrahedra = tetrahedra_;
    if (solve(to)) return true;
    if (halvings == kMaxHalvings) return false;
    x_ = x;
    touches_ = touches;
    tetrahedra_ = tetrahedra;
    const double middle = (from + to) / 2;
    return go(from, middle, halvings + 1) && go(middle, to, halvings + 1);
  }

  double mu_, bulk_;
  std::vector<Tetrahedron> tetrahedra_;
  std::vector<SkinNode> skin_;
  std::vector<bool> touches_;  // (skin nodes)
  VectorXd x_, residual_;
  SparseMatrix matrix_;  // lower triangle
  Eigen::SimplicialLDLT<SparseMatrix> solver_;
  double force_ = 0;
  int factorisations_ = 0;
};

}  // namespace

TetrahedraPress press_tetrahedra(const PadShape& shape, const PadCells& cells, const Tissue& tissue,
                                 double plane) {
  return TetrahedraPad(shape, cells, tissue).press(shape.height, plane);
}

}  // namespace thenar::bench
