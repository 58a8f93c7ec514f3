#include "tests/dynamics/ligament/thumb_on_mug.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "data/io/subject.h"
#include "dynamics/mechanism/build_mechanism.h"
#include "dynamics/mechanism/tree_model.h"
#include "dynamics/mechanism/tree_motion.h"
#include "dynamics/stepping/contact_step.h"
#include "hand/skin/human_surfaces.h"
#include "hand/skin/skin_landmarks.h"
#include "tests/data_folder.h"

namespace thenar::sample {
namespace {

using Eigen::Vector3d;

constexpr double kMugMass = 0.3;          // [kg]
constexpr double kMugHeight = 0.1;        // [m]
constexpr double kMuscleDamping = 0.2;    // [N m s/rad]
constexpr double kPush = 20;              // of the spring that presses the mug [N/m]
constexpr double kPushDamping = 2;        // [N s/m]
constexpr double kCapsuleDamping = 0.02;  // [N m s/rad]

const std::string kDistal = "IP1";               // hinge, and body that it carries
const std::map<std::string, std::string> kBoneOf{// segment that a hinge carries
                                                 {"CMC1_AA", "MC1"},
                                                 {"MCP1_FE", "PP1"},
                                                 {"IP1", "DP1"}};

Vector3d bone_of(const Subject& subject, const std::string& name) {
  const auto segment = std::find_if(subject.segments.begin(), subject.segments.end(),
                                    [&](const Segment& each) { return each.name == name; });
  return (segment->distal - segment->proximal).normalized();
}

/// The thumb on pins, in a posture.
struct Thumb {
  explicit Thumb(const ThumbOnMugOptions& options)
      : subject(
            with_passive(read_subject(kData + "/subjects/human_hand.toml"), PassiveMoments::kOff)),
        skeleton(build_skeleton(subject, {{"thumb"}, {{"WRIST_FE", 0}, {"WRIST_AA", 0}}})),
        mechanism(skeleton_mechanism(skeleton)),
        model(tree_model(mechanism)),
        motion(model) {
    std::map<std::string, double> angles;
    for (const auto& [name, degrees] : options.posture) angles[name] = degrees * kDegree;
    q = posture(skeleton, angles);
    motion.set_position(q);
    X_WD = motion.pose(body_named(mechanism, kDistal));
    // Skin of the distal phalanx, at the reference posture, and its pad.
    const HandAnatomy anatomy = find_anatomy(subject);
    skin = skin_mesh(skin_bodies(anatomy).at("DP1"), options.triangles);
    ShapeSpec shape;
    shape.kind = ShapeKind::kMesh;
    shape.mesh = skin;
    mechanism.bodies[static_cast<std::size_t>(body_named(mechanism, kDistal))].solid =
        std::make_shared<const Solid>(build_solid({shape}));
    bone = bone_of(subject, "DP1");
    pad = pad_normal(subject, skeleton, "thumb");
  }

