#include "dynamics/scene/scene_pads.h"

#include <algorithm>
#include <set>

#include <fmt/ranges.h>

#include "base/error.h"
#include "base/lists.h"
#include "data/io/pad/law_file.h"
#include "dynamics/pads/pad_element.h"
#include "dynamics/scene/scene_pairs.h"
#include "hand/skin/skin_landmarks.h"
#include "pads/build_pad.h"
#include "pads/motion/bed_pad.h"
#include "pads/motion/element_pad.h"
#include "pads/motion/law_pad.h"
#include "pads/pad_scale.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr int kBedRings = 18;             // rings of a foundation, as in LawFitOptions
constexpr double kInitialDistance = 100;  // initial distance of the object, out of contact [m]

/// Builds the moving pad of a rung under an object.
std::shared_ptr<const MovingPad> moving_pad(const ScenePadSpec& pad, double scale,
                                            const RigidObject& object) {
  // Finite elements need the scaled shape alone.
  PadModel model = build_pad(pad.spec);
  model.shape = scaled_shape(model.shape, scale);
  Pose<double> far;
  far.p.z() = kInitialDistance;
  if (pad.rung == "elements") return std::make_shared<ElementPad>(model, object, far);
  // Reduced laws need their calibrated constants.
  require(pad.law.has_value(), "the rung '{}' needs 'laws' of this pad", pad.rung);
  const CalibratedLaws laws = scaled_laws(*pad.law, scale);
  if (pad.rung == "foundation")
    return std::make_shared<BedPad>(
        std::make_shared<FoundationBed>(pad_columns(model.shape, kBedRings), laws.foundation,
                                        laws.relaxation),
        object, far);
  // Point laws.
  std::shared_ptr<const ContactLaw> law;
  if (pad.rung == "soft-finger")
    law = std::make_shared<SoftFinger>(laws.soft_finger, laws.relaxation);
  else
    law = std::make_shared<PowerLaw>(laws.power, laws.relaxation);
  return std::make_shared<LawPad>(pad.rung, model.shape, law, object, far);
}

/// Returns the pose and scale that the file states, or those on the fingertip of a human hand.
PadPlace place_of(const ScenePadSpec& pad, const std::vector<SceneHuman>& humans) {
  if (pad.X_BP) return {*pad.X_BP, pad.scale.value_or(1)};
  for (const SceneHuman& human : humans)
    if (pad.on.compare(0, human.name.size() + 1, human.name + "/") == 0)
      return fingertip_pad_place(human.hand, pad.on.substr(human.name.size() + 1), pad.spec,
                                 pad.scale);
  throw InputError(
      fmt::format("a pad needs a 'position': '{}' is not a link of a human hand, whose fingertips "
                  "have one; give 'position_mm' and 'rotation' of the pad's frame in it: origin in "
                  "the middle of the nail's plane, x distal, y radial, z palmar",
                  pad.on));
}

/// Adds the element of one pad on body a against body b.
void add_element(const SceneSpec& spec, const ScenePadSpec& pad, const PadPlace& place, int a,
                 int b, BuiltScene& built) {
  MovingScene& scene = built.scene;
  // Object with the friction of the pair.
  const MechanismBody& other = scene.mechanism.bodies[b];
  require(other.solid != nullptr, "'{}' has no shape that could press on a pad", other.name);
  const RigidObject object{other.solid->shape,
                           pad.friction ? *pad.friction : friction_between(spec, built, a, b)};
  // The element replaces rigid contacts between the two bodies.
  scene.elements.push_back(std::make_shared<PadElement>(
      fmt::format("pad of {} on {}", pad.on, other.name), a, place.X_BP, b,
      moving_pad(pad, place.scale, object), PadElementOptions{pad.force_error}));
  scene.excluded_pairs.emplace_back(std::minmax(a, b));
  ++built.pads;
}

