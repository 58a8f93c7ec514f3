#include <cmath>

#include "base/error.h"
#include "base/nearest_name.h"
#include "dynamics/scene/build_scene.h"

namespace thenar {
namespace {

/// Returns the part of a name after "KIND/"; "" if it does not begin with that.
std::string name_after(const std::string& kind, const std::string& name) {
  return name.size() > kind.size() + 1 && name.compare(0, kind.size() + 1, kind + "/") == 0
             ? name.substr(kind.size() + 1)
             : "";
}

/// Returns all indices of a name in a list. @throws InputError if it is not there
std::vector<std::size_t> indices_of(const std::string& name, const std::vector<std::string>& names,
                                    const std::string& kind) {
  std::vector<std::size_t> indices;
  for (std::size_t i = index_of_name(name, names, kind); i < names.size(); ++i)
    if (names[i] == name) indices.push_back(i);
  return indices;
}

/// Sets the mass of a body and scales its inertia.
void set_mass(Mechanism& mechanism, const std::string& name, double mass) {
  BodyMass& body = mechanism.bodies[body_named(mechanism, name)].mass;
  require(body.mass > 0, "'{}' does not move: its mass plays no part", name);
  require(mass > 0, "wanted a mass above 0 of '{}', got {:g}", name, mass);
  body.inertia *= mass / body.mass;
  body.mass = mass;
}

/// Sets the magnitude of a force, or of its moment if there is no force.
void set_force(SceneForce& force, double magnitude) {
  Eigen::Vector3d& vector = force.force.isZero(0) ? force.moment : force.force;
  vector *= magnitude / vector.norm();
}

}  // namespace

void set_number(BuiltScene& built, const std::string& name, double value) {
  require(std::isfinite(value), "wanted a finite value of '{}'", name);
  MovingScene& scene = built.scene;
  // Numbers of the whole scene, then of a body, force or drive; several may have one name.
  if (name == "friction") {
    require(built.pads == 0,
            "cannot vary 'friction': pads keep that of their [[pad]], unless all are hard points");
    scene.friction.coefficient = value;
    for (auto& [bodies, pair] : scene.friction_pairs) pair.coefficient = value;
  } else if (name == "step") {
    built.options.step_length = value;
  } else if (name == "longest") {
    built.options.max_step = value;
  } else if (name == "tolerance") {
    built.options.tolerance = value;
  } else if (const std::string body = name_after("mass", name); !body.empty()) {
    set_mass(scene.mechanism, body, value);
  } else if (const std::string force = name_after("force", name); !force.empty()) {
    for (const std::size_t i : indices_of(force, built.force_names, "force"))
      set_force(scene.forces[i], value);
  } else if (const std::string drive = name_after("drive", name); !drive.empty()) {
    for (const std::size_t i : indices_of(drive, built.drive_names, "drive"))
      scene.drives[i].bias = std::copysign(value, scene.drives[i].bias);
  } else {
    throw InputError(fmt::format(
        "cannot vary '{}': wanted friction, mass/BODY, force/NAME, drive/NAME, step, longest or "
        "tolerance",
        name));
  }
  // Check the changed scene.
  check_scene(scene);
}

}  // namespace thenar