  Subject subject;
  Skeleton skeleton;
  Mechanism mechanism;
  TreeModel model;
  TreeMotion<double> motion;
  Eigen::VectorXd q;
  Pose<double> X_WD;  // of the distal body
  TriangleMesh skin;
  Vector3d bone, pad;
};

/// How far along `out` a cylinder's axis stands from `middle` when it touches the vertices [m].
double touching_distance(const Eigen::Matrix3Xd& vertices, const Vector3d& middle,
                         const Vector3d& out, const Vector3d& axis, double radius) {
  const Vector3d across = axis.cross(out);
  double most = -1;
  for (Eigen::Index i = 0; i < vertices.cols(); ++i) {
    const Vector3d p = vertices.col(i) - middle;
    const double b = across.dot(p);
    if (std::abs(b) < radius && std::abs(axis.dot(p)) < 0.5 * kMugHeight)
      most = std::max(most, out.dot(p) + std::sqrt(radius * radius - b * b));
  }
  return most;
}

/// A mug that touches the thumb, and the way in which it slides: away from the thumb.
struct Mug {
  Mug(const Thumb& thumb, const ThumbOnMugOptions& options) {
    const Vector3d along = thumb.X_WD.R * thumb.bone, palmar = thumb.X_WD.R * thumb.pad;
    // Of a right hand.
    const Vector3d ulnar = palmar.cross(along);
    const double around = options.from_pad * kDegree, tilt = options.tilt * kDegree;
    away = std::cos(around) * palmar + std::sin(around) * ulnar;
    const Vector3d axis = std::cos(tilt) * along + std::sin(tilt) * away.cross(along);
    const Vector3d middle = thumb.X_WD * tip(thumb.skeleton, "thumb").p;
    const Eigen::Matrix3Xd vertices = (thumb.X_WD.R * thumb.skin.vertices).colwise() + thumb.X_WD.p;
    PlacedBody placed;
    placed.body.name = "mug";
    placed.body.uniform_mass = kMugMass;
    ShapeSpec cylinder;
    cylinder.kind = ShapeKind::kCylinder;
    cylinder.size = {options.mug_radius, kMugHeight, 0};
    placed.body.shapes = {cylinder};
    placed.dynamic = true;
    const Tangents sides = tangents(axis), across = tangents(away);
    Pose<double> X_WB, A;
    X_WB.R << sides.e1, sides.e2, axis;
    A.R << across.e1, across.e2, away;
    X_WB.p = A.p =
        middle + touching_distance(vertices, middle, away, axis, options.mug_radius) * away;
    touches = A.p - options.mug_radius * away;
    // On a slide.
    mechanism = body_mechanism(placed);
    MechanismJoint& slide = mechanism.joints.front();
    slide.kind = JointKind::kSlide;
    slide.coordinate = 0;
    slide.X_PF = A;
    slide.X_BM = X_WB.inverse() * A;
    mechanism.coordinates = {{"mug"}};
  }

