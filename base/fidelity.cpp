#include "base/fidelity.h"

#include "base/error.h"

namespace thenar {
namespace {

/// A rung and the assumption it makes.
struct Words {
  const char* name;
  const char* assumes;
};

constexpr Words kMotion[] = {
    {"posed", "forces are not asked for: bones are where the joint angles put them"},
    {"static", "inertia and damping do not matter: all forces balance at every instant"},
    {"dynamic", "bones are rigid bodies with the masses stated"}};
constexpr Words kJoint[] = {
    {"hinge axes", "a joint turns about an axis fixed in its parent bone, and yields no other way"},
    {"compliant joints", "ligaments are springs that let a joint yield under load"}};
constexpr Words kPath[] = {
    {"no tendons", "no tendon acts"},
    {"constant moment arms", "moment arms do not change with the posture"},
    {"via points", "tendons run straight between points fixed in bones, and never lift off them"},
    {"fitted paths", "moment arms follow the posture as they were measured"},
    {"wrapped paths", "tendons slide over smooth surfaces along the shortest way"}};
constexpr Words kHood[] = {
    {"separate tendons", "no extensor tendon passes force to another"},
    {"fixed force fractions", "the hood splits tensions in fixed parts, whatever the load"},
    {"floating net", "bands of the hood are strings that find their own balance"}};
constexpr Words kMuscle[] = {
    {"force bounds", "a muscle pulls with any force from 0 to F0, whatever its length"},
    {"rigid-tendon Hill", "force depends on fibre length and speed; tendons do not stretch"},
    {"elastic tendon", "fibre and tendon share the length by their stiffness"}};
constexpr Words kContact[] = {
    {"no contact", "the hand touches nothing but what a question holds its tips to"},
    {"hard point", "a contact is one point that carries force but no moment"},
    {"soft finger", "a contact is a point that also resists twisting, within a friction limit"},
    {"elastic foundation", "each spot of the pad is a spring of its own"},
    {"finite-element pad", "the pad is a continuum of the material stated"}};

using Names = const Words*;  // of the rungs of one ladder

template <typename Rung>
const char* name(Names names, Rung rung) {
  return names[static_cast<std::size_t>(rung)].name;
}

template <typename Rung>
void require_rung(Names names, Rung have, Rung need, const std::string& question) {
  require(have >= need, "{} needs '{}', but the model was built with '{}'", question,
          name(names, need), name(names, have));
}

}  // namespace

std::string describe(const Fidelity& f) {
  return fmt::format("{}, {}, {}, {}, {}, {}", name(kMotion, f.motion), name(kJoint, f.joint),
                     name(kPath, f.path), name(kHood, f.hood), name(kMuscle, f.muscle),
                     name(kContact, f.contact));
}

std::vector<RungWords> explain(const Fidelity& f) {
  std::vector<RungWords> words;
  const auto add = [&](const char* ladder, Names rungs, auto rung) {
    const Words& is = rungs[static_cast<std::size_t>(rung)];
    words.push_back({ladder, is.name, is.assumes});
  };
  add("motion", kMotion, f.motion);
  add("joint", kJoint, f.joint);
  add("path", kPath, f.path);
  add("hood", kHood, f.hood);
  add("muscle", kMuscle, f.muscle);
  add("contact", kContact, f.contact);
  return words;
}

void require_fidelity(const Fidelity& have, const Fidelity& need, const std::string& question) {
  require_rung(kMotion, have.motion, need.motion, question);
  require_rung(kJoint, have.joint, need.joint, question);
  require_rung(kPath, have.path, need.path, question);
  require_rung(kHood, have.hood, need.hood, question);
  require_rung(kMuscle, have.muscle, need.muscle, question);
  require_rung(kContact, have.contact, need.contact, question);
}

}  // namespace thenar
