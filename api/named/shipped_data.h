#pragma once

/// Folders of the data that comes with thenar, independent of a person's own data.

#include <string>
#include <vector>

namespace thenar {

/// Returns the folder into which `cmake --install` puts data, found from the place of the program;
/// "" if the system does not tell that place.
[[nodiscard]] std::string installed_data();

/// Returns the folders of what comes with thenar: installed with the program, and in the sources
/// that it was built from.
[[nodiscard]] std::vector<std::string> shipped_data();

}  // namespace thenar