void add_pad(const SceneSpec& spec, const ScenePadSpec& pad, const std::vector<SceneHuman>& humans,
             BuiltScene& built) {
  // Place the pad, and add an element for each body that can move relative to it.
  const int a = body_named(built.scene.mechanism, pad.on);
  const PadPlace place = place_of(pad, humans);
  for (const std::string& name : pad.against) {
    const int b = body_named(built.scene.mechanism, name);
    require(
        carrier_by_welds(built.scene.mechanism, a) != carrier_by_welds(built.scene.mechanism, b),
        "'{}' and '{}' do not move against each other: no pad is pressed between them", pad.on,
        name);
    if (pad.rung != "hard-point") add_element(spec, pad, place, a, b, built);
  }
}

}  // namespace

PadPlace fingertip_pad_place(const HumanMechanism& hand, const std::string& link,
                             const PadSpec& pad, std::optional<double> scale) {
  // Frame of the pad: z outward, x along the finger, origin one height below the skin.
  for (const SkinPatch& patch : skin_patches(find_anatomy(hand.subject), hand.skeleton)) {
    if (patch.kind != PatchKind::kPad || patch.middle.segment != link) continue;
    PadPlace out;
    out.scale = scale.value_or(2 * patch.half_breadth / pad.width);
    const Vector3d z = patch.middle.outward.normalized();
    const Vector3d x = (patch.along - z * z.dot(patch.along)).normalized();
    out.X_BP.R << x, z.cross(x), z;
    out.X_BP.p = patch.middle.p - out.scale * pad.height * z;
    return out;
  }
  throw InputError(fmt::format("a pad needs a 'position': '{}' is not a fingertip", link));
}

void add_pads(const SceneSpec& spec, const std::vector<SceneHuman>& humans, BuiltScene& built) {
  std::set<std::string> reported;
  for (const ScenePadSpec& pad : spec.pads) {
    // Warn of assumed numbers, once for each pad.
    const std::vector<std::string> assumed = assumed_words(pad.spec);
    if (!assumed.empty() && pad.rung != "hard-point" && reported.insert(pad.spec.name).second)
      built.warnings.push_back(fmt::format("pad '{}' is assumed, not measured, in {} numbers: {}",
                                           pad.spec.name, assumed.size(),
                                           fmt::join(assumed, ", ")));
    // Warn of laws that were calibrated for another pad or another version of it.
    const bool by_law = pad.rung != "elements" && pad.rung != "hard-point";
    if (by_law && pad.law && pad.law->name != pad.spec.name &&
        reported.insert(pad.law->name + " of " + pad.spec.name).second)
      built.warnings.push_back(
          fmt::format("pad '{}' has laws that were calibrated for '{}': its forces are of that pad",
                      pad.spec.name, pad.law->name));
    if (by_law && pad.law && pad.law->name == pad.spec.name)
      if (const std::string doubt = version_doubt(*pad.law, pad.spec);
          !doubt.empty() && reported.insert(doubt).second)
        built.warnings.push_back(doubt);
    at_line(spec.path, pad.line, [&] { add_pad(spec, pad, humans, built); });
  }
}

void set_hard_point_friction(const SceneSpec& spec, BuiltScene& built) {
  MovingScene& scene = built.scene;
  for (const ScenePadSpec& pad : spec.pads) {
    if (pad.rung != "hard-point" || !pad.friction) continue;
    const int a = body_named(scene.mechanism, pad.on);
    // Override the friction of each pair.
    for (const std::string& name : pad.against) {
      const int b = body_named(scene.mechanism, name);
      const std::pair<int, int> bodies = std::minmax(a, b);
      PairFriction friction = pair_friction(scene, a, b);
      friction.coefficient = *pad.friction;
      const auto is_same = [&](const auto& pair) { return pair.first == bodies; };
      if (auto* stated = find_where(scene.friction_pairs, is_same))
        stated->second = friction;
      else
        scene.friction_pairs.emplace_back(bodies, friction);
    }
  }
}

}  // namespace thenar
