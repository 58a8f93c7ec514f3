// pad_dealii PAD CYCLES [CELLS PENALTY]
//
// A finger pad pressed by a plane without friction, by deal.II: quadratic hexahedra whose
// dilatation and pressure are linear within (u, p, J, condensed), refined by Kelly's estimator,
// contact by a penalty at quadrature points. Prints a line for each mesh: cells, unknowns, force
// [N], depth in the penalty [m], processor time of the whole process until then [s],
// factorisations. PAD is what pad_chart writes of a pad.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <stdexcept>
#include <vector>

#include <deal.II/base/multithread_info.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_dgp.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/fe/mapping_q_cache.h>
#include <deal.II/grid/grid_refinement.h>
#include <deal.II/grid/manifold_lib.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>
#include <deal.II/numerics/error_estimator.h>
#include <deal.II/numerics/solution_transfer.h>
#include <deal.II/numerics/vector_tools.h>

#include <Eigen/Dense>

namespace {

using namespace dealii;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kNodes = 27, kRows = 81, kModes = 4;
constexpr double kTolerance = 1e-8;  // of residuals, over the force [1]
constexpr int kMaxIterations = 40, kMaxHalvings = 8;
constexpr types::boundary_id kBone = 1, kSkin = 2, kRim = 3;

double process_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// A pad as it is read.
struct Pad {
  double half[3], bone_half[3];  // semi-axes of the skin and of the bone [m]
  double mu, bulk, depth;        // [Pa], [Pa], [m]
  std::vector<Point<3>> points;  // in the chart (a, b, w)
  std::vector<CellData<3>> cells;

  /// Place of a point of the chart: the polar angle grows straight with the radius [m].
  Point<3> place(const Point<3>& c) const {
    const double r = std::hypot(c[0], c[1]), polar = M_PI_2 * r;
    const double side = r > 1e-12 ? std::sin(polar) / r : M_PI_2, up = std::cos(polar);
    const auto between = [&](int i) { return (1 - c[2]) * bone_half[i] + c[2] * half[i]; };
    return {between(0) * side * c[0], between(1) * side * c[1], between(2) * up};
  }
};

Pad read_pad(const char* file) {
  std::ifstream in(file);
  Pad pad;
  std::size_t points = 0, cells = 0;
  for (double& x : pad.half) in >> x;
  for (double& x : pad.bone_half) in >> x;
  in >> pad.mu >> pad.bulk >> pad.depth >> points >> cells;
  for (std::size_t i = 0; i < points && in; ++i) {
    Point<3> p;
    in >> p[0] >> p[1] >> p[2];
    pad.points.push_back(p);
  }
  for (std::size_t i = 0; i < cells && in; ++i) {
    CellData<3> cell;
    for (unsigned& vertex : cell.vertices) in >> vertex;
    pad.cells.push_back(cell);
  }
  if (!in) throw std::runtime_error(std::string(file) + ": no pad");
  return pad;
}

class PadPress {
 public:
  PadPress(const Pad& pad, double penalty)
      : pad_(pad),
        penalty_(penalty),
        displacement_(FE_Q<3>(2), 3),
        scalar_(2),
        pressure_(1),
        mapping_(4),
        dofs_(triangulation_),
        pressure_dofs_(triangulation_) {
    triangulation_.create_triangulation(pad.points, pad.cells, SubCellData());
    // What lies on the bone, the skin and the rim.
    for (const auto& cell : triangulation_.active_cell_iterators())
      for (const auto& face : cell->face_iterators()) {
        if (!face->at_boundary()) continue;
        const double w = face->center()[2];
        const bool flat =
            face->vertex(0)[2] == face->vertex(3)[2] && face->vertex(1)[2] == face->vertex(2)[2];
        face->set_boundary_id(flat && w < 1e-9 ? kBone : flat && w > 1 - 1e-9 ? kSkin : kRim);
        if (face->boundary_id() == kRim) face->set_all_manifold_ids(kRim);
      }
    triangulation_.set_manifold(kRim, CylindricalManifold<3>(2));
    for (unsigned node = 0; node < kNodes; ++node)
      for (unsigned c = 0; c < 3; ++c)
        row_.push_back(displacement_.component_to_system_index(c, node));
    set_up();
    solution_.reinit(dofs_.n_dofs());
    p_.reinit(pressure_dofs_.n_dofs());
  }

