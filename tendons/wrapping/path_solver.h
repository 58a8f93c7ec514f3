#pragma once

/// Solver for the paths and lengths of wrapped tendons at a posture.

#include <vector>

#include <Eigen/Core>

#include "hand/chain.h"
#include "tendons/wrapping/path_tangency.h"
#include "tendons/wrapping/wrapped_path.h"

namespace thenar {

/// Outcome of a path solution.
enum class PathStatus {
  kTaut,         // tangent everywhere to 1e-11 rad
  kRidesOnBend,  // the origin lies where its carrier bends: arms leave out its sliding across the
                 // carrier
  kPointInside,  // a point has moved into an adjacent surface: see `depth`
  kFarSideWrap,  // a point has crossed the half plane of an adjacent cylinder opposite to the
                 // path's side, where the length jumps
  kStalled       // Newton's method did not converge, or a run passes through bone: see `error`
};

/// Value of PathSpan::link_b for an origin that rides on another tendon.
inline constexpr int kRiding = -2;

/// Run length below which rounding of its ends may decide its direction [m].
inline constexpr double kShortRun = 1e-7;

/// Straight run of a tendon, from insertion to origin, world frame.
struct PathSpan {
  int link_a, link_b;    // links of its ends; -1: the base; kRiding
  Eigen::Vector3d a, b;  // ends [m] (3)
  double length;         // [m]
  Eigen::Vector3d u;  // unit direction from a to b; for a run too short to have one, the tangent of
                      // the adjacent arc; zero without an adjacent arc (3)
};

/// Arc of a tendon on a surface.
struct PathArc {
  int surface;  // index in PathSet::surfaces
  int after;    // index of the span before it
  WrapArc arc;  // start, direction and length, frame S
};

/// Path of one tendon at one posture.
struct [[nodiscard]] PathShape {
  PathStatus status = PathStatus::kTaut;  // read this first
  double error = 0;    // largest kink; 1: bone in the way. Includes the carrier's [rad]
  double depth = 0;    // depth of the deepest point inside a surface. Includes the carrier's [m]
  int iterations = 0;  // Newton steps; 0: solved in closed form
  double length = 0;   // total length [m]
  std::vector<PathSpan> spans;
  std::vector<PathArc> arcs;
  int ride_span = -1;  // span of the carrier on which the origin lies; -1: the origin does not ride
};

/// Solver for the paths of one set of tendons at many postures. It owns a workspace, which does not
/// affect results: use one object per thread. After the first posture it allocates no memory.
class PathSolver {
 public:
  /// Prepares the solver. @param set  must outlive the solver
  explicit PathSolver(const PathSet& set);
  explicit PathSolver(PathSet&& set) = delete;

  /// Solves all paths at the pose of their links.
  /// @return one shape per path, in the order of the set; overwritten by the next call
  const std::vector<PathShape>& solve(const TreeState<double>& state);

  /// Solves the paths without the runs between points of one link, which have no moment arm; paths
  /// that carry or ride keep these runs. Lengths and all other results equal those of solve().
  const std::vector<PathShape>& solve_for_arms(const TreeState<double>& state);

  [[nodiscard]] const PathSet& set() const { return *set_; }

 private:
  struct FarSide {  // test of one point against the far side of an adjacent cylinder
    bool at_b;      // true: the point is the run's second end
    int surface;
    Eigen::Vector2d reference, side;  // directions across the axis at the reference posture (2)
  };
  struct PathEnds {  // run between two points
    int link_a, link_b;
    Eigen::Vector3d a, b;
    double length;                    // length of a rigid run; negative: it changes [m]
    const std::vector<FarSide>* far;  // far-side tests of the run
  };
  struct Slot {  // surface of the current run
    bool on = false;
    double error = 0;  // largest kink [rad]
    ChainArc link;
    Eigen::Vector3d touch_a, touch_b;  // world [m] (3)
  };
  const std::vector<PathShape>& solve(const TreeState<double>& state, bool all);
  void solve_path(std::size_t k, const TreeState<double>& state, bool all);
  void place_riding_origin(std::size_t k, const TreeState<double>& state, PathEnds& last,
                           PathShape& shape) const;
  [[nodiscard]] bool has_crossed(const PathEnds& ends) const;
  void add_run(const std::vector<PathWrap>& bends, const PathEnds& ends, PathShape& shape);
  bool add_round_run(const PathWrap& bend, const PathEnds& ends, PathShape& shape);
  void tighten_run(const std::vector<PathWrap>& bends, const Eigen::Vector3d& a,
                   const Eigen::Vector3d& b, PathShape& shape);
  void sweep_surfaces(const std::vector<PathWrap>& bends, const Eigen::Vector3d& a,
                      const Eigen::Vector3d& b, PathShape& shape);
  double update_wrap(std::size_t i, const PathWrap& bend, const Eigen::Vector3d& a,
                     const Eigen::Vector3d& b, PathShape& shape);
  void wrap_surface(std::size_t i, const PathWrap& bend, const Eigen::Vector3d& a,
                    const Eigen::Vector3d& b, PathShape& shape);
  double solve_contacts(const Eigen::Vector3d& a, const Eigen::Vector3d& b, PathShape& shape);
  double solve_clear_contacts(const std::vector<PathWrap>& bends, const Eigen::Vector3d& a,
                              const Eigen::Vector3d& b, PathShape& shape);
  [[nodiscard]] bool runs_clear(const std::vector<PathWrap>& bends, const Eigen::Vector3d& a,
                                const Eigen::Vector3d& b) const;
  void start_chain_at_sides(const std::vector<PathWrap>& bends);
  void load_slots(const std::vector<PathWrap>& bends);
  static void update_touch_points(Slot& slot);
  void set_directions(PathShape& shape) const;

  const PathSet* set_;
  std::vector<Pose<double>> X_;             // X_WS of each surface
  std::vector<std::vector<double>> rigid_;  // length of each run of each path; negative: it changes
  std::vector<std::vector<std::vector<FarSide>>> far_;  // far-side tests of each run of each path
  std::vector<bool> carries_;                           // true: another path rides on it (paths)
  bool crossed_ = false;  // true: a point of the current path is on a far side
  std::vector<PathShape> shapes_;
  std::vector<Slot> slots_;
  std::vector<ChainArc> chain_;       // surfaces in contact
  std::vector<ChainArc> bead_chain_;  // arcs found by the beads
  std::vector<ChainArc> single_;      // chain of one surface
};

/// Samples points along a tendon for drawing, at most `spacing` [m] apart on arcs, world (3,
/// points).
[[nodiscard]] Eigen::Matrix3Xd path_points(const PathSet& set, const TreeState<double>& state,
                                           const PathShape& shape, double spacing);

}  // namespace thenar
