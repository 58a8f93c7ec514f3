#pragma once

/// The citation keys that data files may name.

#include <string>
#include <vector>

namespace thenar {

/// The keys of the entries of a BibTeX text, in its order.
[[nodiscard]] std::vector<std::string> citation_keys(const std::string& bibtex);

/// The keys of data/sources.bib, as it was when the program was built.
[[nodiscard]] const std::vector<std::string>& known_sources();

}  // namespace thenar
