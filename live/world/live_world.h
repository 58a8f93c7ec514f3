#pragma once

/// A world that a person edits by hand: what it holds, what was done to it, and how it looks.

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
#include "live/world/hand_touch.h"
#include "live/world/world_state.h"

namespace thenar {

/// Folders from which a live world reads files, and to which it writes them.
struct LiveWorldPlaces {
  std::string data;          // folder with worlds/, robots/ ..; empty: the usual ones
  std::string folder = ".";  // working folder: files are saved in it or below, new worlds are in it
};

/// Closing that brought the hand to its posture, valid while nothing has moved since.
struct HandClosing {
  std::size_t hand = 0, object = 0;  // of WorldState
  GraspOutcome outcome = GraspOutcome::kEmpty;
  ApproachResult approached;
  ClosedHand closed;
};

/// The disturbance that a grasp resists least, for as long as nothing moved since.
struct WorstDisturbance {
  std::size_t object = 0;  // of WorldState::bodies
  Wrench wrench;           // about its centre of mass, its frame; unit as a scaled wrench
};

/// A world by hand. Edits are values: a new state replaces the one before, which undo() brings
/// back. Nothing is built again because something moved. Not for use by several threads at once.
class LiveWorld final : public LiveModel, public LiveEdits {
 public:
  /// An empty world.
  explicit LiveWorld(LiveWorldPlaces places);
  ~LiveWorld() override;
  LiveWorld(const LiveWorld&) = delete;
  LiveWorld& operator=(const LiveWorld&) = delete;

  [[nodiscard]] const LiveShape& shape() const override { return shape_; }
  /// Contacts are those of hands with objects, as hard points, found once for all instants until
  /// something moves.
  [[nodiscard]] LiveInstant instant() const override;
  [[nodiscard]] unsigned long shape_changes() const override { return shape_changes_; }
  [[nodiscard]] unsigned long changes() const override { return changes_; }

  [[nodiscard]] const LiveWorldPlaces& places() const { return places_; }
  [[nodiscard]] const WorldState& state() const { return state_; }
  /// Folders where hands and objects are found by name.
  [[nodiscard]] std::vector<std::string> data() const;

  /// Makes an edit: `next` is the world from now on.
  /// @param text  what was done, for people: "move mug"
  /// @param key   edits of one key, one right after the other, are undone as one; empty: alone
  void apply(WorldState next, const std::string& text, const std::string& key = "");
  [[nodiscard]] LiveEditState edit_state() const override;
  std::string undo() override;
  std::string redo() override;
  /// Marks the present world as saved in a file; states to undo and redo take over its name.
  void mark_saved(const std::string& file);

  /// Builds a hand unless it was built before, of the same files. @throws as build_live_hand()
  [[nodiscard]] std::shared_ptr<const LiveHand> hand_of(const WorldSpec& world, std::size_t placed,
                                                        const std::string& path,
                                                        const Progress& progress);

  /// Returns the contacts of the hands, and their collision models.
  [[nodiscard]] HandTouch& touch() const { return touch_; }

  /// A folder of this world alone, made when it is first asked for and removed with it. Files in
  /// one of its subfolders name no files elsewhere.
  [[nodiscard]] const std::string& own_folder();
  /// The path of a file as seen from that folder; "" if it is elsewhere.
  [[nodiscard]] std::string in_own_folder(const std::string& file) const;

  // What was found of the present posture; nothing once anything moved.
  [[nodiscard]] const std::optional<HandClosing>& closing() const { return closing_; }
  void set_closing(HandClosing closing) { closing_ = std::move(closing); }
  void set_disturbance(const WorstDisturbance& disturbance);

  static constexpr std::size_t kMostEdits = 200;  // that can be taken back

 private:
  /// A state with the edit that led away from it.
  struct Step {
    std::string text, key;
    WorldState state;
    unsigned long id;
  };
  void show(WorldState next, unsigned long id);
  std::string step(std::deque<Step>& from, std::deque<Step>& to);
  void add_disturbance(LiveInstant& instant) const;

  LiveWorldPlaces places_;
  WorldState state_;
  unsigned long id_ = 0, saved_ = 0, last_id_ = 0;  // of states, each of which has its own
  std::deque<Step> undo_, redo_;
  std::map<std::string, std::shared_ptr<const LiveHand>> built_;  // by live_hand_key()
  std::string own_folder_;
  std::optional<LinkFence> fence_;  // around it
  LiveShape shape_;
  unsigned long shape_changes_ = 0, changes_ = 0;
  unsigned long moves_ = 0;  // of hands and bodies, apart from what is said of them
  std::optional<HandClosing> closing_;
  std::optional<WorstDisturbance> disturbance_;
  mutable HandTouch touch_;  // remembers what instants ask for again and again
};

}  // namespace thenar
