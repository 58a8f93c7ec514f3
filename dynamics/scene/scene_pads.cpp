#include "dynamics/scene/scene_pads.h"

#include <algorithm>
#include <set>

#include <fmt/ranges.h>

#include "base/error.h"
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

constexpr int kBedRings = 18;        // of a bed, as laws are fitted with [LawFitOptions]
constexpr double kOutOfReach = 100;  // where no object touches yet [m]

/// A pad of a rung under an object.
std::shared_ptr<const MovingPad> moving_pad(const ScenePadSpec& pad, double scale,
                                            const RigidObject& object) {
  // Elements need the scaled shape alone, reduced laws their constants.
  PadModel model = build_pad(pad.spec);
  model.shape = scaled_shape(model.shape, scale);
  Pose<double> far;
  far.p.z() = kOutOfReach;
  if (pad.rung == "elements") return std::make_shared<ElementPad>(model, object, far);
  require(pad.law.has_value(), "the rung '{}' needs 'laws' of this pad", pad.rung);
  const CalibratedLaws laws = scaled_laws(*pad.law, scale);
  if (pad.rung == "foundation")
    return std::make_shared<BedPad>(
        std::make_shared<FoundationBed>(pad_columns(model.shape, kBedRings), laws.foundation,
                                        laws.relaxation),
        object, far);
  // Choose the law at a point.
  std::shared_ptr<const ContactLaw> law;
  if (pad.rung == "soft-finger")
    law = std::make_shared<SoftFinger>(laws.soft_finger, laws.relaxation);
  else
    law = std::make_shared<PowerLaw>(laws.power, laws.relaxation);
  return std::make_shared<LawPad>(pad.rung, model.shape, law, object, far);
}

/// The place that the file states, or that of the fingertip of a human hand.
PadPlace place_of(const ScenePadSpec& pad, const std::vector<SceneHuman>& humans) {
  if (pad.X_BP) return {*pad.X_BP, pad.scale.value_or(1)};
  for (const SceneHuman& human : humans)
    if (pad.on.compare(0, human.name.size() + 1, human.name + "/") == 0)
      return place_on_fingertip(human.hand, pad.on.substr(human.name.size() + 1), pad.spec,
                                pad.scale);
  throw InputError(fmt::format(
      "a pad needs a 'position': '{}' is no link of a human hand, whose fingertips have "
      "one; give 'position_mm' and 'rotation' of the pad's frame in it: origin in the "
      "middle of the nail's plane, x distal, y radial, z palmar",
      pad.on));
}

/// The body that carries a body by welds alone; -1: the world.
int carrier_by_welds(const Mechanism& mechanism, int body) {
  // Follow welds to the first joint that moves.
  while (body >= 0) {
    const MechanismJoint& joint = mechanism.joints[static_cast<std::size_t>(body)];
    if (joint.kind != JointKind::kWeld) return body;
    body = joint.parent;
  }
  return body;
}

/// One pad against one body. @param b  that body
void add_element(const SceneSpec& spec, const ScenePadSpec& pad, const PadPlace& place, int a,
                 int b, BuiltScene& built) {
  MovingScene& scene = built.scene;
  // The object with the pair's friction.
  const MechanismBody& other = scene.mechanism.bodies[static_cast<std::size_t>(b)];
  require(other.solid != nullptr, "'{}' has no shape that could press on a pad", other.name);
  const RigidObject object{other.solid->shape,
                           pad.friction ? *pad.friction : friction_between(spec, built, a, b)};
  // The pad presses in place of contacts between the two.
  scene.elements.push_back(std::make_shared<PadElement>(
      fmt::format("pad of {} on {}", pad.on, other.name), a, place.X_BP, b,
      moving_pad(pad, place.scale, object), PadElementOptions{pad.force_error}));
  scene.apart.emplace_back(std::minmax(a, b));
  ++built.pads;
}

void add_pad(const SceneSpec& spec, const ScenePadSpec& pad, const std::vector<SceneHuman>& humans,
             BuiltScene& built) {
  // A pad element against each body, which must move against the other.
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

PadPlace place_on_fingertip(const HumanMechanism& hand, const std::string& link, const PadSpec& pad,
                            std::optional<double> scale) {
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
  throw InputError(fmt::format("a pad needs a 'position': '{}' is no fingertip", link));
}

void add_pads(const SceneSpec& spec, const std::vector<SceneHuman>& humans, BuiltScene& built) {
  std::set<std::string> told;
  for (const ScenePadSpec& pad : spec.pads) {
    // What nobody measured of a pad that acts is told once.
    const std::vector<std::string> assumed = assumed_words(pad.spec);
    if (!assumed.empty() && pad.rung != "hard-point" && told.insert(pad.spec.name).second)
      built.warnings.push_back(fmt::format("pad '{}' is assumed, not measured, in {} numbers: {}",
                                           pad.spec.name, assumed.size(),
                                           fmt::join(assumed, ", ")));
    // Laws of one pad say nothing of another.
    const bool by_law = pad.rung != "elements" && pad.rung != "hard-point";
    if (by_law && pad.law && pad.law->name != pad.spec.name &&
        told.insert(pad.law->name + " of " + pad.spec.name).second)
      built.warnings.push_back(
          fmt::format("pad '{}' has laws that were calibrated for '{}': its forces are of that pad",
                      pad.spec.name, pad.law->name));
    if (by_law && pad.law && pad.law->name == pad.spec.name)
      if (const std::string doubt = version_doubt(*pad.law, pad.spec);
          !doubt.empty() && told.insert(doubt).second)
        built.warnings.push_back(doubt);
    at_line(spec.path, pad.line, [&] { add_pad(spec, pad, humans, built); });
  }
}

void set_hard_points(const SceneSpec& spec, BuiltScene& built) {
  MovingScene& scene = built.scene;
  for (const ScenePadSpec& pad : spec.pads) {
    if (pad.rung != "hard-point" || !pad.friction) continue;
    const int a = body_named(scene.mechanism, pad.on);
    // Friction of the pad for each pair, in place of what is stated.
    for (const std::string& name : pad.against) {
      const int b = body_named(scene.mechanism, name);
      const std::pair<int, int> bodies = std::minmax(a, b);
      PairFriction rub = pair_friction(scene, a, b);
      rub.coefficient = *pad.friction;
      const auto stated = std::find_if(scene.friction_pairs.begin(), scene.friction_pairs.end(),
                                       [&](const auto& pair) { return pair.first == bodies; });
      if (stated != scene.friction_pairs.end())
        stated->second = rub;
      else
        scene.friction_pairs.emplace_back(bodies, rub);
    }
  }
}

}  // namespace thenar