  /// On all meshes. @param most  cells beyond which none is refined
  void run(int cycles, unsigned most) {
    for (int cycle = 0; cycle < cycles; ++cycle) {
      if (cycle > 0) refine();
      const double top = pad_.half[2], to = top - pad_.depth;
      if (!(cycle > 0 && solve(to)) && !go(top, to, 0))
        throw std::runtime_error("Newton's method does not converge");
      std::printf("%u %u %.6f %.2e %.3f %d\n", triangulation_.n_active_cells(),
                  dofs_.n_dofs() - constraints_.n_constraints(), force_, deepest_,
                  process_seconds(), factorisations_);
      std::fflush(stdout);
      if (triangulation_.n_active_cells() > most) break;
    }
  }

 private:
  /// Room for one cell.
  struct Cell {
    MatrixXd stiffness = MatrixXd::Zero(kRows, kRows);
    VectorXd force = VectorXd::Zero(kRows);
    MatrixXd divergence = MatrixXd::Zero(kModes, kRows);  // of modes: integral of psi J div
    Eigen::Matrix4d gram, bulk;                           // of modes; with U''
    Eigen::Vector4d pressure;                             // U' projected on modes
    std::vector<types::global_dof_index> rows = std::vector<types::global_dof_index>(kRows);
    std::vector<types::global_dof_index> modes = std::vector<types::global_dof_index>(kModes);
  };

  /// A quadrature point of the skin.
  struct SkinPoint {
    double gap, stiffness;                                          // [m], [N/m]
    std::vector<std::pair<types::global_dof_index, double>> nodes;  // unknowns of its height
  };

  void set_up() {
    mapping_.initialize(
        MappingQ<3>(4), triangulation_,
        [this](const Triangulation<3>::cell_iterator&, const Point<3>& c) { return pad_.place(c); },
        false);
    dofs_.distribute_dofs(displacement_);
    pressure_dofs_.distribute_dofs(pressure_);
    constraints_.clear();
    DoFTools::make_hanging_node_constraints(dofs_, constraints_);
    for (const auto id : {kBone, kRim})
      VectorTools::interpolate_boundary_values(mapping_, dofs_, id, Functions::ZeroFunction<3>(3),
                                               constraints_);
    constraints_.close();
    DynamicSparsityPattern sparsity(dofs_.n_dofs());
    DoFTools::make_sparsity_pattern(dofs_, sparsity, constraints_, false);
    matrix_.clear();
    pattern_.copy_from(sparsity);
    matrix_.reinit(pattern_);
    residual_.reinit(dofs_.n_dofs());
  }

  /// Kinematics of a cell's node values: u of node a at column a.
  Eigen::Matrix<double, 3, kNodes> values_of(const Cell& cell, const Vector<double>& x) const {
    Eigen::Matrix<double, 3, kNodes> out;
    for (int a = 0; a < kNodes; ++a)
      for (int c = 0; c < 3; ++c) out(c, a) = x[cell.rows[row(a, c)]];
    return out;
  }
  /// Row of a component of a node among those of its cell.
  unsigned row(int node, int component) const {
    return row_[static_cast<std::size_t>(3 * node + component)];
  }

  /// Tissue of one cell. @return whether it is not inverted
  bool add_tissue(const FEValues<3>& fe, const FEValues<3>& fe_p, Cell& cell) const {
    const unsigned points = fe.n_quadrature_points;
    const auto u = values_of(cell, solution_);
    // Dilatation: J projected on the modes; the pressure U' of that, projected.
    std::vector<Eigen::Matrix<double, 3, kNodes>> slopes(points);  // dN/dx, deformed
    std::vector<Matrix3d> deformation(points);
    std::vector<double> J(points);
    Eigen::Vector4d theta = Eigen::Vector4d::Zero(), U1 = theta;
    cell.gram.setZero();
    for (unsigned q = 0; q < points; ++q) {
      Eigen::Matrix<double, 3, kNodes> slope;
      for (unsigned a = 0; a < kNodes; ++a)
        for (unsigned c = 0; c < 3; ++c) slope(c, a) = fe.shape_grad(a, q)[c];
      deformation[q] = Matrix3d::Identity() + u * slope.transpose();
      J[q] = deformation[q].determinant();
      if (!(J[q] > 0)) return false;
      slopes[q] = deformation[q].inverse().transpose() * slope;
      theta += fe.JxW(q) * J[q] * modes_at(fe_p, q);
      cell.gram += fe.JxW(q) * modes_at(fe_p, q) * modes_at(fe_p, q).transpose();
    }
    theta = cell.gram.llt().solve(theta);
    cell.bulk.setZero();
    for (unsigned q = 0; q < points; ++q) {
      const Eigen::Vector4d psi = modes_at(fe_p, q);
      const double at = psi.dot(theta);
      if (!(at > 0)) return false;
      U1 += fe.JxW(q) * pad_.bulk / 2 * (at - 1 / at) * psi;
      cell.bulk += fe.JxW(q) * pad_.bulk / 2 * (1 + 1 / (at * at)) * psi * psi.transpose();
    }
    cell.pressure = cell.gram.llt().solve(U1);
    Eigen::Vector4d carried;
    for (int m = 0; m < kModes; ++m) carried[m] = p_[cell.modes[static_cast<std::size_t>(m)]];
    // Forces, and the stiffness with the pressure that is carried.
    for (unsigned q = 0; q < points; ++q) {
      const Eigen::Vector4d psi = modes_at(fe_p, q);
      add_point(fe.JxW(q), deformation[q], J[q], psi.dot(cell.pressure), psi.dot(carried),
                slopes[q], psi, cell);
    }
    const MatrixXd solved = cell.gram.llt().solve(cell.divergence);
    cell.stiffness += solved.transpose() * cell.bulk * solved;
    return true;
  }

