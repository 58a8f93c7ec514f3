#pragma once

/// Names as fields of structures in MATLAB and Octave, as their jsondecode makes them.

#include <string>
#include <vector>

namespace thenar {

/// Returns a name as a field: letters, digits and "_", a letter first, at most 63 of them. Blanks
/// go, and the letter behind one becomes a capital; other characters become "_"; what does not
/// begin with a letter gets an "x" in front. Two names may have one field. Source: MATLAB,
/// matlab.lang.makeValidName.
[[nodiscard]] std::string field_name(const std::string& name);

/// Returns the name of a list that is meant: the name itself, or that of a field, if it is of one
/// name alone; "" if there is none.
[[nodiscard]] std::string name_of_field(const std::string& field,
                                        const std::vector<std::string>& names);

}  // namespace thenar
