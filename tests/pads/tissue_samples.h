#pragma once

/// Tissues and blocks of tissue that several tests press.

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "pads/press_step.h"

namespace thenar {

/// A neo-Hookean tissue.
inline Tissue neo_hookean(double shear_modulus, double poisson_ratio) {
  Tissue tissue;
  tissue.shear_modulus = shear_modulus;
  tissue.poisson_ratio = poisson_ratio;
  return tissue;
}

/// Plane-strain modulus E / (1 - nu^2) = 2 mu / (1 - nu) [Pa].
inline double plane_modulus(const Tissue& tissue) {
  return 2 * tissue.shear_modulus / (1 - tissue.poisson_ratio);
}

/// Coordinates from 0 to end: cells of `fine` up to `core`, then each larger by `growth`.
inline std::vector<double> graded_half(double fine, double core, double growth, double end) {
  std::vector<double> out{0};
  double size = fine;
  while (out.back() < end) {
    if (out.back() > core * (1 - 1e-9)) size *= growth;
    // The last cell takes what is left, unless that is much.
    const double left = end - out.back();
    out.push_back(left < 1.5 * size ? end : out.back() + size);
  }
  return out;
}

/// Coordinates above 0 (the first), and their mirror images.
inline std::vector<double> mirrored(const std::vector<double>& half) {
  std::vector<double> out(half.rbegin(), half.rend());
  for (double& each : out) each = -each;
  out.insert(out.end(), half.begin() + 1, half.end());
  return out;
}

/// Coordinates of evenly spaced planes.
inline std::vector<double> even_axis(double begin, double end, int cells) {
  std::vector<double> out;
  for (int i = 0; i <= cells; ++i) out.push_back(begin + (end - begin) * i / cells);
  return out;
}

/// A box whose cells have their faces at given coordinates; `moved` places its nodes.
/// @param x, y, z  rising [m]
inline HexMesh graded_box(
    const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& z,
    const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& moved = nullptr) {
  class Plain final : public HexChart {
   public:
    [[nodiscard]] Eigen::Vector3d place(const Eigen::Vector3d& c) const override { return c; }
  };
  const int nx = static_cast<int>(x.size()), ny = static_cast<int>(y.size()),
            nz = static_cast<int>(z.size());
  const auto node = [&](int i, int j, int k) { return (k * ny + j) * nx + i; };
  Eigen::Matrix3Xd at(3, nx * ny * nz);
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        const Eigen::Vector3d p(x[static_cast<std::size_t>(i)], y[static_cast<std::size_t>(j)],
                                z[static_cast<std::size_t>(k)]);
        at.col(node(i, j, k)) = moved ? moved(p) : p;
      }
  std::vector<HexCell> cells;
  for (int k = 0; k + 1 < nz; ++k)
    for (int j = 0; j + 1 < ny; ++j)
      for (int i = 0; i + 1 < nx; ++i) {
        HexCell cell;
        for (int c = 0; c < 8; ++c)
          cell.corners[static_cast<std::size_t>(c)] =
              node(i + (c & 1), j + ((c >> 1) & 1), k + ((c >> 2) & 1));
        cells.push_back(cell);
      }
  return {std::make_shared<Plain>(), at, std::move(cells)};
}

/// Splits, `levels` times, the cells that `wanted` names by two opposite corners.
inline void refine_where(
    HexMesh& mesh, int levels,
    const std::function<bool(const Eigen::Vector3d& low, const Eigen::Vector3d& high)>& wanted) {
  for (int level = 0; level < levels; ++level) {
    std::vector<int> marked;
    for (const int index : mesh.active()) {
      const HexCell& cell = mesh.cells()[static_cast<std::size_t>(index)];
      if (wanted(mesh.place(cell.corners[0]), mesh.place(cell.corners[7]))) marked.push_back(index);
    }
    mesh.refine(marked);
  }
}

/// A block of tissue from its held floor up to z = 0, where it may be touched.
struct TissueBlock {
  TissueBlock(HexMesh its_mesh, const std::vector<Tissue>& tissues,
              HexElement kind = HexElement::kMeanDilatation)
      : mesh(std::move(its_mesh)) {
    double floor = 0;
    for (int node = 0; node < mesh.nodes(); ++node) floor = std::min(floor, mesh.place(node)[2]);
    std::vector<bool> held, top;
    for (int node = 0; node < mesh.nodes(); ++node) {
      held.push_back(mesh.place(node)[2] < floor * (1 - 1e-9));
      top.push_back(mesh.place(node)[2] > 1e-9 * floor);
    }
    body = std::make_unique<TissueBody>(mesh, kind, tissues, held);
    surface = build_contact_surface(mesh, *body, top);
    factors = std::make_unique<PressFactors>(*body);
  }
  /// A state in which the object stands at X and touches nothing.
  [[nodiscard]] PressState at_rest(const Pose<double>& X) const {
    return rest_state(*body, surface, X);
  }
  PressOutcome press(const RigidObject& object, const PressGoal& goal, PressState& state,
                     const PressOptions& options = {}) {
    return press_step(*body, surface, object, goal, options, *factors, state);
  }
  /// Node of the mesh behind a place of the surface.
  [[nodiscard]] int node_of(std::size_t place) const { return mesh_node(*body, surface, place); }

  HexMesh mesh;
  std::unique_ptr<TissueBody> body;
  ContactSurface surface;
  std::unique_ptr<PressFactors> factors;
};

}  // namespace thenar
