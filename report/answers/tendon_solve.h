#pragma once

/// Text, fields and tables of a digit under tendon tensions.

#include <string>

#include "api/tendon_warnings.h"
#include "report/fields.h"

namespace thenar {

/// Returns a text with header, bands, nodes and contacts of a net, slips, joint torques, force of
/// the tip.
[[nodiscard]] std::string text_of(const TendonSolveResult& solution);
[[nodiscard]] Fields fields_of(const TendonSolveResult& solution);
/// Returns a table with the row of a sweep for this posture.
[[nodiscard]] Table table_of(const TendonSolveResult& solution);

/// Returns a text with first, last, least and largest slip tension, tip force and joint torque of
/// the sweep.
[[nodiscard]] std::string text_of(const TendonSweepResult& sweep);
/// Returns a list for each column of table_of().
[[nodiscard]] Fields fields_of(const TendonSweepResult& sweep);
/// Returns a table with a row for each posture: angles, status, slips, bands, tip force, torques,
/// moment arms.
[[nodiscard]] Table table_of(const TendonSweepResult& sweep);

/// Returns the reason why the result must not be used: unreliable tendons; empty if it may be used.
[[nodiscard]] std::string refusal_of(const TendonSolveResult& solution);
[[nodiscard]] std::string refusal_of(const TendonSweepResult& sweep);

/// Returns the tensions of the tendons that pull [N]: "EDC=2.9 LU=0.4".
[[nodiscard]] std::string tensions_in_words(const LoadedDigit& loaded);

/// Returns the name of a status: "balanced", "unstable", "drawn in", "stalled" or "wound round".
[[nodiscard]] std::string name_of(NetStatus status);
/// Returns the name of a status: "sound", "rough", .. "unbalanced".
[[nodiscard]] std::string name_of(TendonStatus status);

}  // namespace thenar
