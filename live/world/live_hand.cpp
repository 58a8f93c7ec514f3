#include "live/world/live_hand.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "api/named/material_names.h"
#include "base/lists.h"
#include "base/numbers.h"
#include "base/progress_parts.h"
#include "base/provenance.h"
#include "hand/skin/human_surfaces.h"
#include "hand_versions/human_hand.h"
#include "live/world/nail_mesh.h"

namespace thenar {
namespace {

constexpr int kSmoothSkinTriangles = 2500;  // triangles of a link's skin; enough to look smooth

/// Builds the drawn body of a surface.
HandBody body_of_surface(const LinkSurface& surface, LiveRole role, const std::string& name) {
  HandBody body;
  body.look.name = name;
  body.look.digit = surface.digit;
  body.look.material = surface.material;
  body.look.role = role;
  body.look.mesh = picture_of_solid(surface.solid);
  body.look.crease = crease_of(surface.material);
  body.link = surface.link;
  return body;
}

void add_surface_bodies(LiveHand& hand) {
  const std::vector<LinkSurface>& surfaces = hand.model().surfaces();
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    const LiveRole role = surfaces[s].material == "bone" ? LiveRole::kBone : LiveRole::kLink;
    hand.bodies.push_back(body_of_surface(surfaces[s], role, surfaces[s].name));
    hand.bodies.back().carried = s < static_cast<std::size_t>(hand.hand.carrier_surfaces);
    hand.balls.push_back(ball_around(surfaces[s].solid->visual));
  }
}

/// Adds the nails of fingertips with drawn skin.
void add_nails(LiveHand& hand) {
  // Cut each nail out of the skin of its fingertip.
  for (const SkinPatch& patch : hand.hand.named.patches) {
    if (patch.kind != PatchKind::kNail) continue;
    for (const LinkSurface& surface : hand.model().surfaces()) {
      const bool skin = surface.material == "skin" || surface.material == "fingertip";
      if (!skin || surface.digit != patch.middle.digit || surface.link != patch.middle.link)
        continue;
      auto mesh = std::make_shared<TriangleMesh>(nail_mesh(surface.solid->visual, patch));
      if (mesh->empty()) continue;
      HandBody nail = body_of_surface(surface, LiveRole::kNail, surface.digit + " nail");
      nail.look.mesh = std::move(mesh);
      hand.bodies.push_back(std::move(nail));
    }
  }
}

/// Adds the bones under the skin of a human hand; in a hand without skin they are the surfaces.
void add_bones(LiveHand& hand) {
  const NamedHand& named = hand.hand.named;
  const std::vector<LinkSurface>& surfaces = hand.model().surfaces();
  if (named.skeleton == nullptr || surfaces.empty() || surfaces[0].material == "bone") return;
  const Subject subject = named.file.empty() ? default_human() : read_subject(named.file);
  for (const LinkSurface& bone : bone_surfaces(subject, *named.skeleton))
    hand.bodies.push_back(body_of_surface(bone, LiveRole::kBone, bone.name + " bone"));
}

/// Adds the joints, and bodies without a mesh for links without a surface (of universal joints).
void add_joints(LiveHand& hand) {
  hand.joints = hand_joints(hand.model());
  hand.couplings = joint_couplings(hand.model());
  // Find the body that holds each axis, or add one.
  for (const HandJoint& joint : hand.joints) {
    const auto holder = std::find_if(hand.bodies.begin(), hand.bodies.end(),
                                     [&](const HandBody& body) { return body.link == joint.link; });
    hand.joint_bodies.push_back(static_cast<int>(holder - hand.bodies.begin()));
    if (holder != hand.bodies.end()) continue;
    HandBody frame;
    frame.look.name = fmt::format("link {}", joint.link);
    frame.look.role = LiveRole::kLink;
    frame.link = joint.link;
    hand.bodies.push_back(std::move(frame));
  }
}

}  // namespace

Ball ball_around(const TriangleMesh& mesh) {
  if (mesh.vertices.cols() == 0) return {};
  const Eigen::Vector3d middle =
      (mesh.vertices.rowwise().minCoeff() + mesh.vertices.rowwise().maxCoeff()) / 2;
  return {middle, (mesh.vertices.colwise() - middle).colwise().norm().maxCoeff()};
}

