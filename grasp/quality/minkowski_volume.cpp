#include "grasp/quality/minkowski_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <vector>

#include <Eigen/Dense>

#include "base/lists.h"
#include "base/numbers.h"
#include "grasp/quality/contact_body.h"

namespace thenar::internal {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Form = std::array<double, 64>;  // exterior product of vectors, indexed by the set of axes

constexpr int kAllAxes = 63;  // bit set of all six axes
// Determinant over its columns' lengths below which it counts as 0 [1]
constexpr double kZeroDeterminant = 1e-14;
constexpr double kPerturbations[] = {0, 1e-9,
                                     1e-7};  // rotations of contacts until in general position [1]
constexpr double kTurnedArea = 100;  // facets below this times the turn times their vectors'
                                     // lengths are neglected [1]
// Sum of normals over the area up to which a surface counts as closed [1]
constexpr double kMaxOpenRatio = 1e-7;

int members(int axes) { return __builtin_popcount(static_cast<unsigned>(axes)); }

/// Sign of (axes) ^ axis when sorted in ascending order.
double sign(int axes, int axis) { return members(axes >> (axis + 1)) % 2 == 0 ? 1 : -1; }

/// out[axes | axis] += sign in[axes] v[axis].
struct Term {
  std::size_t in, out;
  int axis;
  double sign;
};

std::vector<Term> terms(int degree) {
  std::vector<Term> list;
  for (int axes = 0; axes < kAllAxes; ++axes)
    for (int axis = 0; axis < 6 && members(axes) == degree; ++axis)
      if ((axes & 1 << axis) == 0)
        list.push_back({static_cast<std::size_t>(axes), static_cast<std::size_t>(axes | 1 << axis),
                        axis, sign(axes, axis)});
  return list;
}

/// Exterior product f ^ v, f of `degree` vectors.
Form wedge(const Form& f, int degree, const WrenchCoordinates& v) {
  static const std::array<std::vector<Term>, 5> all{terms(0), terms(1), terms(2), terms(3),
                                                    terms(4)};
  Form out{};
  for (const Term& term : all[degree]) out[term.out] += term.sign * f[term.in] * v[term.axis];
  return out;
}

/// Normal u of five vectors: det(.., x) = u'x.
WrenchCoordinates normal(const Form& five) {
  WrenchCoordinates u;
  for (int axis = 0; axis < 6; ++axis) {
    const int others = kAllAxes ^ 1 << axis;
    u[axis] = sign(others, axis) * five[others];
  }
  return u;
}

/// Matrix S of four vectors: S e is the normal of these and e.
Matrix6 normals(const Form& four) {
  static const std::vector<Term> all = terms(4);
  Matrix6 S = Matrix6::Zero();
  // Each product of five axes gives the component along the sixth.
  for (const Term& term : all) {
    const int others = static_cast<int>(term.out);
    const int axis = members((kAllAxes ^ others) - 1);
    S(axis, term.axis) += sign(others, axis) * term.sign * four[term.in];
  }
  return S;
}

/// Product of a form of `count` vectors and the vectors along a face.
Form wedge(Form f, int count, const ContactFace& face) {
  for (int i = 0; i < face.dimension; ++i) f = wedge(f, count + i, face.span[i]);
  return f;
}

/// Product of a number and the lengths of the vectors along a face.
double times_lengths(double lengths, const ContactFace& face) {
  for (int i = 0; i < face.dimension; ++i) lengths *= face.span[i].norm();
  return lengths;
}

/// Computation of the volume of a Minkowski sum from its facets, by all combinations of faces.
class Sum {
 public:
  /// @param no_area  uncertain facets below this share of their vectors' lengths are neglected [1]
  Sum(const std::vector<ContactBody>& bodies, double no_area, const Progress& progress)
      : bodies_(bodies), no_area_(no_area), progress_(progress) {}

  /// @return nothing if facets do not form a closed surface, ties leave them uncertain, or after a
  ///         stop
  std::optional<double> volume() {
    Form one{};
    one[0] = 1;
    choose(0, 5, one, 1, 1);
    // The normals of a closed surface sum up to zero.
    if (tie_ || stopped_ || !(surplus_.norm() <= kMaxOpenRatio * surface_)) return {};
    return volume_ / 6;
  }

 private:
  /// Adds faces of contacts from number `first` on, of `left` dimensions together.
  /// @param f        product of the vectors along the faces chosen so far
  /// @param size     product of their sizes
  /// @param lengths  product of their vectors' lengths
  // NOLINTNEXTLINE(misc-no-recursion): depth five, one for each dimension
  void choose(std::size_t first, int left, const Form& f, double size, double lengths) {
    // With one dimension left the normal is linear in the last edge.
    const Matrix6 S = left == 1 ? normals(f) : Matrix6();
    stopped_ = stopped_ || progress_.stop();
    for (std::size_t c = first; c < bodies_.size() && !tie_ && !stopped_; ++c)
      for (const ContactFace& face : bodies_[c].faces) {
        if (face.dimension > left) continue;
        // A face either completes five dimensions or is followed by faces of later contacts.
        chosen_.push_back({c, &face});
        const double longer = times_lengths(lengths, face);
        if (left == 1) {
          finish(S * face.span[0], size * face.size, longer);
        } else {
          const Form more = wedge(f, 5 - left, face);
          if (face.dimension == left)
            finish(normal(more), size * face.size, longer);
          else
            choose(c + 1, left - face.dimension, more, size * face.size, longer);
        }
        chosen_.pop_back();
      }
  }

