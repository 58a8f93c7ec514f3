#include "grasp/compare/trial.h"

#include <random>
#include <string>
#include <vector>

#include "grasp/compare/centre.h"
#include "grasp/draw_start.h"

namespace thenar {
namespace {

enum class Stream { kStart, kPosture };

/// A generator of one approach: std::seed_seq gives every machine the same.
std::mt19937 generator(unsigned seed, const std::string& object, int number, Stream stream) {
  std::vector<unsigned> words{seed, static_cast<unsigned>(number), static_cast<unsigned>(stream)};
  for (const char letter : object) words.push_back(static_cast<unsigned char>(letter));
  std::seed_seq sequence(words.begin(), words.end());
  return std::mt19937(sequence);
}

}  // namespace

Trial draw_trial(const TouchingHand& hand, const SceneBody& object, unsigned seed, int number) {
  std::mt19937 posture = generator(seed, object.name, number, Stream::kPosture);
  std::mt19937 start = generator(seed, object.name, number, Stream::kStart);
  Trial trial;
  trial.q = draw_preshape(hand, number, posture);
  trial.way = way_past(hand, trial.q, object);
  trial.X_WH = draw_start(hand, trial.q, object, start);
  trial.stand_off = draw_stand_off(start);
  return trial;
}

Grasp try_grasp(const TouchingHand& hand, const Trial& trial, const Scene& scene,
                GraspOptions options) {
  options.way = trial.way;
  options.stand_off = trial.stand_off;
  return centred_grasp(hand, trial.X_WH, trial.q, scene, options);
}

}  // namespace thenar
