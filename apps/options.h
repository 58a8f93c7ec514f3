#pragma once

/// Options that several commands share, and numbers as people type them: `FDP=10 PIP3=0:90:5`.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "api/named/digits.h"
#include "api/named/worlds.h"

namespace thenar {

/// A plain number. @param what  how messages call it: "an angle [deg]"
/// @throws InputError if the whole text is not one finite number.
[[nodiscard]] double parse_number(const std::string& text, const std::string& what);

/// `NAME=number` pairs. @param what  how messages call one: "JOINT=degrees"
/// @throws InputError if a text is no such pair, or a name comes twice.
[[nodiscard]] std::map<std::string, double> parse_named_numbers(
    const std::vector<std::string>& texts, const std::string& what);

/// A posture from `JOINT=degrees` pairs, or from plain numbers in the order of the joints.
/// @param what    how messages call a pair;  @param number  and a plain number
/// @throws InputError if a text is neither.
[[nodiscard]] PostureRequest parse_posture(const std::vector<std::string>& texts,
                                           const std::string& what = "JOINT=degrees",
                                           const std::string& number = "an angle [deg]");

/// `JOINT=from:to:step` [deg]. @throws InputError if the text is none.
[[nodiscard]] Vary parse_vary(const std::string& text);

/// --materials
void add_materials_option(CLI::App& command, std::string& file);

/// --data
void add_data_option(CLI::App& command, std::string& data);
/// --path via|fitted|wrapped
void add_path_option(CLI::App& command, std::optional<Path>& path);
/// --passive on|off
void add_passive_option(CLI::App& command, PassiveMoments& passive);
/// --path of human hands in worlds, scenes and comparisons.
void add_hand_path_option(CLI::App& command, std::optional<Path>& path);
/// --path of fits, which have one rung.
void add_fit_path_option(CLI::App& command, std::optional<Path>& path);
/// --posture JOINT=degrees ..
void add_posture_option(
    CLI::App& command, PostureRequest& posture,
    const std::string& help = "JOINT=degrees ..., or degrees in joint order; others stay at 0");
/// --frozen JOINT=degrees ..
void add_frozen_option(CLI::App& command, PostureRequest& frozen);
/// --vary JOINT=from:to:step ..
CLI::Option* add_vary_option(CLI::App& command, std::vector<Vary>& vary);
/// --hood separate|fractions|net. @param usual  the question's own: "net"
void add_hood_option(CLI::App& command, std::optional<Hood>& hood, const std::string& usual);
/// --net NAME|FILE
void add_net_option(CLI::App& command, std::string& net);

/// A command's own numbers: `NAME=number ..` as one option.
/// @param what  of one pair: "MUSCLE=newton"
CLI::Option* add_named_numbers(CLI::App& command, const std::string& option,
                               std::map<std::string, double>& named, const std::string& what,
                               const std::string& help);

/// SUBJECT, --digit, --posture, --frozen, --path, --map, --data: linear tendons, or a tip map.
void add_digit_options(CLI::App& command, DigitRequest& request);

/// SUBJECT, --digit, --hood, --path, --net, --posture, --frozen, --data: tendons on every rung.
/// @param usual_hood  the question's own: "net"
void add_tendon_options(CLI::App& command, DigitRequest& request, const std::string& usual_hood);

/// WORLD, --hand, --object, --data.
void add_world_options(CLI::App& command, WorldRequest& request);

/// Command lines that a person can copy, at the end of --help, behind a footer that is there.
/// @param lines  without the program: "pose barrett"
void add_examples(CLI::App& command, const std::vector<std::string>& lines);

/// Refuses numbers below a least value:
/// "--approaches: wanted a whole number of at least 1, got 0".
[[nodiscard]] CLI::Validator at_least(long least);

/// @throws InputError unless `path` is empty or ends in one of `endings`.
void require_ending(const std::string& path, const std::vector<std::string>& endings);

}  // namespace thenar
