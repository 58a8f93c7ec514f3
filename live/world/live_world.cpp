#include "live/world/live_world.h"

#include <cstdlib>
#include <filesystem>
#include <utility>

#include "api/named/data_folders.h"
#include "base/error.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

/// Returns true if two states have the same shape; poses and postures do not count.
bool looks_alike(const WorldState& a, const WorldState& b) {
  // Compare pointers: copies of a state share what was built.
  if (a.header != b.header || a.hands.size() != b.hands.size() ||
      a.bodies.size() != b.bodies.size())
    return false;
  for (std::size_t i = 0; i < a.hands.size(); ++i)
    if (a.hands[i].built != b.hands[i].built ||
        hand_name(a, a.hands[i]) != hand_name(b, b.hands[i]) ||
        root_name(a, a.hands[i]) != root_name(b, b.hands[i]))
      return false;
  for (std::size_t i = 0; i < a.bodies.size(); ++i)
    if (a.bodies[i].built != b.bodies[i].built) return false;
  return true;
}

LiveBody look_of_body(const BuiltBody& built) {
  LiveBody look;
  look.name = look.owner = built.placed.body.name;
  look.material = built.body.material;
  look.role = built.placed.dynamic ? LiveRole::kObject : LiveRole::kObstacle;
  look.movable = true;
  look.mesh = built.picture;
  look.crease = crease_of(look.material);
  return look;
}

LiveShape shape_of_world(const WorldState& state) {
  LiveShape shape;
  // Add hands first, then bodies: add_contacts() relies on this order.
  for (const StateHand& hand : state.hands)
    add_hand_shape(*hand.built, hand_name(state, hand), root_name(state, hand), shape);
  for (const StateBody& body : state.bodies) shape.bodies.push_back(look_of_body(*body.built));
  if (!object_names(state).empty())
    shape.arrows = {{"worst disturbance: force", LiveArrowKind::kDisturbance},
                    {"worst disturbance: moment", LiveArrowKind::kDisturbance}};
  shape.eye = state.header->camera.eye;
  shape.target = state.header->camera.target;
  return shape;
}

/// Adds contacts to an instant, with the body indices of shape_of_world().
void add_contacts(const WorldState& state, const std::vector<HandObjectContacts>& all,
                  LiveInstant& instant) {
  std::vector<int> first{0};  // first body of each hand, then of the world's bodies
  for (const StateHand& hand : state.hands)
    first.push_back(first.back() + static_cast<int>(hand.built->bodies.size()));
  for (const HandObjectContacts& touches : all)
    for (const HandContact& found : touches.contacts) {
      const Contact seen = transform_contact(state.bodies[touches.body].X_WB, found.contact);
      const Eigen::Vector3d unknown_force(0, 0, 0);
      instant.contacts.push_back({first[touches.hand] + found.surface,
                                  first.back() + static_cast<int>(touches.body), seen.p, -seen.n,
                                  unknown_force, seen.friction});
    }
}

}  // namespace

LiveWorld::LiveWorld(LiveWorldFolders places)
    : folders_(std::move(places)), state_(empty_world("untitled", folders_.folder)) {}

LiveWorld::~LiveWorld() {
  std::error_code ignored;  // a missing folder is not an error
  if (!own_folder_.empty()) fs::remove_all(own_folder_, ignored);
}

LiveInstant LiveWorld::instant() const {
  LiveInstant instant;
  for (const StateHand& hand : state_.hands) add_hand_instant(*hand.built, hand.placement, instant);
  for (const StateBody& body : state_.bodies) instant.bodies.push_back(body.X_WB);
  instant.arrows.resize(shape_.arrows.size());
  if (disturbance_) add_disturbance(instant);
  add_contacts(state_, contact_cache_.contacts(state_, moves_), instant);
  return instant;
}

