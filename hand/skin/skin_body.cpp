#include "hand/skin/skin_body.h"

#include <algorithm>

#include "hand/skeleton.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

constexpr double kJointAspect = 1.08, kTipAspect = 1.22;  // breadth over depth, assumptions [1]

/// Returns a point beside a bone, in units of its length and mean radius.
Vector3d beside(const DigitBone& bone, double along, double dorsal, double radial = 0) {
  return bone.proximal + along * (bone.distal - bone.proximal) +
         bone.radius * (dorsal * bone.dorsal + radial * bone.radial);
}

Lump capsule(const Vector3d& a, const Vector3d& b, double ra, double rb, double blend) {
  Lump lump;
  lump.core = {a, b, b};
  lump.radius = {ra, rb};
  lump.blend = blend;
  return lump;
}

Lump flattened(Lump lump, const Vector3d& dorsal, double aspect) {
  // Make the direction of flattening normal to the capsule.
  const Vector3d along = lump.core[1] - lump.core[0];
  const Vector3d across = dorsal - dorsal.dot(along) / std::max(along.squaredNorm(), 1e-12) * along;
  lump.flat = across.normalized();
  lump.aspect = aspect;
  return lump;
}

Lump sheet(const Vector3d& a, const Vector3d& b, const Vector3d& c, double radius, double blend) {
  Lump lump;
  lump.core = {a, b, c};
  lump.radius = {radius, radius};
  lump.sheet = true;
  lump.blend = blend;
  return lump;
}

/// Returns the radius at the joint proximal of bone i: the mean of those of its bones.
double joint_radius(const DigitAnatomy& digit, int i) {
  if (i == 0) return digit.bones[0].radius;
  return (digit.bones[i - 1].radius + digit.bones[i].radius) / 2;
}

/// Builds a phalanx between two joints, with the pulp on its palmar side.
ImplicitBody phalanx(const DigitAnatomy& digit, int i) {
  const DigitBone& bone = digit.bones[i];
  const double r = bone.radius, from = joint_radius(digit, i), to = joint_radius(digit, i + 1);
  // Add the bone's flesh, then the pulp.
  ImplicitBody body{
      flattened(capsule(bone.proximal, bone.distal, from, to, 0), bone.dorsal, kJointAspect)};
  body.push_back(
      capsule(beside(bone, 0.35, -0.22), beside(bone, 0.65, -0.22), 0.86 * r, 0.86 * r, 0.5 * r));
  return body;
}

/// Builds the last phalanx: tapered to the tip, with a bulge at the pad, flatter under the nail.
ImplicitBody fingertip(const DigitAnatomy& digit) {
  const int i = static_cast<int>(digit.bones.size()) - 1;
  const DigitBone& bone = digit.bones[i];
  // Choose the capsule so that its cap ends at the tip.
  const double r = bone.radius, length = (bone.distal - bone.proximal).norm(), end = 0.66 * r;
  const double wide = std::sqrt(kTipAspect);
  const double last = 1 - wide * end / length;
  ImplicitBody body{
      flattened(capsule(bone.proximal, beside(bone, last, -0.1), joint_radius(digit, i), end, 0),
                bone.dorsal, kTipAspect)};
  // Add the bulge of the pad.
  const double middle = 1 - 1.15 * r / length;
  body.push_back(flattened(capsule(beside(bone, middle - 0.12, -0.22), beside(bone, middle, -0.26),
                                   0.8 * r, 0.76 * r, 0),
                           bone.dorsal, 1.1));
  body.back().blend = 0.6 * r;
  return body;
}

/// Corners of the web between thumb and index: the root, and the ends of the free edge.
struct ThumbWeb {
  Vector3d root, thumb, index;
};

ThumbWeb thumb_web(const HandAnatomy& hand, const DigitAnatomy& thumb) {
  // Span the web from the thumb's root to the index knuckle.
  const DigitBone& bone = thumb.bones.front();
  const DigitAnatomy* index = digit_named(hand, "index");
  const Vector3d knuckle = index != nullptr ? index->bones.front().proximal : bone.distal;
  return {bone.proximal, beside(bone, 1.0, -0.2), bone.proximal + 0.95 * (knuckle - bone.proximal)};
}

