#pragma once

/// Fidelity of a model: all physics that may be neglected.
///
/// Each ladder goes from the cheapest rung to the richest; each rung names its assumption. A
/// question states the rungs that it needs, and `a | b` is the richer rung of every ladder. Only
/// the builders of models depend on it.

#include <algorithm>
#include <string>
#include <vector>

namespace thenar {

enum class Motion { kPosed, kStatic, kDynamic };
enum class Joint { kHinge, kCompliant };
enum class Path { kNone, kConstant, kViaPoint, kFitted, kWrapped };
enum class Hood { kSeparate, kFractions, kFloatingNet };
enum class Muscle { kBounds, kRigidTendon, kElasticTendon };
enum class ContactModel { kNone, kHardPoint, kSoftFinger, kElasticFoundation, kFiniteElement };

/// One rung of every ladder; the default is the cheapest hand.
struct Fidelity {
  Motion motion = Motion::kPosed;   // posed < static < dynamic
  Joint joint = Joint::kHinge;      // hinge axes < compliant
  Path path = Path::kNone;          // none < constant arms < via points < fitted < wrapped
  Hood hood = Hood::kSeparate;      // separate tendons < fixed fractions < floating net
  Muscle muscle = Muscle::kBounds;  // bounds < rigid-tendon Hill < elastic tendon
  ContactModel contact = ContactModel::kNone;  // none < .. < finite elements

  Fidelity() = default;

  /// Sets the given rungs and leaves the other ladders at their lowest.
  template <typename... Rungs>
  constexpr explicit Fidelity(Rungs... rungs) {
    (set(rungs), ...);
  }

  constexpr void set(Motion rung) { motion = rung; }
  constexpr void set(Joint rung) { joint = rung; }
  constexpr void set(Path rung) { path = rung; }
  constexpr void set(Hood rung) { hood = rung; }
  constexpr void set(Muscle rung) { muscle = rung; }
  constexpr void set(ContactModel rung) { contact = rung; }
};

/// Returns the lowest fidelity that is sufficient for both questions.
[[nodiscard]] constexpr Fidelity operator|(const Fidelity& a, const Fidelity& b) {
  return Fidelity(std::max(a.motion, b.motion), std::max(a.joint, b.joint),
                  std::max(a.path, b.path), std::max(a.hood, b.hood), std::max(a.muscle, b.muscle),
                  std::max(a.contact, b.contact));
}

/// Returns one line for reports: "static, hinge, via points, fixed fractions, bounds, none".
[[nodiscard]] std::string describe(const Fidelity& fidelity);

/// One rung in words.
struct RungWords {
  std::string ladder;   // "motion"
  std::string rung;     // "static"
  std::string assumes;  // "inertia and damping do not matter"
};

/// Returns the rung of every ladder, with what it assumes.
[[nodiscard]] std::vector<RungWords> explain(const Fidelity& fidelity);

/// Throws InputError naming the first ladder on which `have` is below `need`.
void require_fidelity(const Fidelity& have, const Fidelity& need, const std::string& question);

}  // namespace thenar
