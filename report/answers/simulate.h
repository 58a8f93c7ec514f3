#pragma once

/// Text, fields and tables of a digit in motion.

#include <string>

#include "api/simulate.h"
#include "report/fields.h"

namespace thenar {

/// Returns a text with joints and muscles at the start, the end and their extremes, the tip, and
/// the energy account.
[[nodiscard]] std::string text_of(const DigitMotionResult& motion);
/// Returns the state at the end, and the energy account; `drift` is null where it is not known.
[[nodiscard]] Fields fields_of(const DigitMotionResult& motion);
/// Returns a table with a row for each instant: angles, speeds, excitations, activations, tensions,
/// excursions, slips, tip, energies. Columns: trajectory_table().
[[nodiscard]] Table table_of(const DigitMotionResult& motion);

/// Returns the reason why the motion must not be used: it ended early, or its energy does not
/// balance; empty if it may be used. A motion that was stopped on request may be used.
[[nodiscard]] std::string refusal_of(const DigitMotionResult& motion);

}  // namespace thenar
