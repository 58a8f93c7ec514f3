#include "bench/peers/mujoco_model.h"

#include <algorithm>

#include "base/error.h"

namespace thenar::bench {

MujocoModel mujoco_model(const std::string& mjcf) {
  mjVFS files;
  mj_defaultVFS(&files);
  mj_makeEmptyFileVFS(&files, "model.xml", static_cast<int>(mjcf.size()));
  std::copy(mjcf.begin(), mjcf.end(), static_cast<char*>(files.filedata[0]));
  char error[500] = "";
  MujocoModel model(mj_loadXML("model.xml", &files, error, sizeof(error)), mj_deleteModel);
  mj_deleteVFS(&files);
  require(model != nullptr, "MuJoCo refuses a model: {}", error);
  return model;
}

}  // namespace thenar::bench
