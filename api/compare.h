#pragma once

/// Comparison of hands on the same objects by the same approaches: hands and objects by name, with
/// a file that stores completed pairs.
/// Example: examples/13_own_object.cpp.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "api/named/hands.h"
#include "base/progress.h"
#include "base/provenance.h"
#include "base/run_record.h"
#include "grasp/compare/comparison.h"
#include "solvers/status.h"

namespace thenar {

/// Options of a comparison: hands, objects, tasks, and the file of the result.
struct CompareRequest {
  // Hands, as hand_by_name() has them, and objects: names of objects/, or files.
  std::vector<std::string> hands{"human:orthogonal", "human:skewed", "human:soft",
                                 "human:tendons",    "barrett",      "dlr",
                                 "shadow",           "allegro",      "leap",
                                 "robonaut",         "parallel_jaw", "robotiq_2f85"};
  std::vector<std::string> objects{"sphere_70", "cube_50", "can", "box",
                                   "pen",       "mug",     "egg", "jar_lid"};
  std::vector<BodySpec> own_objects = {};  // further objects, see make_body()
  std::vector<GraspTask> tasks{GraspTask::kForceClosure, GraspTask::kHoldWeight};  // of each pair
  std::string data;          // folder with robots/ and objects/; empty: the usual ones
  int approaches = 20;       // approaches of each hand to each object
  int best = 3;              // grasps of each pair whose loads are computed
  int threads = 0;           // number of threads; 0: one for each processor; the result is the same
  unsigned seed = 1;         // seed of the approaches
  std::optional<Path> path;  // tendon paths of human hands whose names state none; absent:
                             // default_path()
  std::string materials;     // file of materials and friction, over the built-in table; or ""
  bool normalise_size =
      false;         // scale objects by the reach of the digits over that of the first hand
  std::string file;  // (.json) written after every pair; an existing file is continued; empty: none
  RunRecord run;     // record of the run for the file, where it has arguments
};

/// Comparison with its hands and objects. If stopped, it contains the completed cells.
struct CompareResult {
  CompareRequest request;         // request that was answered
  Outcome outcome;                // done: pairs of a hand and an object
  Comparison comparison;          // table of all pairs
  std::vector<NamedHand> hands;   // hands; human ones with finer meshes than for collisions
  std::vector<BodySpec> objects;  // unscaled
  std::map<std::string, std::string> inputs;  // everything the result depends on: "hand barrett" ->
                                              // its SHA-256 as it was read,
                                              // "fcl" -> its version
  FileDigests files;                          // digests of the files of all hands and objects
};

/// Compares hands on objects, by 20 random approaches of each hand to each object unless requested
/// otherwise. Hands with tendons close by the excursion of their flexors.
///
/// With a file, the result is written there after every pair, under a lock. The same request
/// continues the file of an earlier run, with the same final result; a different request throws.
/// For this the file holds the request without threads and the SHA-256 of each robot, subject and
/// object, meshes included, and of the program itself, which contains the built-in hand and the
/// materials.
/// @throws InputError for names that are not known (with the nearest), for a file of another
///         comparison or in use, and as compare(); DataError where a file is wrong or damaged.
[[nodiscard]] CompareResult compare_hands(const CompareRequest& request,
                                          const Progress& progress = {});

}  // namespace thenar