  static Eigen::Vector4d modes_at(const FEValues<3>& fe_p, unsigned q) {
    return {fe_p.shape_value(0, q), fe_p.shape_value(1, q), fe_p.shape_value(2, q),
            fe_p.shape_value(3, q)};
  }

  /// Neo-Hookean: tau = mu dev(bbar) + J p I and its Lie derivative, six components.
  void add_point(double w, const Matrix3d& F, double J, double p, double carried,
                 const Eigen::Matrix<double, 3, kNodes>& g, const Eigen::Vector4d& psi,
                 Cell& cell) const {
    using Six = Eigen::Matrix<double, 6, 1>;
    const Matrix3d b = std::pow(J, -2.0 / 3) * F * F.transpose();
    const double trace = b.trace();
    const Matrix3d iso = pad_.mu * (b - trace / 3 * Matrix3d::Identity());
    Six one, s;
    one << 1, 1, 1, 0, 0, 0;
    s << iso(0, 0), iso(1, 1), iso(2, 2), iso(0, 1), iso(1, 2), iso(2, 0);
    Six unit;
    unit << 1, 1, 1, 0.5, 0.5, 0.5;
    Eigen::Matrix<double, 6, 6> D = (2.0 / 3 * pad_.mu * trace - 2 * J * carried) *
                                    Eigen::Matrix<double, 6, 6>(unit.asDiagonal());
    D += (J * carried - 2.0 / 9 * pad_.mu * trace) * one * one.transpose();
    D -= 2.0 / 3 * (s * one.transpose() + one * s.transpose());
    // Strains of all unknowns.
    Eigen::Matrix<double, 6, kRows> B = Eigen::Matrix<double, 6, kRows>::Zero();
    for (int a = 0; a < kNodes; ++a)
      for (int c = 0; c < 3; ++c) {
        const auto at = static_cast<Eigen::Index>(row(a, c));
        B(c, at) = g(c, a);
        B(c == 0 ? 3 : c == 1 ? 4 : 5, at) = g((c + 1) % 3, a);
        B(c == 0 ? 5 : c == 1 ? 3 : 4, at) = g((c + 2) % 3, a);
        for (int m = 0; m < kModes; ++m) cell.divergence(m, at) += w * J * psi[m] * g(c, a);
      }
    cell.force.noalias() += w * B.transpose() * (s + J * p * one);
    cell.stiffness.noalias() += B.transpose() * (w * D * B).eval();
    const MatrixXd geometric = w * g.transpose() * (iso + J * carried * Matrix3d::Identity()) * g;
    for (int a = 0; a < kNodes; ++a)
      for (int c = 0; c < kNodes; ++c)
        for (int i = 0; i < 3; ++i)
          cell.stiffness(static_cast<Eigen::Index>(row(a, i)),
                         static_cast<Eigen::Index>(row(c, i))) += geometric(a, c);
  }

