#include "live/recorded_digit_motion.h"

#include <utility>

#include "base/lists.h"
#include "base/numbers.h"
#include "tendons/net/net_continuation.h"

namespace thenar {

RecordedDigitMotion::RecordedDigitMotion(RecordedDigit run)
    : RecordedTimeline({run.time.begin(), run.time.end()}),
      run_(std::move(run)),
      name_(run_.subject.name + "/" + run_.digit),
      picture_(run_.subject, run_.digit, run_.tendons, run_.angle.row(0)) {
  append_all(run_.warnings, picture_.warnings());
}

LiveInstant RecordedDigitMotion::instant() const {
  const Eigen::VectorXd q = interpolated(run_.angle), t = interpolated(run_.tension);
  NetEquilibrium rest;
  if (const auto* net = dynamic_cast<const NetTendons*>(run_.tendons.get()))
    rest = follow_from_straight(*net, q, t).rest;
  LiveInstant instant = picture_.instant(q, t, rest);
  instant.time = shown_time();
  return instant;
}

MotionEnergy RecordedDigitMotion::energy() const {
  const auto interpolated_energy = [&](const auto& all) {
    return interpolated_number([&](std::size_t i) { return all[i]; });
  };
  MotionEnergy out;
  // Interpolate the total energy; its parts are not recorded.
  out.kinetic = out.weight = out.springs = kNaN;
  out.total = interpolated_energy(run_.energy);
  // Balance it from the first instant: error = E_0 - E + work - dissipated.
  FlowBalance balance;
  balance.work = interpolated_energy(run_.work);
  balance.yielding = interpolated_energy(run_.dissipated);
  balance.error = run_.energy[0] - out.total + (balance.work - run_.work[0]) -
                  (balance.yielding - run_.dissipated[0]);
  out.balance = balance;
  return out;
}

TimelineState RecordedDigitMotion::state(const MotionParts& parts) const {
  const TendonNames& names = run_.tendons->digit().names;
  // Interpolate all recorded quantities at the time that is shown.
  const Eigen::VectorXd q = interpolated(run_.angle), q_dot = interpolated(run_.speed);
  const Eigen::VectorXd t = interpolated(run_.tension), a = interpolated(run_.activation);
  // Fill the selected parts.
  TimelineState out;
  out.t = shown_time();
  for (std::size_t c = 0; parts.joints && c < names.coordinates.size(); ++c)
    out.joints.push_back({names.coordinates[c], q[c], q_dot[c], std::nullopt});
  if (parts.energy) out.energy = energy();
  for (std::size_t m = 0; parts.muscles && m < names.muscles.size(); ++m) {
    out.muscles.push_back({names.muscles[m], "N", t[m]});
    out.muscles.push_back({names.muscles[m] + " activation", "1", a[m]});
  }
  return out;
}

}  // namespace thenar
