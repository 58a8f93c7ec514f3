#include "base/fidelity.h"

#include <array>

#include "base/error.h"

namespace thenar {
namespace {

constexpr std::array kMotion{"posed", "static", "dynamic"};
constexpr std::array kJoint{"hinge axes", "compliant joints"};
constexpr std::array kPath{"no tendons", "constant moment arms", "via points", "fitted paths",
                           "wrapped paths"};
constexpr std::array kHood{"separate tendons", "fixed force fractions", "floating net"};
constexpr std::array kMuscle{"force bounds", "rigid-tendon Hill", "elastic tendon"};
constexpr std::array kContact{"no contact", "hard point", "soft finger", "elastic foundation",
                              "finite-element pad"};

template <typename Names, typename Rung>
const char* name(const Names& names, Rung rung) {
  return names[static_cast<std::size_t>(rung)];
}

template <typename Names, typename Rung>
void require_rung(const Names& names, Rung have, Rung need, const std::string& question) {
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
