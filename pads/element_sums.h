#pragma once

/// Sums over the Gauss points of an element, four points at a time.
///
/// Data of points are stored side by side: entry k of point q at [k * points + q], with points a
/// multiple of four; the padding points are copies with zero weight.

namespace thenar {

/// Returns the number of points padded to a multiple of four.
[[nodiscard]] constexpr int padded_points(int points) { return (points + 3) / 4 * 4; }

/// Padded points and nodes of the largest element, which has 27 of each.
inline constexpr int kMaxPoints = 28, kMaxNodes = 27;

/// Deformation gradient F at all points, det F, and spatial gradients F^-T dN/dX.
struct PointKinematics {
  double F[9 * kMaxPoints];              // column-major (9, points) [1]
  double J[kMaxPoints];                  // (points) [1]
  double g[3 * kMaxNodes * kMaxPoints];  // (nodes, 3, points) [1/m]
};

/// Stress and tangent at all points, times their volumes. Symmetric entries are stored once, in the
/// order of Voigt.
struct PointStresses {
  double tau[6 * kMaxPoints];  // (6, points) [J]
  double c[21 * kMaxPoints];   // rows of the upper triangle (21, points) [J]
};
/// Returns the index of entry (p, q), p <= q, of a tangent among the 21.
[[nodiscard]] constexpr int tangent_entry(int p, int q) { return p * 6 - p * (p - 1) / 2 + q - p; }

/// Computes the kinematics of all points.
/// @param gradient  dN/dX [1/m] (nodes, 3, points);  @param u  displacements [m] (nodes, 3)
void point_kinematics(int nodes, int points, const double* gradient, const double* u,
                      PointKinematics& out);

/// Adds the nodal forces:  force += sum of B' tau.
/// @param g  spatial gradients [1/m] (nodes, 3, points);  @param force  [N] (nodes, 3)
void add_forces(int nodes, int points, const double* g, const PointStresses& at, double* force);

/// Adds to the upper triangle of the stiffness:  K += sum of  B' c B + (g_a . tau g_b) 1.
/// @param K  [N/m] (3 nodes, 3 nodes)
/// Source: [Bonet2008] ch. 9.
void add_stiffness(int nodes, int points, const double* g, const PointStresses& at, double* K);

}  // namespace thenar
