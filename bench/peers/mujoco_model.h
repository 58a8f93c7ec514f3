#pragma once

/// Models of MuJoCo from text.

#include <memory>
#include <string>

#include <mujoco/mujoco.h>

namespace thenar::bench {

using MujocoModel = std::unique_ptr<mjModel, decltype(&mj_deleteModel)>;
using MujocoData = std::unique_ptr<mjData, decltype(&mj_deleteData)>;

/// Compiles a model. @throws InputError with MuJoCo's reason if it refuses.
[[nodiscard]] MujocoModel mujoco_model(const std::string& mjcf);

}  // namespace thenar::bench