/// Builds the first metacarpal with its part of the thenar muscles and of the web.
ImplicitBody thumb_metacarpal(const HandAnatomy& hand, const DigitAnatomy& thumb) {
  const DigitBone& bone = thumb.bones.front();
  const double r = bone.radius;
  // Add the bone, then the thenar bulge.
  ImplicitBody body{capsule(bone.proximal, bone.distal, 0.95 * r, joint_radius(thumb, 1), 0)};
  body.push_back(capsule(beside(bone, 0.22, -0.5), beside(bone, 0.75, -0.35), 0.9 * r, 0.8 * r, r));
  // Add half of the web, with a concave free edge.
  if (hand.palm) {
    const ThumbWeb web = thumb_web(hand, thumb);
    const Vector3d edge = web.thumb + 0.65 * (web.index - web.thumb);
    const Vector3d sag = edge + 0.12 * (web.root - edge);
    body.push_back(sheet(web.root, web.thumb, sag, 0.45 * r, 1.2 * r));
  }
  return body;
}

/// Builder of the palm in units of its own measures.
class PalmBuilder {
 public:
  explicit PalmBuilder(const HandAnatomy& hand) : hand_(hand), palm_(*hand.palm) {
    for (const char* name : {"index", "middle", "ring", "little"})
      if (const DigitAnatomy* digit = digit_named(hand, name))
        if (digit->root == palm_.segment) fingers_.push_back(digit);
    half_ = palm_.thickness / 2;
    const Vector3d mean =
        (fingers_.front()->bones[0].proximal + fingers_.back()->bones[0].proximal) / 2;
    length_ = (mean - palm_.wrist).dot(palm_.distal);
  }

  /// Builds the palm.
  ImplicitBody make() {
    // Add the lumps in this order: each blends with those before it.
    metacarpals();
    carpus();
    pads();
    webs();
    if (const DigitAnatomy* thumb = digit_named(hand_, "thumb"))
      if (thumb->root == palm_.segment) thenar(*thumb);
    return body_;
  }

 private:
  /// Returns a point of the palm in units of breadth, length and half thickness, from the wrist.
  [[nodiscard]] Vector3d at(double radial, double distal, double dorsal) const {
    return palm_.wrist + radial * palm_.breadth * palm_.radial + distal * length_ * palm_.distal +
           dorsal * half_ * palm_.dorsal;
  }
  /// Returns the radius of a metacarpal head.
  [[nodiscard]] double head_radius(int i) const {
    return std::min(0.88 * half_, 1.08 * fingers_[i]->bones[0].radius);
  }
  /// Returns the head of a metacarpal.
  [[nodiscard]] Vector3d head(int i) const { return fingers_[i]->bones[0].proximal; }

  /// Adds the metacarpals.
  void metacarpals() {
    const int n = static_cast<int>(fingers_.size());
    for (int i = 0; i < n; ++i)
      body_.push_back(capsule(base(i), head(i), 0.82 * half_, head_radius(i), 0.8 * half_));
    // Fill the gaps between them by interossei.
    for (int i = 0; i + 1 < n; ++i) {
      const double thick = 0.8 * std::min(head_radius(i), head_radius(i + 1));
      body_.push_back(sheet(base(i), head(i), head(i + 1), thick, 0.35 * half_));
      body_.push_back(sheet(base(i), head(i + 1), base(i + 1), thick, 0.35 * half_));
    }
  }

  /// Returns the base of a metacarpal, at the carpus.
  [[nodiscard]] Vector3d base(int i) const {
    return at(0.20 - 0.40 * i / (static_cast<double>(fingers_.size()) - 1), 0.12, 0);
  }

  /// Adds the carpus between the metacarpals and the forearm.
  void carpus() {
    Lump lump = capsule(at(0.18, 0.02, 0), at(-0.18, 0.02, 0), 0.8 * half_, 0.78 * half_, half_);
    body_.push_back(lump);
  }

