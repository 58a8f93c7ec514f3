#pragma once

/// The keys of a body, in a file of its own or inside a world.

#include <string>

#include "data/io/toml_table.h"
#include "data/io/world/world.h"

namespace thenar::internal {

/// Everything but its pose. @param path  of the file it stands in
[[nodiscard]] BodySpec read_body_keys(TomlTable& table, const std::string& path);

/// The same as TOML. @param prefix  of its tables of shapes: "" or "body."
[[nodiscard]] std::string body_lines(const BodySpec& body, const std::string& prefix);

/// `key = "value"`, or nothing for an empty value.
[[nodiscard]] std::string text_line(const std::string& key, const std::string& value);

/// `source = [..]`, or nothing if it is empty.
[[nodiscard]] std::string source_line(const std::string& source);

/// [sources] of what `own` tells, and of all keys that neither it nor data/sources.bib has.
[[nodiscard]] std::string sources_table(const std::vector<std::string>& sources,
                                        const OwnSources& own);

}  // namespace thenar::internal
