#include "base/fidelity.h"

#include "base/error.h"

namespace thenar {
namespace {

constexpr const char* kMotion[] = {"posed", "static", "dynamic"};
constexpr const char* kJoint[] = {"hinge axes", "compliant joints"};
constexpr const char* kPath[] = {"no tendons", "constant moment arms", "via points", "fitted paths",
                                 "wrapped paths"};
constexpr const char* kHood[] = {"separate tendons", "fixed force fractions", "floating net"};
constexpr const char* kMuscle[] = {"force bounds", "rigid-tendon Hill", "elastic tendon"};
constexpr const char* kContact[] = {"no contact", "hard point", "soft finger", "elastic foundation",
                                    "finite-element pad"};

using Names = const char* const*;  // of the rungs of one ladder

template <typename Rung>
const char* name(Names names, Rung rung) {
  return names[static_cast<std::size_t>(rung)];
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

void require_fidelity(const Fidelity& have, const Fidelity& need, const std::string& question) {
  require_rung(kMotion, have.motion, need.motion, question);
  require_rung(kJoint, have.joint, need.joint, question);
  require_rung(kPath, have.path, need.path, question);
  require_rung(kHood, have.hood, need.hood, question);
  require_rung(kMuscle, have.muscle, need.muscle, question);
  require_rung(kContact, have.contact, need.contact, question);
}

}  // namespace thenar
