#pragma once

/// Options that several commands share, in addition to those of parameter tables.

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "base/fidelity.h"

namespace thenar {

/// Adds --materials.
void add_materials_option(CLI::App& command, std::string& file);

/// Adds --data.
void add_data_option(CLI::App& command, std::string& data);
/// Adds --path via|fitted|wrapped.
void add_path_option(CLI::App& command, std::optional<Path>& path);
/// Adds --path for human hands in worlds, scenes and comparisons.
void add_hand_path_option(CLI::App& command, std::optional<Path>& path);
/// Adds --path for fits, which have one rung.
void add_fit_path_option(CLI::App& command, std::optional<Path>& path);

/// Adds example command lines at the end of --help, after an existing footer.
/// @param lines  command lines without the program: "pose barrett"
void add_examples(CLI::App& command, const std::vector<std::string>& lines);

/// Checks the ending of a path. @throws InputError unless it is one of `endings`.
void require_ending(const std::string& path, const std::vector<std::string>& endings);

}  // namespace thenar