  /// Adds the facet with this normal if it is one.
  void finish(const WrenchCoordinates& u, double size, double lengths) {
    double way = 0;  // 1: u is an outer normal; -1: -u is
    bool uncertain = false;
    // Outer normals have all neighbouring faces of each chosen face behind them.
    for (auto chosen = chosen_.rbegin(); chosen != chosen_.rend(); ++chosen)
      for (int i = 0; i < chosen->face->inward_count; ++i) {
        const WrenchCoordinates& inward = chosen->face->inward[i];
        const double t = -u.dot(inward);
        if (std::abs(t) < kZeroDeterminant * lengths * inward.norm()) {
          uncertain = true;
          continue;
        }
        if (t * way < 0) return;
        way = t > 0 ? 1 : -1;
      }
    // Degenerate normals: a tie counts, and an edge-on facet has both sides.
    if (uncertain) return tie(u, lengths);
    if (way >= 0) add(u, size, lengths);
    if (way <= 0) add(-u, size, lengths);
  }

  /// Records that it is uncertain if this is a facet, which matters only if it is large.
  void tie(const WrenchCoordinates& u, double lengths) {
    tie_ = tie_ || u.norm() > no_area_ * lengths;
  }

  void add(const WrenchCoordinates& u, double size, double lengths) {
    double h = 0;
    std::size_t next = 0;
    // Support of each contact; a second vertex as far out as the best is a tie.
    for (std::size_t c = 0; c < bodies_.size(); ++c) {
      const bool is_chosen = next < chosen_.size() && chosen_[next].contact == c;
      if (is_chosen) ++next;
      double best = -kInfinity, second = -kInfinity;
      for (const WrenchCoordinates& point : bodies_[c].points) {
        const double reach = u.dot(point);
        second = std::max(second, std::min(best, reach));
        best = std::max(best, reach);
      }
      if (!is_chosen && best - second < kZeroDeterminant * lengths * longest_[c]) tie(u, lengths);
      h += best;
    }
    // Divergence theorem: volume and closure of the surface.
    volume_ += size * h;
    surplus_ += size * u;
    surface_ += size * u.norm();
  }

  struct Chosen {
    std::size_t contact;
    const ContactFace* face;
  };

  const std::vector<ContactBody>& bodies_;
  double no_area_;
  const Progress& progress_;
  std::vector<double> longest_ = transformed(bodies_, longest_of);
  std::vector<Chosen> chosen_;
  bool tie_ = false, stopped_ = false;
  double volume_ = 0, surface_ = 0;
  WrenchCoordinates surplus_ = WrenchCoordinates::Zero();

  static double longest_of(const ContactBody& body) {
    double longest = 0;
    for (const WrenchCoordinates& point : body.points) longest = std::max(longest, point.norm());
    return longest;
  }
};

/// Counts the combinations of faces with five dimensions in total.
double choices(const std::vector<ContactBody>& bodies) {
  // Count by dimension, contact by contact.
  std::array<double, 6> ways{1};
  for (const ContactBody& body : bodies) {
    std::array<double, 6> more = ways;
    for (const ContactFace& face : body.faces)
      for (auto d = static_cast<std::size_t>(face.dimension); d < 6; ++d)
        more[d] += ways[d - static_cast<std::size_t>(face.dimension)];
    ways = more;
  }
  return ways[5];
}

/// Rotates each contact at random by about `by`, so that their faces are in general position.
std::vector<ContactBody> turned(std::vector<ContactBody> bodies, double by) {
  std::mt19937 rng(1);
  for (ContactBody& body : bodies) {
    Matrix6 R = Matrix6::Identity();
    for (double& entry : R.reshaped())
      entry += by * (2.0 * static_cast<double>(rng()) / 4294967296.0 - 1);
    for (WrenchCoordinates& point : body.points) point = R * point;
    for (ContactFace& face : body.faces) {
      for (WrenchCoordinates& along : face.span) along = R * along;
      for (WrenchCoordinates& along : face.inward) along = R * along;
    }
  }
  return bodies;
}

/// Groups the points of each contact; caps with one number share a contact.
std::vector<std::vector<WrenchCoordinates>> grouped(const WrenchSet& set) {
  std::map<int, std::vector<WrenchCoordinates>> shared;
  std::vector<std::vector<WrenchCoordinates>> groups;
  for (const WrenchCap& cap : set.caps) {
    if (cap.contact >= 0)
      shared[cap.contact].push_back(cap.c.vector());
    else
      groups.push_back({cap.c.vector()});
  }
  for (auto& [contact, points] : shared) groups.push_back(std::move(points));
  return groups;
}

}  // namespace

std::optional<double> minkowski_volume(const WrenchSet& set, double max_choices,
                                       const Progress& progress) {
  // Faces of each contact, if it spans three dimensions at most.
  std::vector<ContactBody> bodies;
  for (const std::vector<WrenchCoordinates>& points : grouped(set)) {
    std::optional<ContactBody> body = contact_body(points);
    if (!body) return {};
    bodies.push_back(std::move(*body));
  }
  if (choices(bodies) > max_choices) return {};
  // Increase the perturbation until no ties are left.
  for (const double by : kPerturbations)
    if (const auto found = Sum(turned(bodies, by), kTurnedArea * by, progress).volume())
      return found;
  return {};
}

}  // namespace thenar::internal
