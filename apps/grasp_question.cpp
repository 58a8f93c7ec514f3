#include "apps/grasp_question.h"

#include "api/data_folders.h"
#include "base/error.h"
#include "data/io/file_kind.h"
#include "grasp/closing/closing_drives.h"

namespace thenar {
namespace {

constexpr int kSmooth = 2500;  // triangles of a link that look smooth

HumanHandOptions human_of(const WorldChoice& choice, const Progress& progress) {
  HumanHandOptions human;
  human.skin.drawn = choice.pictures ? kSmooth : 0;
  human.skin.progress = progress;
  return human;
}

std::string world_file(const WorldChoice& choice) {
  std::string file =
      named_file("world", choice.world, "worlds", ".toml", data_folders(choice.data));
  const FileKind kind = find_file_kind(file);
  require(kind == FileKind::kWorld, "'{}' is a file of kind '{}': wanted a world", file,
          name_of(kind));
  return file;
}

GraspQuestion question_of(const WorldChoice& choice) {
  GraspQuestion question;
  question.path = world_file(choice);
  question.world = read_world(question.path);
  question.data = data_for(question.world.folder, choice.data);
  question.scene = build_scene(question.world, choice.object);
  return question;
}

}  // namespace

GraspQuestion ask_world(const WorldChoice& choice, const Progress& progress) {
  GraspQuestion question = question_of(choice);
  question.hand = hand_of_world(question.world, choice.hand, question.path, question.data,
                                human_of(choice, progress));
  return question;
}

GraspQuestion ask_stranger(const WorldChoice& choice, const Progress& progress) {
  GraspQuestion question = question_of(choice);
  question.hand.named = hand_by_name(choice.hand, question.data, human_of(choice, progress));
  question.hand.q = open_posture(question.hand.named.hand->layout());
  return question;
}

bool has_hand(const WorldChoice& choice) {
  for (const PlacedHand& hand : read_world(world_file(choice)).hands)
    if (hand.name == choice.hand) return true;
  return false;
}

}  // namespace thenar
