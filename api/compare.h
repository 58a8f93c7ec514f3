#pragma once

/// Hands on the same objects by the same approaches: hands and objects by name, a file that keeps
/// what is done.

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

/// Options of a comparison: hands, objects, tasks, and the place where the result is kept.
struct CompareRequest {
  std::vector<std::string> hands{"human:orthogonal", "human:skewed", "human:soft",
                                 "human:tendons",    "barrett",      "dlr",
                                 "shadow",           "allegro",      "leap",
                                 "robonaut",         "parallel_jaw", "robotiq_2f85"};
  std::vector<std::string> objects{"sphere_70", "cube_50", "can", "box",
                                   "pen",       "mug",     "egg", "jar_lid"};
  std::vector<BodySpec> own_objects = {};  // further objects, see make_body()
  std::vector<std::string> tasks{"force-closure",
                                 "hold-weight"};  // tasks by name; also "pull", "turn"
  std::string data;             // folder with robots/ and objects/; empty: the usual ones
  int approaches = 20;          // approaches of each hand to each object
  int best = 3;                 // number of grasps of each pair whose loads are computed
  int threads = 0;              // 0: as many as there are processors; the answer is the same
  unsigned seed = 1;            // of the approaches
  std::optional<Path> path;     // tendon paths of human hands whose names state none; absent:
                                // default_path()
  std::string materials;        // file of materials and friction, over the built-in table; or ""
  bool normalise_size = false;  // objects scaled by the reach of the digits over the first hand's
  std::string file;             // (.json) written after every pair; one that is there is gone on
                                // with; empty: nothing is kept
  RunRecord run;                // record of the run for the file, where it has arguments
};

/// A comparison with the hands and objects that were compared. Stopped: its cells are whole as far
/// as they go.
struct CompareResult {
  CompareRequest request;
  Outcome outcome;  // done: pairs of a hand and an object
  Comparison comparison;
  std::vector<NamedHand> hands;               // human ones drawn finer than they touch
  std::vector<BodySpec> objects;              // unscaled
  std::map<std::string, std::string> inputs;  // everything the result depends on: "hand barrett" ->
                                              // its SHA-256 as it was read,
                                              // "fcl" -> its version
  FileDigests files;                          // digests of the files of all hands and objects
};

/// Compares hands on objects, by 20 random approaches of each hand to each object unless told
/// otherwise. Hands of tendons close by the excursion of their flexors.
///
/// With a file, the result is written there after every pair, under a lock. The same request goes
/// on with a file that an earlier run left, to the same result; another one is refused: the file
/// holds the request without threads, the SHA-256 of each robot, subject and object as it was read,
/// meshes included, and of the program itself, which holds the built-in hand and the materials.
/// @throws InputError for names that are not known (with the nearest), for a file of another
///         comparison or in use, and as compare(); DataError where a file is wrong or damaged.
[[nodiscard]] CompareResult compare_hands(const CompareRequest& request,
                                          const Progress& progress = {});

}  // namespace thenar
