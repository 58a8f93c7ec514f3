#pragma once

/// Folders of the data that comes with thenar, independent of a person's own data.

#include <string>
#include <vector>

namespace thenar {

/// Returns the folder of data installed by `cmake --install`, found from the location of the
/// program; "" if that location is not known.
[[nodiscard]] std::string installed_data();

/// Returns the folders of data that come with thenar: installed with the program, and in its
/// sources.
[[nodiscard]] std::vector<std::string> shipped_data();

}  // namespace thenar
