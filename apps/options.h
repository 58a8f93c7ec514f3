#pragma once

/// Options that several commands share, beside those of tables of parameters.

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "base/fidelity.h"

namespace thenar {

/// --materials
void add_materials_option(CLI::App& command, std::string& file);

/// --data
void add_data_option(CLI::App& command, std::string& data);
/// --path via|fitted|wrapped
void add_path_option(CLI::App& command, std::optional<Path>& path);
/// --path of human hands in worlds, scenes and comparisons.
void add_hand_path_option(CLI::App& command, std::optional<Path>& path);
/// --path of fits, which have one rung.
void add_fit_path_option(CLI::App& command, std::optional<Path>& path);

/// Command lines that a person can copy, at the end of --help, behind a footer that is there.
/// @param lines  without the program: "pose barrett"
void add_examples(CLI::App& command, const std::vector<std::string>& lines);

/// @throws InputError unless `path` is empty or ends in one of `endings`.
void require_ending(const std::string& path, const std::vector<std::string>& endings);

}  // namespace thenar