  Mechanism mechanism;
  Vector3d away, touches;
};

/// A drive whose effort grows evenly from 0, with a spring about where it is.
SceneDrive growing_drive(int coordinate, double stiffness, double damping, double at,
                         double effort_rate) {
  SceneDrive drive;
  drive.coordinate = coordinate;
  drive.stiffness = stiffness;
  drive.damping = damping;
  drive.target = at;
  drive.speed = effort_rate / stiffness;
  drive.bias = -damping * drive.speed;  // the target's speed is no speed of the joint
  return drive;
}

}  // namespace

std::map<std::string, BushingLaw> joint_laws(double stiffer) {
  const double rigid = std::numeric_limits<double>::infinity();
  const auto law = [&](const CapsuleLaw& abduction, const CapsuleLaw& twist) {
    BushingLaw out;
    for (const BushingCoordinate way :
         {BushingCoordinate::kAcross, BushingCoordinate::kAlong, BushingCoordinate::kAxial})
      out.law_for(way) = {1e5, rigid, 20, 100};
    out.law_for(BushingCoordinate::kAbduction) = abduction;
    out.law_for(BushingCoordinate::kTwist) = twist;
    for (CapsuleLaw& each : out.laws) each.stiffness *= stiffer;
    return out;
  };
  return {{"CMC1_AA", law({rigid}, {0.4, 0.15, 20, kCapsuleDamping})},
          {"MCP1_FE", law({1.5, 0.1, 20, kCapsuleDamping}, {0.5, 0.15, 20, kCapsuleDamping})},
          {"IP1", law({3, 0.1, 20, kCapsuleDamping}, {0.5, 0.15, 20, kCapsuleDamping})}};
}

ThumbOnMug thumb_on_mug(const ThumbOnMugOptions& options) {
  Thumb thumb(options);
  const Mug mug(thumb, options);
  ThumbOnMug out;
  out.bone = thumb.bone;
  out.pad = thumb.pad;
  // Moments of a unit force on each hinge.
  Eigen::VectorXd moment = Eigen::VectorXd::Zero(thumb.model.layout.v);
  thumb.motion.add_jacobian_row(
      thumb.model.bodies[static_cast<std::size_t>(body_named(thumb.mechanism, kDistal))].link,
      mug.touches, Vector3d(-mug.away), Vector3d(0, 0, 0), moment);

  // Joints that give, then the mug.
  std::vector<CompliantJoint> joints;
  if (options.compliant)
    for (const auto& [name, law] : joint_laws(options.stiffer))
      joints.push_back(make_compliant(thumb.mechanism, joint_index(thumb.mechanism, name),
                                      {law, bone_of(thumb.subject, kBoneOf.at(name))}));
  const auto mug_coordinate = static_cast<int>(thumb.mechanism.coordinates.size());
  out.scene.mechanism = std::move(thumb.mechanism);
  out.mug = append(out.scene.mechanism, mug.mechanism);
  out.distal = body_named(out.scene.mechanism, kDistal);
  for (const CompliantJoint& joint : joints)
    out.scene.elements.push_back(std::make_shared<CapsuleElement>(out.scene.mechanism, joint));

  // Start, muscles, and the force on the mug.
  const MechanismLayout layout = layout_of(out.scene.mechanism);
  out.scene.q = reference_position(out.scene.mechanism);
  out.scene.v = Eigen::VectorXd::Zero(layout.v);
  out.scene.gravity.setZero();
  out.scene.friction.coefficient = options.friction;
  const double rate = options.most_force / options.seconds;  // [N/s]
  for (int c = 0; c < thumb.skeleton.coordinates(); ++c) {
    out.scene.q[layout.coordinate_q[static_cast<std::size_t>(c)]] = thumb.q[c];
    out.scene.drives.push_back(growing_drive(
        c, options.muscle, kMuscleDamping, thumb.q[c],
        -rate * moment[thumb.model.layout.coordinate_v[static_cast<std::size_t>(c)]]));
  }
  out.scene.drives.push_back(growing_drive(mug_coordinate, kPush, kPushDamping, 0, -rate));
  out.options.method = SteppingMethod::kTimeStepping;
  out.options.step_length = 5e-4;
  out.options.duration = options.seconds;
  out.options.sample_interval = 0.05 * options.seconds;
  return out;
}

std::vector<ThumbOnMugState> states_of(const ThumbOnMug& made, const SceneRun& run) {
  ContactStep step(made.scene);
  const MechanismLayout layout = layout_of(made.scene.mechanism);
  const SceneDrive& push = made.scene.drives.back();
  const int slide_q = layout.coordinate_q.back(), slide_v = layout.coordinate_v.back();
  std::vector<ThumbOnMugState> out;
  std::vector<Pose<double>> poses;
  Pose<double> X_start;
  for (const SceneSample& sample : run.samples) {
    step.compute_poses({sample.t, sample.q, sample.v, sample.z}, poses);
    const Pose<double>& X = poses[static_cast<std::size_t>(made.distal)];
    if (out.empty()) X_start = X;
    ThumbOnMugState state{sample.t, 0, std::nan(""), 0, {}};
    state.force = -drive_effort(push, sample.q[slide_q], sample.v[slide_v], sample.t, sample.t);
    // Normals are outward of the mug; of several points they are weighed by their forces.
    Vector3d to_mug(0, 0, 0);
    for (const ContactSample& contact : sample.contacts)
      to_mug -= contact.force.dot(contact.normal) * contact.normal;
    const Vector3d bone = X.R * made.bone, pad = X.R * made.pad;
    if (!to_mug.isZero(0))
      state.pad_angle = std::acos(std::clamp(pad.dot(to_mug.normalized()), -1.0, 1.0));
    // Turn about the bone: the pad against where it was, across the bone as it is.
    const Vector3d was = X_start.R * made.pad;
    const Vector3d before = (was - was.dot(bone) * bone).normalized();
    state.roll = -std::atan2(bone.dot(before.cross(pad)), before.dot(pad));
    for (std::size_t c = 0; c < layout.coordinate_q.size(); ++c)
      state.moved[made.scene.mechanism.coordinates[c].name] =
          sample.q[layout.coordinate_q[c]] - made.scene.q[layout.coordinate_q[c]];
    out.push_back(std::move(state));
  }
  return out;
}

}  // namespace thenar::sample
