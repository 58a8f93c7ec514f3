#include "grasp/compare/compare_hands.h"

#include <algorithm>
#include <atomic>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/lists.h"
#include "base/parallel_for.h"
#include "base/task_queue.h"
#include "grasp/compare/cell_work.h"
#include "grasp/compare/opposition.h"
#include "grasp/compare/tip_forces.h"
#include "grasp/compare/workspace.h"

namespace thenar {
namespace {

void require_names(const std::vector<std::string>& names, const std::string& what) {
  require(!names.empty(), "there is no {} to compare", what);
  std::set<std::string> seen;
  for (const std::string& name : names)
    require(seen.insert(name).second, "{} '{}' is named twice", what, name);
}

void require_numbers(const CompareOptions& options) {
  require(options.approaches > 0 && options.threads >= 0 && options.best >= 0,
          "a comparison wants approaches, and threads or 0 for all, got {} and {}",
          options.approaches, options.threads);
}

/// Merges equal warnings to lines like "human:skewed, human:soft: assumption".
std::vector<std::string> folded_warnings(const std::vector<ComparedHand>& hands) {
  std::vector<std::pair<std::string, std::string>> whose;  // warning, hands
  for (const ComparedHand& hand : hands)
    for (const std::string& warning : hand.warnings) {
      const auto found = std::find_if(whose.begin(), whose.end(),
                                      [&](const auto& each) { return each.first == warning; });
      if (found == whose.end())
        whose.emplace_back(warning, hand.name);
      else if (found->second != hand.name)
        found->second += ", " + hand.name;
    }
  return transformed(
      whose, [](const auto& each) { return fmt::format("{}: {}", each.second, each.first); });
}

/// Checks hands before the computation, so that errors do not come hours later; messages name the
/// hand.
void require_hands(const std::vector<ComparedHand>& hands, const std::vector<BodySpec>& objects,
                   const Materials& materials) {
  for (const ComparedHand& hand : hands) {
    require(hand.hand != nullptr, "hand '{}' is not there", hand.name);
    require(!hand.hand->surfaces().empty(), "hand '{}' has no surface that could touch", hand.name);
    require(!hand.hand->layout().tip_points.empty(), "hand '{}' has no digits", hand.name);
    // Friction must be known for every pair of materials.
    try {
      for (const LinkSurface& surface : hand.hand->surfaces())
        for (const BodySpec& object : objects)
          (void)materials.between(surface.material, object.material);
    } catch (const InputError& error) {
      throw InputError(fmt::format("hand '{}': {}", hand.name, error.what()));
    }
  }
}

/// Returns a comparison without results.
Comparison heading(const std::vector<ComparedHand>& hands, const std::vector<BodySpec>& objects,
                   const CompareOptions& options) {
  Comparison out;
  out.seed = options.seed;
  out.approaches = options.approaches;
  out.normalise_size = options.normalise_size;
  out.hands = names_of(hands);
  out.warnings = folded_warnings(hands);
  out.objects = names_of(objects);
  out.tasks = transformed(options.tasks, [](GraspTask task) { return name_of(task); });
  require_names(out.hands, "hand");
  require_names(out.objects, "object");
  return out;
}

/// Returns the types of grasp that a hand has made on any object, sorted by name.
std::vector<std::string> grasp_types(const std::vector<HandOnObject>& cells,
                                     const std::string& hand) {
  std::set<std::string> types;
  for (const HandOnObject& cell : cells)
    if (cell.hand == hand)
      for (const auto& [type, times] : cell.types) types.insert(type);
  return {types.begin(), types.end()};
}

}  // namespace

HandAbilities hand_abilities(const ComparedHand& hand, const CompareOptions& options,
                             const Progress& progress) {
  std::mt19937 random(options.seed);
  HandAbilities abilities;
  abilities.hand = hand.name;
  abilities.reach = reach_of_digits(*hand.hand);
  // Workspaces first, as all random numbers come from one generator in a fixed order.
  Workspaces spaces = measure_workspaces(*hand.hand, options.workspace_draws,
                                         options.workspace_voxel, random, progress);
  abilities.overlap = spaces.overlap;
  abilities.digits = std::move(spaces.digits);
  // Tip forces with all joints in the middle of their ranges.
  const HandLayout& layout = hand.hand->layout();
  const Eigen::VectorXd q = (layout.lower + layout.upper) / 2;
  for (std::size_t tip = 0; tip < abilities.digits.size() && !progress.stop(); ++tip) {
    const TipForces forces = tip_forces(*hand.hand, q, static_cast<int>(tip));
    abilities.digits[tip].closing_force = forces.closing;
    abilities.digits[tip].max_tip_force = forces.largest;
  }
  const Opposition opposed = measure_opposition(hand, random, progress);
  abilities.opposition = opposed.score;
  abilities.opposition_scale = opposed.scale;
  abilities.reached = opposed.reached;
  return abilities;
}

namespace {

/// All tasks of a comparison, hand by hand, with its finished results in this order.
class WholeComparison {
 public:
  WholeComparison(Comparison& out, const std::vector<ComparedHand>& hands,
                  const std::vector<BodySpec>& objects, const CompareOptions& options,
                  const Progress& progress, const std::vector<HandOnObject>& done)
      : out_(out), options_(options), progress_(progress), abilities_(hands.size()) {
    quiet_.stop_requested = progress.stop_requested;
    const double first_reach = reach_of_digits(*hands.front().hand);
    for (const ComparedHand& hand : hands) {
      // Scales are relative to the first hand. Abilities come first, as they are one long task.
      const double scale = options.normalise_size ? reach_of_digits(*hand.hand) / first_reach : 1.0;
      lazy_hands_.emplace_back(hand, options.materials);
      const std::size_t number = lazy_hands_.size() - 1;
      queue_.add([this, &hand, number] { find_abilities(hand, abilities_[number]); });
      for (const BodySpec& object : objects) {
        // Cells of an earlier run are reused.
        const HandOnObject* known = find_cell(done, hand.name, object.name);
        cells_.emplace_back(hand.name + " on " + object.name, known);
        if (known != nullptr) continue;
        LazyObject& lazy = lazy_object(object, scale);
        cells_.back().work.emplace(lazy_hands_.back(), lazy, options, progress);
        cells_.back().work->add_to(queue_);
        total_approaches_ += options.approaches;
      }
    }
    objects_ = objects.size();
  }