  /// The plane's penalty on one face; pressures per area at rest.
  void add_contact(const FEFaceValues<3>& fe, double plane, Cell& cell) {
    for (unsigned q = 0; q < fe.n_quadrature_points; ++q) {
      SkinPoint point{0, penalty_ * fe.JxW(q), {}};
      point.gap = plane - fe.quadrature_point(q)[2];
      for (int a = 0; a < kNodes; ++a) {
        const double at = fe.shape_value(static_cast<unsigned>(a), q);
        if (std::abs(at) < 1e-12) continue;
        point.nodes.emplace_back(cell.rows[row(a, 2)], at);
        point.gap -= at * solution_[cell.rows[row(a, 2)]];
      }
      if (point.gap < 0) {
        deepest_ = std::max(deepest_, -point.gap);
        force_ -= point.stiffness * point.gap;
        for (int a = 0; a < kNodes; ++a) {
          const double at = fe.shape_value(static_cast<unsigned>(a), q);
          const auto i = static_cast<Eigen::Index>(row(a, 2));
          cell.force[i] -= point.stiffness * point.gap * at;
          for (int c = 0; c < kNodes; ++c)
            cell.stiffness(i, static_cast<Eigen::Index>(row(c, 2))) +=
                point.stiffness * at * fe.shape_value(static_cast<unsigned>(c), q);
        }
      }
      skin_.push_back(std::move(point));
    }
  }

  /// Share of a step at which tissue, linear, and the penalty, as it is, balance along it. (All of
  /// a step makes points at the patch's edge take turns for ever.)
  double share_of(const Vector<double>& step) const {
    std::vector<double> closed;
    double touching = 0;  // of the slope, now
    for (const SkinPoint& point : skin_) {
      double sum = 0;
      for (const auto& [i, at] : point.nodes) sum += at * step[i];
      closed.push_back(sum);
      if (point.gap < 0) touching += point.stiffness * sum * sum;
    }
    const double work = residual_ * step;  // below 0; the slope of the whole is its opposite
    const auto slope = [&](double s) {
      double sum = work + s * (-work - touching);
      for (std::size_t k = 0; k < closed.size(); ++k) {
        const double now = std::min(0.0, skin_[k].gap), then = skin_[k].gap - s * closed[k];
        sum -= skin_[k].stiffness * (std::min(0.0, then) - now) * closed[k];
      }
      return sum;
    };
    if (slope(1) <= 1e-9 * std::abs(work)) return 1;
    double low = 0, high = 1;
    for (int k = 0; k < 50; ++k) (slope((low + high) / 2) < 0 ? low : high) = (low + high) / 2;
    return high;
  }

  /// Visits all cells with their values. @return whether none is inverted
  template <typename Visit>
  bool each_cell(Visit visit) {
    FEValues<3> fe(mapping_, scalar_, QGauss<3>(3), update_gradients | update_JxW_values);
    FEValues<3> fe_p(mapping_, pressure_, QGauss<3>(3), update_values);
    auto p_cell = pressure_dofs_.begin_active();
    for (const auto& cell : dofs_.active_cell_iterators()) {
      const typename Triangulation<3>::cell_iterator plain(cell);
      fe.reinit(plain);
      fe_p.reinit(plain);
      Cell room;
      cell->get_dof_indices(room.rows);
      p_cell->get_dof_indices(room.modes);
      ++p_cell;
      if (!add_tissue(fe, fe_p, room)) return false;
      visit(plain, room);
    }
    return true;
  }

  bool assemble(double plane) {
    FEFaceValues<3> face(mapping_, scalar_, QGauss<2>(4),
                         update_values | update_quadrature_points | update_JxW_values);
    matrix_ = 0;
    residual_ = 0;
    force_ = deepest_ = 0;
    skin_.clear();
    FullMatrix<double> local(kRows, kRows);
    Vector<double> forces(kRows);
    return each_cell([&](const Triangulation<3>::cell_iterator& cell, Cell& room) {
      for (const unsigned f : cell->face_indices())
        if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == kSkin) {
          face.reinit(cell, f);
          add_contact(face, plane, room);
        }
      for (unsigned i = 0; i < kRows; ++i) {
        forces[i] = room.force[i];
        for (unsigned j = 0; j < kRows; ++j) local(i, j) = room.stiffness(i, j);
      }
      constraints_.distribute_local_to_global(local, forces, room.rows, matrix_, residual_);
    });
  }

  /// Pressures after a share of a step, linear.
  void predict_pressure(const Vector<double>& step, double share) {
    (void)each_cell([&](const Triangulation<3>::cell_iterator&, const Cell& room) {
      VectorXd du(kRows);
      for (int i = 0; i < kRows; ++i) du[i] = step[room.rows[static_cast<std::size_t>(i)]];
      const auto gram = room.gram.llt();
      const Eigen::Vector4d p =
          room.pressure + gram.solve(room.bulk * gram.solve(room.divergence * du));
      for (int m = 0; m < kModes; ++m) {
        double& now = p_[room.modes[static_cast<std::size_t>(m)]];
        now += share * (p[m] - now);
      }
    });
  }

