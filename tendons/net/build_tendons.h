#pragma once

/// Tendons of a digit on the rung that is asked for, and the statics of its tip.

#include <memory>
#include <string>

#include "tendons/digit_tendons.h"
#include "tendons/forces/tip_force.h"
#include "tendons/net/build_net.h"

namespace thenar {

/// Builds the simplest tendons of that rung: linear ones up to fixed fractions, a net beyond.
/// @param options      rungs of path and hood; whole tendons of a net's digit run on that of paths
/// @param description  the net; needed if and only if `options.hood` asks for one
/// @throws InputError if the description is absent or the subject lacks something.
[[nodiscard]] std::unique_ptr<DigitTendons> build_digit_tendons(
    const Subject& subject, const std::string& digit, const TendonOptions& options = {},
    const NetDescription* description = nullptr, const NetBuildOptions& net = {});

/// A digit with separate tendons, without its hood rule: the base of a net.
[[nodiscard]] std::unique_ptr<DigitTendons> build_net_tendons(const Subject& subject,
                                                              const std::string& digit,
                                                              const TendonOptions& options,
                                                              const NetDescription& description,
                                                              const NetBuildOptions& net = {});

/// Statics of the tip at the tensions t that gave `pull`; R' t + tau_0 is the tendons' torque and
/// the passive one. For a net this holds at these tensions only: tau_0 takes what R' t misses.
[[nodiscard]] TipStatics tip_statics(const TendonDigit& digit, const Eigen::VectorXd& q,
                                     const Eigen::VectorXd& t, const TendonTorque& pull);

/// Force of a pinned tip, and how far it can be trusted.
struct [[nodiscard]] TendonTip {
  TipForce force;
  std::string warning;  // of the tendons; may be empty
};

/// J' f = tau(q, t) + tau_0.
/// @throws InputError as DigitTendons::evaluate() and tip_force().
TendonTip tip_force(const DigitTendons& tendons, const Eigen::VectorXd& q,
                    const Eigen::VectorXd& t);

}  // namespace thenar