  /// Adds the hypothenar eminence and the cushions in front of the knuckles.
  void pads() {
    const int last = static_cast<int>(fingers_.size()) - 1;
    // Add the hypothenar eminence, then cushions between the knuckles.
    body_.push_back(capsule(at(-0.25, 0.22, -0.4),
                            head(last) - 0.25 * length_ * palm_.distal - 0.3 * half_ * palm_.dorsal,
                            0.78 * half_, 0.55 * half_, 0.8 * half_));
    for (int i = 0; i < last; ++i) {
      const Vector3d down = -0.32 * half_ * palm_.dorsal - 0.03 * length_ * palm_.distal;
      body_.push_back(
          capsule(head(i) + down, head(i + 1) + down, 0.55 * half_, 0.5 * half_, 0.6 * half_));
    }
  }

  /// Adds the skin between the roots of the fingers, up to a quarter of the first phalanges.
  void webs() {
    for (int i = 0; i + 1 < static_cast<int>(fingers_.size()); ++i) {
      const DigitBone &a = fingers_[i]->bones[0], &b = fingers_[i + 1]->bones[0];
      body_.push_back(sheet((head(i) + head(i + 1)) / 2, beside(a, 0.24, -0.2),
                            beside(b, 0.24, -0.2), 0.45 * std::min(a.radius, b.radius),
                            0.5 * half_));
    }
  }

  /// Adds the muscles at the root of the thumb, and the palm's part of its web.
  void thenar(const DigitAnatomy& thumb) {
    const DigitBone& bone = thumb.bones.front();
    const Vector3d down = -0.5 * half_ * palm_.dorsal;
    // Add the thenar muscles.
    body_.push_back(capsule(at(0.16, 0.12, -0.35), beside(bone, 0.3, -0.3) + down, 0.75 * half_,
                            0.75 * half_, half_));
    body_.push_back(capsule(at(0.16, 0.12, -0.1), beside(bone, 0.15, 0), 0.8 * half_,
                            0.9 * bone.radius, half_));
    // Add the palm's half of the web.
    const ThumbWeb web = thumb_web(hand_, thumb);
    const Vector3d edge = web.index + 0.65 * (web.thumb - web.index);
    const Vector3d sag = edge + 0.12 * (web.root - edge);
    body_.push_back(sheet(web.root, web.index, sag, 0.42 * bone.radius, half_));
  }

  const HandAnatomy& hand_;
  const PalmAnatomy& palm_;
  std::vector<const DigitAnatomy*> fingers_;
  double half_ = 0, length_ = 0;  // half thickness; wrist to knuckles [m]
  ImplicitBody body_;
};

}  // namespace

std::map<std::string, ImplicitBody> skin_bodies(const HandAnatomy& hand) {
  std::map<std::string, ImplicitBody> bodies;
  for (const DigitAnatomy& digit : hand.digits) {
    // Build the phalanges, then the fingertip.
    const int last = static_cast<int>(digit.bones.size()) - 1;
    for (int i = 0; i < last; ++i)
      bodies[digit.bones[i].segment] =
          digit.name == "thumb" && i == 0 ? thumb_metacarpal(hand, digit) : phalanx(digit, i);
    bodies[digit.bones[last].segment] = fingertip(digit);
  }
  if (hand.palm) bodies[hand.palm->segment] = PalmBuilder(hand).make();
  return bodies;
}

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Border between two bodies at a joint: the plane through its centre, facing the outer one.
struct Border {
  const ImplicitBody* other;
  Vector3d center, outward;  // outward from the body that owns the border
};

/// Appends the border between two segments to both.
void add_border(const std::map<std::string, ImplicitBody>& bodies, const std::string& inner,
                const std::string& outer, const Vector3d& center, const Vector3d& outward,
                std::map<std::string, std::vector<Border>>& borders) {
  if (bodies.count(inner) == 0 || bodies.count(outer) == 0) return;
  borders[inner].push_back({&bodies.at(outer), center, outward});
  borders[outer].push_back({&bodies.at(inner), center, -outward});
}