  /// Newton's method with the plane at a height. @return whether it converged
  bool solve(double plane) {
    for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
      if (!assemble(plane)) return false;
      if (force_ > 0 && residual_.linfty_norm() <= kTolerance * force_) return true;
      SparseDirectUMFPACK factor;
      factor.factorize(matrix_);
      ++factorisations_;
      Vector<double> step = residual_;
      factor.solve(step);
      step *= -1;
      constraints_.distribute(step);
      const double share = share_of(step);
      predict_pressure(step, share);
      solution_.add(share, step);
    }
    return false;
  }

  /// To a height, in halves where it fails.
  bool go(double from, double to, int halvings) {
    const Vector<double> solution = solution_, p = p_;
    if (solve(to)) return true;
    if (halvings == kMaxHalvings) return false;
    solution_ = solution;
    p_ = p;
    const double middle = (from + to) / 2;
    return go(from, middle, halvings + 1) && go(middle, to, halvings + 1);
  }

  /// Whether some points of a cell's skin touch, and others do not.
  bool under_edge(const DoFHandler<3>::active_cell_iterator& cell) const {
    FEFaceValues<3> fe(mapping_, scalar_, QGauss<2>(4), update_values | update_quadrature_points);
    std::vector<types::global_dof_index> rows(kRows);
    cell->get_dof_indices(rows);
    unsigned touching = 0, all = 0;
    for (const unsigned f : cell->face_indices()) {
      if (!cell->face(f)->at_boundary() || cell->face(f)->boundary_id() != kSkin) continue;
      fe.reinit(Triangulation<3>::cell_iterator(cell), f);
      for (unsigned q = 0; q < fe.n_quadrature_points; ++q, ++all) {
        double z = fe.quadrature_point(q)[2];
        for (int a = 0; a < kNodes; ++a)
          z += fe.shape_value(static_cast<unsigned>(a), q) * solution_[rows[row(a, 2)]];
        if (z > pad_.half[2] - pad_.depth) ++touching;
      }
    }
    return touching > 0 && touching < all;
  }

  /// The cells with the largest jumps of stress, by displacements, and those under the patch's
  /// edge.
  void refine() {
    Vector<float> errors(triangulation_.n_active_cells());
    KellyErrorEstimator<3>::estimate(mapping_, dofs_, QGauss<2>(3), {}, solution_, errors);
    GridRefinement::refine_and_coarsen_fixed_number(triangulation_, errors, 0.15, 0);
    for (const auto& cell : dofs_.active_cell_iterators())
      if (under_edge(cell)) cell->set_refine_flag();
    triangulation_.prepare_coarsening_and_refinement();
    SolutionTransfer<3> carry(dofs_), carry_p(pressure_dofs_);
    carry.prepare_for_coarsening_and_refinement(solution_);
    carry_p.prepare_for_coarsening_and_refinement(p_);
    triangulation_.execute_coarsening_and_refinement();
    set_up();
    Vector<double> u(dofs_.n_dofs()), p(pressure_dofs_.n_dofs());
    carry.interpolate(solution_, u);
    carry_p.interpolate(p_, p);
    constraints_.distribute(u);
    solution_ = u;
    p_ = p;
  }

  const Pad& pad_;
  double penalty_;                  // [Pa/m]
  std::vector<unsigned> row_;       // (nodes, components)
  Triangulation<3> triangulation_;  // in the chart
  FESystem<3> displacement_;
  FE_Q<3> scalar_;
  FE_DGP<3> pressure_;
  MappingQCache<3> mapping_;
  DoFHandler<3> dofs_, pressure_dofs_;
  AffineConstraints<double> constraints_;
  SparsityPattern pattern_;
  SparseMatrix<double> matrix_;
  std::vector<SkinPoint> skin_;
  Vector<double> solution_, p_, residual_;
  double force_ = 0, deepest_ = 0;
  int factorisations_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: pad_dealii PAD CYCLES [CELLS PENALTY]\n");
    return 2;
  }
  try {
    MultithreadInfo::set_thread_limit(1);
    const Pad pad = read_pad(argv[1]);
    PadPress press(pad, argc > 4 ? std::atof(argv[4]) : 1e11);
    press.run(std::atoi(argv[2]), argc > 3 ? static_cast<unsigned>(std::atoi(argv[3])) : 2000);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "pad_dealii: %s\n", error.what());
    return 1;
  }
  return 0;
}
