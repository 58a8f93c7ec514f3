#pragma once

/// Shape of a finger pad: the pulp between a distal phalanx with its nail and the skin.

#include <memory>
#include <vector>

#include "geometry/shape.h"
#include "pad_laws/foundation_bed.h"
#include "pads/hex_mesh.h"

namespace thenar {

/// A layer of skin of uniform thickness.
struct SkinLayer {
  double thickness = 0;  // [m]
};

/// Pad between two half ellipsoids, bone and skin, on the plane of the nail. Frame: origin in the
/// middle of the nail's plane, x distal, y radial, z palmar. The rim, on the nail's plane, and the
/// bone's surface are fixed; the skin is free.
///
/// If the pad has its own skin (a closed mesh around the bone), the outer half ellipsoid gives
/// directions only: rays from the bone's surface along them end on that skin.
struct PadShape {
  double length = 24e-3, width = 16e-3, height = 10e-3;  // size of the skin [m]
  // Size of the phalanx [m]
  double bone_length = 14e-3, bone_width = 7e-3, bone_height = 4.5e-3;
  std::vector<SkinLayer> layers;      // layers from the outside in; the rest is pulp
  std::shared_ptr<const Shape> skin;  // skin in the pad's frame; null: the half ellipsoid
};

/// Chart of a pad's mesh: (a, b) on a disc, |(a, b)| = 1 on the rim, and the level w from 0 on the
/// bone to 1 on the skin.
class PadChart final : public HexChart {
 public:
  /// @throws InputError unless lengths are positive, the bone and all layers fit below the skin,
  /// and each ray meets the pad's own skin.
  explicit PadChart(PadShape shape);
  [[nodiscard]] Eigen::Vector3d place(const Eigen::Vector3d& c) const override;
  [[nodiscard]] Eigen::Vector3d middle(const Eigen::Vector3d& a,
                                       const Eigen::Vector3d& b) const override;
  [[nodiscard]] Eigen::Vector3d middle_of_face(const std::array<Eigen::Vector3d, 4>& corners,
                                               const Eigen::Vector3d& mean) const override;
  /// Returns the thickness of the soft tissue over point (a, b) of the bone [m].
  [[nodiscard]] double thickness(double a, double b) const;

  [[nodiscard]] static bool on_skin(const Eigen::Vector3d& c) { return c[2] > 1 - 1e-9; }
  [[nodiscard]] static bool on_bone(const Eigen::Vector3d& c) { return c[2] < 1e-9; }
  [[nodiscard]] static bool on_rim(const Eigen::Vector3d& c) {
    return c.head<2>().squaredNorm() > 1 - 1e-9;
  }

 private:
  [[nodiscard]] Eigen::Vector3d bone_point(double a, double b) const;
  [[nodiscard]] Eigen::Vector3d skin_point(double a, double b) const;
  [[nodiscard]] double level_depth(double w, double thickness) const;

  PadShape shape_;
};

/// Cell counts of the coarsest mesh: `across` along each side of the square in the middle of the
/// disc, `around` from it to the rim, `through` the pulp. Each layer of skin is one cell thick.
struct PadCells {
  int across = 4, around = 2, through = 3;
};

/// Builds the mesh of a pad. Without layers the levels w are evenly spaced. With n layers the pulp
/// has w from 0 to 1/2, and each layer 1 / (2 n) of the rest. Regions: 0 for the pulp, then layers
/// from the inside out.
[[nodiscard]] HexMesh pad_mesh(const PadShape& shape, const PadCells& cells);

/// Returns which nodes are on the skin (nodes of the mesh).
[[nodiscard]] std::vector<bool> skin_nodes(const HexMesh& mesh);

/// Returns which nodes are fixed, on the bone or on the rim (nodes of the mesh).
[[nodiscard]] std::vector<bool> held_by_bone(const HexMesh& mesh);

/// Returns the columns of a pad on `rings` rings of its disc, about 3 rings^2 in all, each as thick
/// as the soft tissue along its ray from the bone.
/// @throws InputError unless rings > 0, and as PadChart.
[[nodiscard]] FoundationColumns pad_columns(const PadShape& shape, int rings);

}  // namespace thenar
