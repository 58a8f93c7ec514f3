#include <algorithm>
#include <cstddef>

#include "base/fidelity.h"

#include "base/error.h"
#include "base/lists.h"
#include "base/nearest_name.h"

namespace thenar {
namespace {

/// A rung and the assumption it makes.
template <typename Rung>
struct Words {
  Rung rung;
  const char* name;
  const char* assumes;
};

constexpr Words<Motion> kMotion[] = {
    {Motion::kPosed, "posed",
     "forces are not asked for: bones are where the joint angles put them"},
    {Motion::kStatic, "static",
     "inertia and damping do not matter: all forces balance at every instant"},
    {Motion::kDynamic, "dynamic", "bones are rigid bodies with the masses stated"}};
constexpr Words<Joint> kJoint[] = {
    {Joint::kHinge, "hinge axes",
     "a joint turns about an axis fixed in its parent bone, and has no other compliance"},
    {Joint::kCompliant, "compliant joints",
     "ligaments are springs that let a joint yield under load"}};
constexpr Words<Path> kPath[] = {
    {Path::kNone, "no tendons", "no tendon acts"},
    {Path::kConstant, "constant moment arms", "moment arms do not change with the posture"},
    {Path::kViaPoint, "via points",
     "tendons run straight between points fixed in bones, and never lift off them"},
    {Path::kFitted, "fitted paths", "moment arms follow the posture as they were measured"},
    {Path::kWrapped, "wrapped paths", "tendons slide over smooth surfaces along the shortest way"}};
constexpr Words<Hood> kHood[] = {
    {Hood::kSeparate, "separate tendons", "no extensor tendon passes force to another"},
    {Hood::kFractions, "fixed force fractions",
     "the hood splits tension in fixed fractions, independent of load"},
    {Hood::kFloatingNet, "floating net",
     "bands of the hood are strings that find their own balance"}};
constexpr Words<Muscle> kMuscle[] = {
    {Muscle::kBounds, "force bounds",
     "a muscle pulls with any force from 0 to F0, whatever its length"},
    {Muscle::kRigidTendon, "rigid-tendon Hill",
     "force depends on fibre length and speed; tendons do not stretch"},
    {Muscle::kElasticTendon, "elastic tendon",
     "fibre and tendon share the length by their stiffness"}};
constexpr Words<ContactModel> kContact[] = {
    {ContactModel::kNone, "no contact", "no contact except at fingertips that a question holds"},
    {ContactModel::kHardPoint, "hard point",
     "a contact is one point that carries force but no moment"},
    {ContactModel::kSoftFinger, "soft finger",
     "a contact is a point that also resists twisting, within a friction limit"},
    {ContactModel::kElasticFoundation, "elastic foundation",
     "each spot of the pad is a spring of its own"},
    {ContactModel::kFiniteElement, "finite-element pad",
     "the pad is a continuum of the material stated"}};

template <typename Rung, std::size_t size>
const Words<Rung>& words_of(const Words<Rung> (&ladder)[size], Rung rung) {
  return *std::find_if(ladder, ladder + size,
                       [&](const Words<Rung>& each) { return each.rung == rung; });
}

template <typename Rung, std::size_t size>
void require_rung(const Words<Rung> (&ladder)[size], Rung have, Rung need,
                  const std::string& question) {
  require(have >= need, "{} needs '{}', but the model was built with '{}'", question,
          words_of(ladder, need).name, words_of(ladder, have).name);
}

}  // namespace

std::string describe(const Fidelity& f) {
  return listed(transformed(explain(f), [](const RungWords& words) { return words.rung; }));
}

std::vector<RungWords> explain(const Fidelity& f) {
  std::vector<RungWords> words;
  const auto add = [&](const char* ladder, const auto& rungs, auto rung) {
    const auto& is = words_of(rungs, rung);
    words.push_back({ladder, is.name, is.assumes});
  };
  // In the order of the ladders, from motion to contact.
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
