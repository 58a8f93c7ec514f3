#pragma once

/// Names that commands take: subjects, experiments, worlds, hands .. of all data folders, and what
/// a subject or a robot is made of.

#include <string>
#include <vector>

namespace thenar {

/// Options of a list of names.
struct CatalogueRequest {
  std::string what;  // "subjects", "hands" .., "joints", "muscles", "digits"; empty: all but parts
  std::string of;    // subject (name or file), or robot, whose joints, muscles or digits are asked
  std::string materials;  // file of materials, over the built-in table; empty: that table
  std::string data;       // folder with subjects/ ..; empty: the usual ones
};

/// One name, with what it is.
struct CatalogueEntry {
  std::string kind;    // "subject"
  std::string name;    // as commands take it
  std::string about;   // its title, or what a joint or muscle is; may be empty
  std::string source;  // citation keys; may be empty
  std::string file;    // empty: none of its own
};

struct Catalogue {
  std::vector<CatalogueEntry> entries;
  std::vector<std::string> warnings;  // files that cannot be read
};

/// Returns "subjects", "experiments" .. "muscles": what a request may ask for.
[[nodiscard]] std::vector<std::string> catalogue_words();

/// Names in alphabetic order within each kind; where several data folders have one, the first.
/// @throws InputError for an unknown word, or a subject or robot that is not to be found.
[[nodiscard]] Catalogue list_names(const CatalogueRequest& request);

}  // namespace thenar