/// Builds the borders between neighbouring segments.
std::map<std::string, std::vector<Border>> borders_of(
    const HandAnatomy& hand, const std::map<std::string, ImplicitBody>& bodies) {
  std::map<std::string, std::vector<Border>> borders;
  for (const DigitAnatomy& digit : hand.digits) {
    // Add planes that bisect the bend at each joint.
    std::string inner = digit.root;
    Vector3d before = (digit.bones[0].distal - digit.bones[0].proximal).normalized();
    for (const DigitBone& bone : digit.bones) {
      const Vector3d along = (bone.distal - bone.proximal).normalized();
      add_border(bodies, inner, bone.segment, bone.proximal, (before + along).normalized(),
                 borders);
      inner = bone.segment;
      before = along;
    }
  }
  return borders;
}

/// Computes the fraction of a cell that belongs to a body and not to its neighbours [1].
double share_left(const std::vector<Border>& borders, const Vector3d& p, double step) {
  double share = 1;
  // Subtract the half spaces of neighbours that overlap here.
  for (const Border& border : borders) {
    const double beyond = (p - border.center).dot(border.outward) / step;
    if (beyond > -0.5 && implicit_height(*border.other, p) < 0)
      share *= std::max(0.5 - beyond, 0.0);
  }
  return share;
}

/// Integrates the mass over the cells of a grid.
LinkMass integrate(const ImplicitBody& body, const std::vector<Border>& borders) {
  // Set up a grid with 80 cells along the diagonal.
  const Eigen::AlignedBox3d box = implicit_bounds(body);
  const double step = box.diagonal().norm() / 80;
  const Eigen::Vector3i cells = (box.sizes() / step).array().ceil().cast<int>();
  double volume = 0;
  Vector3d first = Vector3d::Zero();
  Matrix3d second = Matrix3d::Zero();
  for (int i = 0; i < cells.x(); ++i)
    for (int j = 0; j < cells.y(); ++j)
      for (int k = 0; k < cells.z(); ++k) {
        // Compute the part of the cell inside the body, less that of neighbours.
        const Vector3d p = box.min() + step * Vector3d(i + 0.5, j + 0.5, k + 0.5);
        double part = std::clamp(0.5 - implicit_height(body, p) / step, 0.0, 1.0);
        if (part > 0) part *= share_left(borders, p, step);
        if (part == 0) continue;
        // Add the moments of the cell about the middle of the box.
        const Vector3d from = p - box.center();
        volume += part;
        first += part * from;
        second += part * (from * from.transpose() + step * step / 12 * Matrix3d::Identity());
      }
  if (volume == 0) return {};
  // Shift the moments to the centre of mass.
  const Vector3d com = first / volume;
  second -= volume * com * com.transpose();
  const double cell = kHandDensity * step * step * step;
  return {cell * volume,
          box.center() + com,
          cell * (second.trace() * Matrix3d::Identity() - second),
          {}};
}

}  // namespace

std::map<std::string, LinkMass> skin_masses(const HandAnatomy& hand,
                                            const std::map<std::string, ImplicitBody>& bodies) {
  const auto borders = borders_of(hand, bodies);
  std::map<std::string, LinkMass> masses;
  for (const auto& [segment, body] : bodies) {
    const auto found = borders.find(segment);
    masses[segment] =
        integrate(body, found == borders.end() ? std::vector<Border>{} : found->second);
  }
  return masses;
}

Subject with_skin_masses(Subject subject) {
  const HandAnatomy hand = find_anatomy(subject);
  const auto masses = skin_masses(hand, skin_bodies(hand));
  // Set masses only where nothing is stated.
  for (Segment& segment : subject.segments) {
    const auto found = masses.find(segment.name);
    if (found == masses.end() || segment.mass > 0 || segment.radius > 0) continue;
    segment.mass = found->second.mass;
    segment.com = found->second.com;
    segment.inertia = found->second.inertia;
  }
  return subject;
}

}  // namespace thenar
