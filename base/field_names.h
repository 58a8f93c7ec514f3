#pragma once

/// Names as fields of structures in MATLAB and Octave, following their jsondecode.

#include <string>
#include <vector>

namespace thenar {

/// Returns a name as a field: at most 63 letters, digits and "_", beginning with a letter. Spaces
/// are removed, and a letter after one is capitalised; other characters become "_"; an "x" is
/// prepended where the first is not a letter. Different names may have the same field. Source:
/// MATLAB, matlab.lang.makeValidName.
[[nodiscard]] std::string field_name(const std::string& name);

/// Returns the name that a field refers to: the name itself if it is in `names`, or the only name
/// with this field; "" if there is none.
[[nodiscard]] std::string name_of_field(const std::string& field,
                                        const std::vector<std::string>& names);

}  // namespace thenar
