#pragma once

/// Where what comes with thenar is, whatever else a person has.

#include <string>
#include <vector>

namespace thenar {

/// Where `cmake --install` puts data, seen from the program; "" if the system does not tell.
[[nodiscard]] std::string installed_data();

/// The folders of what comes with thenar: installed with the program, and in the sources that it was
/// built from.
[[nodiscard]] std::vector<std::string> shipped_data();

}  // namespace thenar
