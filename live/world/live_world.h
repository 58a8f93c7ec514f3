#pragma once

/// World that is edited interactively: its state, the history of its edits, and its picture.

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/outside_path.h"
#include "grasp/closing/close_hand.h"
#include "grasp/contact/wrench_set.h"
#include "live/live_abilities.h"
#include "live/live_picture.h"
#include "live/world/hand_contact_cache.h"
#include "live/world/world_state.h"

namespace thenar {

/// Folders from which a live world reads files, and to which it writes them.
struct LiveWorldFolders {
  std::string data;          // folder with worlds/, robots/ ..; empty: the default ones
  std::string folder = ".";  // working folder: saved files and new worlds are in it or below
};

/// Closing that brought a hand to its posture; valid until something moves.
struct HandClosing {
  std::size_t hand = 0, object = 0;  // entries of WorldState::hands and ::bodies
  GraspOutcome outcome = GraspOutcome::kEmpty;
  ApproachResult approached;
  ClosedHand closed;
};

/// Disturbance that a grasp resists least; valid until something moves.
struct WorstDisturbance {
  std::size_t object = 0;  // entry of WorldState::bodies
  Wrench wrench;  // wrench about the object's centre of mass, object frame; unit as a scaled wrench
};

/// Interactive world. An edit replaces the whole WorldState, and undo() restores the previous one.
/// Moving a hand or a body rebuilds nothing. Not thread-safe.
class LiveWorld final : public LiveModel, public LiveEdits {
 public:
  /// Creates an empty world.
  explicit LiveWorld(LiveWorldFolders places);
  ~LiveWorld() override;
  LiveWorld(const LiveWorld&) = delete;
  LiveWorld& operator=(const LiveWorld&) = delete;

  [[nodiscard]] const LiveShape& shape() const override { return shape_; }
  /// Returns the moving parts of the picture. Contacts are the hard point contacts of hands with
  /// objects, computed once until something moves.
  [[nodiscard]] LiveInstant instant() const override;
  [[nodiscard]] unsigned long shape_changes() const override { return shape_changes_; }
  [[nodiscard]] unsigned long changes() const override { return changes_; }

  [[nodiscard]] const LiveWorldFolders& folders() const { return folders_; }
  [[nodiscard]] const WorldState& state() const { return state_; }
  /// Returns the folders in which hands and objects are found by name.
  [[nodiscard]] std::vector<std::string> data_folders() const;

  /// Applies an edit: replaces the state by `next`.
  /// @param text  description of the edit for users: "move mug"
  /// @param key   consecutive edits with the same key are undone as one; empty: a single edit
  void apply(WorldState next, const std::string& text, const std::string& key = "");
  [[nodiscard]] LiveEditState edit_state() const override;
  std::string undo() override;
  std::string redo() override;
  /// Marks the current state as saved in a file; the states of undo and redo get that file, too.
  void mark_saved(const std::string& file);

  /// Returns a hand of a world; builds it unless it was built before from the same files.
  /// @param placed  entry of WorldSpec::hands  @throws as build_live_hand()
  [[nodiscard]] std::shared_ptr<const LiveHand> find_or_build_hand(const WorldSpec& world,
                                                                   std::size_t placed,
                                                                   const std::string& path,
                                                                   const Progress& progress);

  /// Returns the cache of contacts and collision models.
  [[nodiscard]] HandContactCache& contact_cache() const { return contact_cache_; }

  /// Returns a temporary folder of this world, created on first use and removed with the world.
  /// Files in one of its subfolders cannot refer to files outside that subfolder.
  [[nodiscard]] const std::string& own_folder();
  /// Returns the path of a file relative to own_folder(); "" if it is outside.
  [[nodiscard]] std::string path_in_own_folder(const std::string& file) const;

  // Results for the current state; cleared when something moves.
  [[nodiscard]] const std::optional<HandClosing>& closing() const { return closing_; }
  void set_closing(HandClosing closing) { closing_ = std::move(closing); }
  void set_disturbance(const WorstDisturbance& disturbance);

  static constexpr std::size_t kMaxUndoSteps = 200;  // largest number of edits that undo() keeps

 private:
  /// State before an edit, and the edit.
  struct Step {
    std::string text, key;
    WorldState state;
    unsigned long id;
  };
  void replace_state(WorldState next, unsigned long id);
  std::string move_step(std::deque<Step>& from, std::deque<Step>& to);
  void add_disturbance(LiveInstant& instant) const;

  LiveWorldFolders folders_;
  WorldState state_;
  unsigned long id_ = 0, saved_ = 0, last_id_ = 0;  // ids of the current, saved and newest state
  std::deque<Step> undo_, redo_;
  std::map<std::string, std::shared_ptr<const LiveHand>> built_;  // hands by live_hand_key()
  std::string own_folder_;
  std::optional<LinkFence> fence_;  // confines references of files in own_folder_ to its subfolders
  LiveShape shape_;
  unsigned long shape_changes_ = 0, changes_ = 0;
  unsigned long moves_ = 0;  // number of times that state_ was replaced
  std::optional<HandClosing> closing_;
  std::optional<WorstDisturbance> disturbance_;
  mutable HandContactCache contact_cache_;
};

}  // namespace thenar
