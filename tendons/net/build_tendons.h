#pragma once

/// Construction of the tendons of a digit, linear or with a net, and the statics of its tip.

#include <memory>
#include <string>

#include "tendons/digit_tendons.h"
#include "tendons/forces/tip_force.h"
#include "tendons/net/build_net.h"

namespace thenar {

/// Builds the simplest tendons that have the requested path and hood models: linear ones up to
/// fixed fractions, a net beyond.
/// @param options      path and hood models; tendons of a net's digit that bypass the net have the
///         path model
/// @param description  description of the net; needed if and only if `options.hood` requests one
/// @throws InputError if the description is absent or the subject lacks something.
[[nodiscard]] std::unique_ptr<DigitTendons> build_digit_tendons(
    const Subject& subject, const std::string& digit, const TendonOptions& options = {},
    const NetDescription* description = nullptr, const NetBuildOptions& net = {});

/// Builds a digit with a net over separate tendons; the subject's hood rule is not used.
[[nodiscard]] std::unique_ptr<DigitTendons> build_net_tendons(const Subject& subject,
                                                              const std::string& digit,
                                                              const TendonOptions& options,
                                                              const NetDescription& description,
                                                              const NetBuildOptions& net = {});

/// Computes the statics of the tip at the tensions t that gave `pull`; R' t + tau_0 is the sum of
/// the tendons' torque and the passive one. For a net this holds at these tensions only: tau_0
/// includes the difference between the torque and R' t.
[[nodiscard]] TipStatics tip_statics(const TendonDigit& digit, const Eigen::VectorXd& q,
                                     const Eigen::VectorXd& t, const TendonTorque& pull);

/// Force of a pinned tip, with the warning of the tendons.
struct [[nodiscard]] TendonTip {
  TipForce force;
  std::string warning;  // warning of the tendons; may be empty
};

/// Solves  J' f = tau(q, t) + tau_0  for the force of a pinned tip.
/// @throws InputError as DigitTendons::evaluate() and tip_force().
TendonTip tip_force(const DigitTendons& tendons, const Eigen::VectorXd& q,
                    const Eigen::VectorXd& t);

}  // namespace thenar
