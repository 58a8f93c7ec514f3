#pragma once

/// Names that commands accept: subjects, experiments, worlds, hands .. of all data folders, and the
/// parts of a subject or a robot.

#include <string>
#include <vector>

namespace thenar {

/// Options of a list of names.
struct CatalogueRequest {
  std::string what;  // "subjects", "hands" .., "joints", "muscles", "digits"; empty: all but parts
  std::string of;    // subject (name or file) or robot whose joints, muscles or digits are listed
  std::string materials;  // file of materials, over the built-in table; empty: that table
  std::string data;       // folder with subjects/ ..; empty: the usual ones
};

/// One name, with a description.
struct CatalogueEntry {
  std::string kind;         // "subject"
  std::string name;         // name that commands accept
  std::string about = {};   // its title, or a description of a joint or muscle; may be empty
  std::string source = {};  // citation keys; may be empty
  std::string file = {};    // empty: none of its own
};

struct Catalogue {
  std::vector<CatalogueEntry> entries;  // names, kind by kind
  std::vector<std::string> warnings;    // files that cannot be read
};

/// Returns "subjects", "experiments" .. "muscles": what a request may ask for.
[[nodiscard]] std::vector<std::string> catalogue_words();

/// Lists names in alphabetic order within each kind. Where several data folders have a name, the
/// first counts.
/// @throws InputError for an unknown word, or a subject or robot that is not to be found.
[[nodiscard]] Catalogue list_names(const CatalogueRequest& request);

}  // namespace thenar
