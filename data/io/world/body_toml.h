#pragma once

/// Keys of a body, in a file of its own or in a world.

#include <string>

#include "data/io/toml_table.h"
#include "data/io/world/world.h"

namespace thenar::internal {

/// Reads all keys but those of the pose. @param path  of the file
[[nodiscard]] BodySpec read_body_keys(TomlTable& table, const std::string& path);

/// Returns the body as TOML. @param prefix  of its tables of shapes: "" or "body."
[[nodiscard]] std::string body_lines(const BodySpec& body, const std::string& prefix);

/// Returns the line `key = "value"`, or nothing for an empty value.
[[nodiscard]] std::string text_line(const std::string& key, const std::string& value);

/// Returns the line `source = [..]`, or nothing for an empty source.
[[nodiscard]] std::string source_line(const std::string& source);

/// Returns the table [sources] with all of `own`, and with keys that neither it nor
/// data/sources.bib has.
[[nodiscard]] std::string sources_table(const std::vector<std::string>& sources,
                                        const OwnSources& own);

}  // namespace thenar::internal
