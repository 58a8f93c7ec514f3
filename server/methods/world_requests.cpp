#include "server/methods/world_requests.h"

#include <array>

#include <nlohmann/json.hpp>

#include "base/error.h"

namespace thenar::internal {
namespace {

/// Returns the value of each character in base64; -1: not in the alphabet.
std::array<int, 256> letter_values() {
  std::array<int, 256> values{};
  values.fill(-1);
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < letters.size(); ++i)
    values[static_cast<unsigned char>(letters[i])] = static_cast<int>(i);
  return values;
}

}  // namespace

LiveWorld& live_world(Session& session) { return session.model<LiveWorld>(LiveMode::kWorld); }

LiveWorld& open_live_world(Session& session) {
  if (!session.has_model(LiveMode::kWorld))
    session.open(LiveMode::kWorld, std::make_shared<LiveWorld>(LiveWorldFolders{
                                       session.folders().data, session.folders().folder}));
  session.show(LiveMode::kWorld);
  return live_world(session);
}

LivePair pair_param(const Json& params) {
  return {text_param(params, "hand"), text_param(params, "object")};
}

SchemaMember position_member() {
  return {"position", list_schema(number_schema("m", -kMaxCoordinate, kMaxCoordinate), 3, 3),
          "Where its frame is to be, x, y, z of the world."};
}

SchemaMember rotation_member() {
  return {"rotation", rotation_schema(), "How its frame is to be turned, as a quaternion."};
}

SchemaMember hand_member() {
  return {"hand", text_schema(kMaxNameLength), "Which hand; optional if there is only one."};
}

SchemaMember object_member() {
  return {"object", text_schema(kMaxNameLength), "Which object; optional if there is only one."};
}

SchemaMember gesture_member() {
  return {
      "gesture", text_schema(kMaxNameLength),
      "A name of your own: moves of one thing that follow each other with the same one, as of a "
      "drag, are undone as one. Without it each is undone by itself."};
}

std::string text_param(const Json& params, const std::string& name) {
  return params.contains(name) ? params[name].get<std::string>() : std::string();
}

std::optional<Eigen::Vector3d> position_param(const Json& params) {
  if (!params.contains("position")) return std::nullopt;
  const Json& p = params["position"];
  return Eigen::Vector3d(p[0].get<double>(), p[1].get<double>(), p[2].get<double>());
}

std::optional<Eigen::Matrix3d> rotation_param(const Json& params) {
  if (!params.contains("rotation")) return std::nullopt;
  const Json& q = params["rotation"];
  return Eigen::Quaterniond(q[0].get<double>(), q[1].get<double>(), q[2].get<double>(),
                            q[3].get<double>())
      .normalized()
      .toRotationMatrix();
}

RequestedPose pose_param(const Json& params) {
  return {rotation_param(params).value_or(Eigen::Matrix3d::Identity()), position_param(params)};
}

std::string from_base64(const std::string& text) {
  static const std::array<int, 256> values = letter_values();
  require(text.size() % 4 == 0, "wanted base64, whose length is a multiple of 4, got {} letters",
          text.size());
  // Count the padding.
  std::size_t padding = 0;
  while (padding < 2 && padding < text.size() && text[text.size() - 1 - padding] == '=') ++padding;
  std::string bytes;
  bytes.reserve(3 * (text.size() / 4));
  unsigned gathered = 0;
  // Decode: four characters of 6 bits make three bytes.
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool pads = i >= text.size() - padding;
    const int value = pads ? 0 : values[static_cast<unsigned char>(text[i])];
    require(value >= 0, "wanted base64, got another letter at place {}", i);
    gathered = (gathered << 6U) | static_cast<unsigned>(value);
    if (i % 4 != 3) continue;
    for (const unsigned shift : {16U, 8U, 0U})
      bytes += static_cast<char>(gathered >> shift & 0xFFU);
    gathered = 0;
  }
  bytes.resize(bytes.size() - padding);
  return bytes;
}

}  // namespace thenar::internal