  /// Runs all tasks; keeps and reports finished results.
  void run() {
    queue_.run(threads_or_all(options_.threads), [&] {
      keep_finished();
      report();
    });
  }

 private:
  struct Cell {
    Cell(std::string what, const HandOnObject* earlier) : name(std::move(what)), known(earlier) {}
    std::string name;           // "barrett on mug"
    const HandOnObject* known;  // result of an earlier run; null: `work`
    std::optional<CellWork> work;
  };
  struct Found {
    HandAbilities abilities;
    std::atomic<bool> done{false};
  };

  LazyObject& lazy_object(const BodySpec& object, double scale) {
    return lazy_objects_
        .try_emplace(std::make_pair(object.name, scale), object, scale, options_.materials)
        .first->second;
  }

  void find_abilities(const ComparedHand& hand, Found& found) {
    if (progress_.stop()) return;
    found.abilities = hand_abilities(hand, options_, quiet_);
    found.done = !progress_.stop();
  }

  /// Appends finished results in the order of hands and objects, up to the first unfinished one.
  void keep_finished() {
    while (next_ < cells_.size() + abilities_.size()) {
      const std::size_t hand = next_ / (objects_ + 1), object = next_ % (objects_ + 1);
      if (object == objects_) {
        if (!abilities_[hand].done) return;
        out_.abilities.push_back(std::move(abilities_[hand].abilities));
        out_.abilities.back().types = grasp_types(out_.cells, out_.abilities.back().hand);
      } else {
        Cell& cell = cells_[hand * objects_ + object];
        if (cell.work && !cell.work->done()) return;
        out_.cells.push_back(cell.known != nullptr ? *cell.known : cell.work->take_result());
        if (options_.keep) options_.keep(out_);
      }
      ++next_;
    }
    out_.complete = true;
  }

  /// Reports the share of finished approaches, and the first unfinished cell.
  void report() const {
    if (out_.complete) {
      progress_(1, "compared");
      return;
    }
    int tried = 0;
    const Cell* first = nullptr;
    for (const Cell& cell : cells_) {
      if (!cell.work) continue;
      tried += cell.work->tried();
      if (first == nullptr && !cell.work->done()) first = &cell;
    }
    progress_(static_cast<double>(tried) / std::max(1, total_approaches_),
              first == nullptr ? "" : first->name);
  }

  Comparison& out_;
  const CompareOptions& options_;
  const Progress& progress_;
  Progress quiet_;  // checks for stops, and reports nothing
  std::deque<LazyCollisionHand> lazy_hands_;
  std::map<std::pair<std::string, double>, LazyObject> lazy_objects_;
  std::vector<Found> abilities_;  // by hand
  std::deque<Cell> cells_;        // hand by hand
  std::size_t objects_ = 0, next_ = 0;
  int total_approaches_ = 0;
  TaskQueue queue_;
};

}  // namespace

Comparison compare(const std::vector<ComparedHand>& hands, const std::vector<BodySpec>& objects,
                   const CompareOptions& options, const Progress& progress,
                   const std::vector<HandOnObject>& done) {
  require_numbers(options);
  Comparison out = heading(hands, objects, options);
  require_hands(hands, objects, options.materials);
  WholeComparison(out, hands, objects, options, progress, done).run();
  return out;
}

}  // namespace thenar
