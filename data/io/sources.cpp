#include "data/io/sources.h"

#include <map>
#include <regex>
#include <string_view>

namespace thenar {

namespace internal {
const std::map<std::string, std::string_view>& citations();  // made by cmake/embed.cmake
}

std::vector<std::string> citation_keys(const std::string& bibtex) {
  static const std::regex entry("@[a-zA-Z]+\\{([^,\\s]+),");
  std::vector<std::string> keys;
  for (std::sregex_iterator it(bibtex.begin(), bibtex.end(), entry), end; it != end; ++it)
    keys.push_back((*it)[1]);
  return keys;
}

const std::vector<std::string>& known_sources() {
  static const std::vector<std::string> keys =
      citation_keys(std::string(internal::citations().at("sources.bib")));
  return keys;
}

}  // namespace thenar
