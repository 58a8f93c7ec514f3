// Tests for live/live_hand.cpp and hand_tendons.cpp.

#include "live/world/live_hand.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "api/named/worlds.h"
#include "base/error.h"
#include "tests/data_folder.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

WorldSpec world_with(const std::string& hand) {
  WorldSpec world;
  world.name = "test";
  world.hands.push_back({hand, "", {}, {}, "", ""});
  return world;
}

std::shared_ptr<const LiveHand> built(const std::string& name) {
  return build_live_hand(world_with(name), name, "test", {kData});
}

LiveShape shape_of(const LiveHand& hand) {
  LiveShape shape;
  add_hand_shape(hand, "hand", "hand", shape);
  return shape;
}

LiveInstant instant_of(const LiveHand& hand, const Eigen::VectorXd& q) {
  LiveInstant instant;
  add_hand_instant(hand, {{}, q}, instant);
  return instant;
}

std::size_t count(const LiveShape& shape, LiveRole role) {
  return static_cast<std::size_t>(
      std::count_if(shape.bodies.begin(), shape.bodies.end(),
                    [&](const LiveBody& body) { return body.role == role; }));
}

TEST(LiveHand, OfAHumanHasSkinFiveNailsAndItsBones) {
  const auto hand = built("human:tendons");
  const LiveShape shape = shape_of(*hand);
  EXPECT_EQ(count(shape, LiveRole::kNail), 5U);
  EXPECT_EQ(count(shape, LiveRole::kBone),
            16U);  // fourteen phalanges, the thumb's metacarpal, palm
  EXPECT_GE(count(shape, LiveRole::kLink), 16U);
  std::set<std::string> names;
  for (const LiveBody& body : shape.bodies)
    EXPECT_TRUE(names.insert(body.name).second) << body.name;
  // Bones lie within the skin of their link.
  for (const HandBody& body : hand->bodies) {
    if (body.look.role != LiveRole::kBone) continue;
    for (const LinkSurface& surface : hand->model().surfaces())
      if (surface.name + " bone" == body.look.name) {
        EXPECT_EQ(surface.link, body.link);
        const Eigen::Matrix3Xd& v = body.look.mesh->vertices;
        EXPECT_LT(surface.solid->shape->distance(v.rowwise().mean()), 0) << surface.name;
      }
  }
}

TEST(LiveHand, SharesMeshesWithItsSurfaces) {
  const auto hand = built("barrett");
  for (std::size_t s = 0; s < hand->model().surfaces().size(); ++s)
    EXPECT_EQ(hand->bodies[s].look.mesh.get(), &hand->model().surfaces()[s].solid->visual);
}

TEST(LiveHand, TendonsRunAlongTheirDigitsInAnyPosture) {
  const auto hand = built("human:tendons");
  ASSERT_GE(hand->tendons.size(), 30U);
  const HandLayout& layout = hand->model().layout();
  for (const double bend : {0.0, 0.5, 0.9}) {
    const Eigen::VectorXd q = (bend * layout.upper).cwiseMax(layout.lower).cwiseMin(layout.upper);
    const std::vector<Pose<double>> links = hand->model().pose(q);
    const std::vector<Eigen::Vector3d> points = tendon_points(hand->model(), hand->tendons, q);
    std::size_t next = 0;
    for (const HandTendon& tendon : hand->tendons) {
      EXPECT_LE(tendon.nodes.size(), static_cast<std::size_t>(kMaxStrandPoints));
      // The insertion lies on or in the flesh of its own digit, within 5 mm: points were measured
      // on other hands than skin was made for.
      const Eigen::Vector3d insertion = points[next];
      next += tendon.nodes.size();
      double nearest = 1;
      for (const LinkSurface& surface : hand->model().surfaces()) {
        if (surface.digit != tendon.digit && !surface.digit.empty()) continue;
        const Eigen::Vector3d p =
            surface.link < 0 ? insertion
                             : links[static_cast<std::size_t>(surface.link)].inverse() * insertion;
        nearest = std::min(nearest, surface.solid->shape->distance(p));
      }
      EXPECT_LT(nearest, 5e-3) << tendon.digit << " " << tendon.name;
    }
    EXPECT_EQ(next, points.size());
  }
}

/// Bytes of a frame, by its format: head, bodies, joints, lines, contacts, arrows, points.
std::size_t frame_bytes(const LiveInstant& instant) {
  return 52 + 28 * instant.bodies.size() + 4 * instant.joints.size() + 4 * instant.tensions.size() +
         44 * instant.contacts.size() + 24 * instant.arrows.size() + 6 * instant.line_points.size();
}

TEST(LiveHand, OfAHumanWithTendonsFitsAFrameOfFourKilobytes) {
  const auto hand = built("human:tendons");
  const LiveInstant instant =
      instant_of(*hand, Eigen::VectorXd::Zero(static_cast<Eigen::Index>(hand->couplings.size())));
  check_instant(shape_of(*hand), instant);
  EXPECT_LT(frame_bytes(instant), 4096U);
  for (const double tension : instant.tensions) EXPECT_TRUE(std::isnan(tension));
}

TEST(LiveHand, JointsAreDrawnOnBodiesOfTheirLinks) {
  for (const char* name : {"human:soft", "barrett", "robotiq_2f85", "shadow"}) {
    const auto hand = built(name);
    const LiveShape shape = shape_of(*hand);
    ASSERT_EQ(shape.joints.size(), hand->joints.size());
    for (std::size_t j = 0; j < shape.joints.size(); ++j) {
      const auto body = static_cast<std::size_t>(shape.joints[j].body);
      EXPECT_EQ(hand->bodies[body].link, hand->joints[j].link) << name;
      EXPECT_LE(shape.joints[j].lower, shape.joints[j].upper);
    }
  }
}

TEST(LiveHand, KeysTellHandsApartByWhatIsBuilt) {
  WorldSpec world = world_with("barrett");
  const std::vector<std::string> data = data_for("", kData);
  const std::string before = live_hand_key(world, 0, data);
  world.hands[0].X_WH.p.x() = 1;
  world.hands[0].posture["finger 1 proximal"] = 1;
  EXPECT_EQ(live_hand_key(world, 0, data), before);
  world.hands[0].name = "shadow";
  EXPECT_NE(live_hand_key(world, 0, data), before);
}

}  // namespace
}  // namespace thenar