std::shared_ptr<const LiveHand> build_live_hand(const WorldSpec& world, const std::string& name,
                                                const std::string& path,
                                                const std::vector<std::string>& data,
                                                const Progress& progress) {
  report_or_stop(progress, 0, "building hand '" + name + "'");
  // Use a smooth skin.
  HumanHandOptions human;
  human.skin.drawn = kSmoothSkinTriangles;
  human.skin.progress = progress;
  auto hand = std::make_shared<LiveHand>();
  // Build the hand without the bodies of the world, whose warnings do not concern it.
  WorldSpec hands_alone = world;
  hands_alone.bodies.clear();
  hand->hand = hand_of_world(hands_alone, name, path, data, human);
  require_materials(hand->hand.named, world.materials);
  // Add everything that is drawn.
  add_surface_bodies(*hand);
  add_nails(*hand);
  add_bones(*hand);
  add_joints(*hand);
  hand->tendons = hand_tendons(hand->model());
  return hand;
}

std::string live_hand_key(const WorldSpec& world, std::size_t hand,
                          const std::vector<std::string>& data) {
  // Walk from the hand over its carriers to the root, and add all that the robot is built from.
  std::string key;
  const auto file_of = [&](const PlacedHand& placed) {
    return placed.file.empty()
               ? robot_file(placed.name, data).value_or("")
               : (std::filesystem::path(world.folder) / placed.file).lexically_normal().string();
  };
  // The number of steps is bounded because the carriers of an invalid world may form a cycle.
  for (std::size_t steps = 0; steps <= world.hands.size(); ++steps) {
    const PlacedHand& placed = world.hands[hand];
    key += fmt::format("{}\n{}\n{}\n", current_hand_name(placed.name), file_of(placed),
                       placed.carrier_link);
    if (placed.carrier.empty()) return key;
    // Add the mount, and continue with the carrier.
    for (const double each : placed.X_WH.R.reshaped()) key += fmt::format("{} ", each);
    for (const double each : placed.X_WH.p) key += fmt::format("{} ", each);
    const auto carrier =
        std::find_if(world.hands.begin(), world.hands.end(), [&](const PlacedHand& other) {
          return current_hand_name(other.name) == current_hand_name(placed.carrier);
        });
    if (carrier == world.hands.end()) return key;
    hand = static_cast<std::size_t>(carrier - world.hands.begin());
  }
  return key;
}

bool is_up_to_date(const LiveHand& hand) {
  // Compare the digests of all files with those at the time of building.
  const FileDigests& files = hand.hand.named.files;
  try {
    return digests_of(map_keys(files)) == files;
  } catch (const DataError&) {
    return false;  // a file is missing
  }
}

void add_hand_shape(const LiveHand& hand, const std::string& name, const std::string& root,
                    LiveShape& shape) {
  // Add the bodies; those of carriers belong to the root and move with it.
  const int first = static_cast<int>(shape.bodies.size());
  for (const HandBody& body : hand.bodies) {
    LiveBody look = body.look;
    look.name = name + "/" + look.name;
    look.owner = body.carried ? root : name;
    look.movable = body.carried || root == name;
    shape.bodies.push_back(std::move(look));
  }
  // Add the joints with the names and limits of their coordinates.
  const HandLayout& layout = hand.model().layout();
  for (std::size_t j = 0; j < hand.joints.size(); ++j) {
    const HandJoint& joint = hand.joints[j];
    const int c = joint.coordinate;
    LiveJoint out;
    out.name = layout.coordinates[c];
    out.hand = name;
    out.body = first + hand.joint_bodies[j];
    out.axis = joint.axis;
    out.point = joint.point;
    out.slides = joint.slides;
    out.lower = layout.lower[c];
    out.upper = layout.upper[c];
    if (hand.couplings[c].leader >= 0) out.led_by = layout.coordinates[hand.couplings[c].leader];
    shape.joints.push_back(std::move(out));
  }
  // Add the tendons as lines.
  for (const HandTendon& tendon : hand.tendons)
    shape.lines.push_back(
        {tendon.name, tendon.digit, false, static_cast<int>(tendon.nodes.size())});
}

void add_hand_instant(const LiveHand& hand, const HandPlacement& placement, LiveInstant& instant) {
  // Compute the link poses in the hand's frame, and transform bodies to the world.
  const std::vector<Pose<double>> links = hand.model().pose(placement.q);
  for (const HandBody& body : hand.bodies)
    instant.bodies.push_back(body.link < 0 ? placement.X_WH : placement.X_WH * links[body.link]);
  for (const HandJoint& joint : hand.joints)
    instant.joints.push_back(placement.q[joint.coordinate]);
  // Add the lines; tensions of tendons are unknown in a world.
  for (const Eigen::Vector3d& p : tendon_points(hand.model(), hand.tendons, placement.q))
    instant.line_points.push_back(placement.X_WH * p);
  instant.tensions.insert(instant.tensions.end(), hand.tendons.size(), kNaN);
}

}  // namespace thenar
