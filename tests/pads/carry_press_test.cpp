// Tests for pads/carry_press.cpp.

#include "pads/carry_press.h"

#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "pads/pad_shape.h"
#include "tests/pads/tissue_samples.h"

namespace thenar {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A pad's mesh, of which no node is held, squeezed evenly to a fifth of its height.
class Squeezed : public testing::Test {
 protected:
  Squeezed() : mesh_(pad_mesh(PadShape{}, PadCells{})) {
    G_ = Vector3d(1.2, 0.9, -0.8).asDiagonal();
    body_ = body();
    surface_ = build_contact_surface(mesh_, *body_, skin_nodes(mesh_));
    state_ = rest_state(*body_, surface_, Pose<double>{});
    for (std::size_t i = 0; i < body_->free_nodes().size(); ++i)
      state_.x.segment<3>(static_cast<Eigen::Index>(3 * i)) =
          G_ * mesh_.place(body_->free_nodes()[i]);
    state_.normal_force = 300 * surface_.area;  // an even pressure [Pa]
  }

  [[nodiscard]] std::unique_ptr<TissueBody> body() const {
    return std::make_unique<TissueBody>(
        mesh_, HexElement::kMeanDilatation, std::vector<Tissue>{neo_hookean(12e3, 0.49)},
        std::vector<bool>(static_cast<std::size_t>(mesh_.nodes()), false));
  }

  /// Carries the state to the mesh with some cells split.
  PressState carried(const std::vector<int>& split) {
    const PressTransfer transfer(mesh_, std::move(body_), surface_);
    mesh_.refine(split);
    body_ = body();
    surface_ = build_contact_surface(mesh_, *body_, skin_nodes(mesh_));
    return transfer.transfer_state(state_, mesh_, *body_, surface_);
  }

  HexMesh mesh_;
  Matrix3d G_;  // gradient of the displacement [1]
  std::unique_ptr<TissueBody> body_;
  ContactSurface surface_;
  PressState state_;
};

TEST_F(Squeezed, NewNodesOfACurvedSkinGoWithTheTissue) {
  // An even strain stays one, wherever charts put nodes: also those that hang, and those that hung.
  for (const auto& split : {std::vector<int>{5, 6, 20}, std::vector<int>{7}, mesh_.active()}) {
    state_ = carried(split);
    for (std::size_t i = 0; i < body_->free_nodes().size(); ++i) {
      const Vector3d u = state_.x.segment<3>(static_cast<Eigen::Index>(3 * i));
      EXPECT_LT((u - G_ * mesh_.place(body_->free_nodes()[i])).norm(), 1e-12);
    }
  }
}

TEST_F(Squeezed, AnEvenPressureStaysEven) {
  const PressState state = carried(mesh_.active());
  ASSERT_EQ(state.normal_force.size(), surface_.area.size());
  for (Eigen::Index k = 0; k < state.normal_force.size(); ++k)
    EXPECT_NEAR(state.normal_force[k] / surface_.area[k], 300, 1e-9);
}

}  // namespace
}  // namespace thenar
