#pragma once

/// Pressed pad, as text, fields, a table and a page.

#include <string>

#include "api/pads/press_pad.h"
#include "base/provenance.h"
#include "report/fields.h"

namespace thenar {

inline constexpr double kSquareMm = 1e-6;   // A square millimetre [m^2]
inline constexpr double kKilopascal = 1e3;  // A kilopascal [Pa]

/// Returns a press as text: pad, object, every instant, the rungs, and the accuracy.
[[nodiscard]] std::string text_of(const PressResult& pressed);
/// Returns the fields of a press, with the nodes of the patch: places, pressure, stick.
[[nodiscard]] Fields fields_of(const PressResult& pressed);
/// Returns a table with a row for each instant.
[[nodiscard]] Table table_of(const PressResult& pressed);
/// Returns a page with the deformed pad in space, its pressure and stick from below, force over
/// depth, area over force, relaxation and rungs, as far as present. Defined in press_page.cpp.
[[nodiscard]] Json page_of(const PressResult& pressed);
[[nodiscard]] FileDigests files_of(const PressResult& pressed);

/// Returns the title with the end of the motion: "index_pad under a plane: 1 N at 1.84 mm".
[[nodiscard]] std::string title_of(const PressResult& pressed);
/// Returns a line on the conditions: "angle 20 deg, friction 0.6, instantaneous (no relaxation);
/// neo-hookean, Q1P0".
[[nodiscard]] std::string conditions_of(const PressResult& pressed);
/// Returns a table with a row for each rung, the finest last.
[[nodiscard]] Table rung_table(const PressResult& pressed);

/// Returns the reason why the result is incomplete: a failed step; empty if there is none. A press
/// that was stopped on request is not a failure.
[[nodiscard]] std::string refusal_of(const PressResult& pressed);

}  // namespace thenar
