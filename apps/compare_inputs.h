#pragma once

/// What a comparison is asked to do, and what its result depends on.

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "api/hands.h"
#include "grasp/compare/comparison.h"

namespace thenar {

/// As given on the command line.
struct CompareQuestion {
  std::vector<std::string> hands{"human:orthogonal", "human:skewed", "human:soft",
                                 "human:tendons",    "barrett",      "dlr",
                                 "shadow",           "allegro",      "leap",
                                 "robonaut",         "parallel_jaw", "robotiq_2f85"};
  std::vector<std::string> objects{"sphere_70", "cube_50", "can", "box",
                                   "pen",       "mug",     "egg", "jar_lid"};
  std::vector<std::string> tasks{"force-closure", "hold-weight"};
  std::string data;  // folder; empty: where data_folders() looks
  int approaches = 20, best = 3, threads = 1;
  unsigned seed = 1;
  bool normalise = false;
};

/// The hands by their names, human ones drawn finer than they touch.
[[nodiscard]] std::vector<NamedHand> named_hands(const CompareQuestion& question);

/// The same to be compared. Those of tendons close by the excursion of their flexors.
[[nodiscard]] std::vector<ComparedHand> hands_of(const CompareQuestion& question,
                                                 const std::vector<NamedHand>& named);

/// The objects, of files or by their names.
/// @throws InputError that says how to make one of a mesh or another program's file.
[[nodiscard]] std::vector<BodySpec> objects_of(const CompareQuestion& question);

/// Everything but the names.
[[nodiscard]] CompareOptions options_of(const CompareQuestion& question);

/// What the result depends on, by name: the question but for threads, SHA-256 of each robot,
/// subject and object as it was read, meshes included, and of the program itself, which holds the
/// built-in hand and materials; versions of shared libraries.
[[nodiscard]] nlohmann::ordered_json compare_inputs(const CompareQuestion& question);

/// The same as name -> text, for a page.
[[nodiscard]] nlohmann::json compare_provenance(const nlohmann::ordered_json& inputs);

}  // namespace thenar