void LiveWorld::add_disturbance(LiveInstant& instant) const {
  const StateBody& body = state_.bodies[disturbance_->object];
  const Eigen::Vector3d at = body.X_WB * body.built->body.com;
  instant.arrows[0] = {at, body.X_WB.R * disturbance_->wrench.force};
  instant.arrows[1] = {at, body.X_WB.R * disturbance_->wrench.moment};
}

std::vector<std::string> LiveWorld::data_folders() const {
  return data_for(state_.header->folder, folders_.data);
}

void LiveWorld::replace_state(WorldState next, unsigned long id) {
  const bool same = looks_alike(state_, next);
  state_ = std::move(next);
  // Clear the results for the previous state.
  id_ = id;
  ++changes_;
  ++moves_;
  closing_.reset();
  disturbance_.reset();
  // Rebuild the shape only if things were added or removed.
  if (same) return;
  shape_ = shape_of_world(state_);
  ++shape_changes_;
}

void LiveWorld::apply(WorldState next, const std::string& text, const std::string& key) {
  // Merge the edit with the last one if both have the same key, else keep the old state for undo.
  const bool merges = !key.empty() && redo_.empty() && !undo_.empty() && undo_.back().key == key;
  if (!merges) undo_.push_back({text, key, state_, id_});
  if (undo_.size() > kMaxUndoSteps) undo_.pop_front();
  redo_.clear();
  replace_state(std::move(next), ++last_id_);
}

std::string LiveWorld::move_step(std::deque<Step>& from, std::deque<Step>& to) {
  Step step = std::move(from.back());
  from.pop_back();
  // Store the current state without a key, so that no later edit merges with it.
  to.push_back({step.text, "", state_, id_});
  replace_state(std::move(step.state), step.id);
  return step.text;
}

std::string LiveWorld::undo() {
  require(!undo_.empty(), "there is nothing to undo");
  return move_step(undo_, redo_);
}

std::string LiveWorld::redo() {
  require(!redo_.empty(), "there is nothing to redo");
  return move_step(redo_, undo_);
}

LiveEditState LiveWorld::edit_state() const {
  LiveEditState state{state_.header->name, state_.file, id_ != saved_, {}, {}};
  if (!undo_.empty()) state.undo = undo_.back().text;
  if (!redo_.empty()) state.redo = redo_.back().text;
  return state;
}

void LiveWorld::mark_saved(const std::string& file) {
  for (std::deque<Step>* steps : {&undo_, &redo_})
    for (Step& step : *steps)
      if (step.state.header == state_.header) step.state.file = file;
  state_.file = file;
  saved_ = id_;
}

std::shared_ptr<const LiveHand> LiveWorld::find_or_build_hand(const WorldSpec& world,
                                                              std::size_t placed,
                                                              const std::string& path,
                                                              const Progress& progress) {
  const std::vector<std::string> data = data_for(world.folder, folders_.data);
  std::shared_ptr<const LiveHand>& hand = built_[live_hand_key(world, placed, data)];
  if (hand == nullptr || !is_up_to_date(*hand))
    hand = build_live_hand(world, world.hands[placed].name, path, data, progress);
  return hand;
}

const std::string& LiveWorld::own_folder() {
  if (!own_folder_.empty()) return own_folder_;
  std::string name = (fs::temp_directory_path() / "thenar-XXXXXX").string();
  require(mkdtemp(name.data()) != nullptr, "no folder of its own can be made in {}",
          fs::temp_directory_path().string());
  own_folder_ = name;
  fence_.emplace(own_folder_);
  return own_folder_;
}

std::string LiveWorld::path_in_own_folder(const std::string& file) const {
  if (own_folder_.empty() || file.rfind(own_folder_ + "/", 0) != 0) return "";
  return file.substr(own_folder_.size() + 1);
}

void LiveWorld::set_disturbance(const WorstDisturbance& disturbance) {
  disturbance_ = disturbance;
  ++changes_;
}

}  // namespace thenar
