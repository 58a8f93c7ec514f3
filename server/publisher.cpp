#include "server/publisher.h"

#include <utility>

#include <nlohmann/json.hpp>

#include "base/lists.h"
#include "server/frame.h"
#include "server/rpc.h"
#include "server/scene_message.h"

namespace thenar {
namespace {

constexpr std::chrono::microseconds kFrameInterval{16'667};  // shortest time between two frames
constexpr std::chrono::milliseconds kTimeInterval{100};  // between states that differ in time only
constexpr auto kNever = Publisher::Clock::time_point::max();

/// Returns a state without the time of the motion, which changes at every step.
OrderedJson timeless(OrderedJson state) {
  if (state.is_object() && state["motion"].is_object()) state["motion"]["t"] = nullptr;
  return state;
}

}  // namespace

void notify_watchers(const EngineClients& clients, const std::string& text) {
  const auto shared = std::make_shared<const std::string>(text);
  for (const auto& client : clients)
    if (client->is_watching()) client->notify(shared);
}

void Publisher::request_full_update() {
  is_up_to_date_ = false;
  next_ = {};
}

Publisher::Clock::time_point Publisher::publish(Session& session, const EngineClients& clients) {
  if (!any_of(clients, [](const auto& client) { return client->is_watching(); })) return kNever;
  // Find out whether the picture has changed.
  const LiveModel* model = session.shown_model();
  const bool moved = model != nullptr && model->changes() != changes_;
  const bool pictured = !is_up_to_date_ || moved || session.revision() != revision_;
  // Wait until the next frame is due.
  const auto now = Clock::now();
  if (pictured && now < next_) return next_;
  // Mark the changes as sent first, so that a failure is not repeated until something changes.
  const bool everything = !std::exchange(is_up_to_date_, true);
  // Send the state, then the picture that belongs to it.
  const auto due = publish_state(session, clients, everything);
  if (pictured) {
    next_ = now + kFrameInterval;
    publish_picture(session, clients, everything);
  }
  return due;
}

void Publisher::publish_picture(Session& session, const EngineClients& clients, bool everything) {
  // Send the scene if it has changed.
  const LiveModel* model = session.shown_model();
  const bool new_scene = everything || session.revision() != revision_;
  revision_ = session.revision();
  changes_ = model == nullptr ? 0 : model->changes();
  if (new_scene) notify_watchers(clients, rpc_notification("scene", scene_message(session)));
  if (model == nullptr) return;
  // Send a frame.
  const LiveInstant instant = model->instant();
  check_instant(model->shape(), instant);
  const auto frame = std::make_shared<const std::string>(
      encode_frame(instant, static_cast<std::uint32_t>(revision_), ++sequence_));
  for (const auto& client : clients)
    if (client->is_watching()) client->send_frame(frame);
}

Publisher::Clock::time_point Publisher::publish_state(const Session& session,
                                                      const EngineClients& clients,
                                                      bool everything) {
  OrderedJson state = state_message(session, clients.size());
  const std::lock_guard<std::mutex> lock(state_mutex_);
  if (!everything && state == state_) return kNever;
  // Limit the rate of states that differ in time only; frames carry the time, too.
  const auto now = Clock::now();
  const auto due = state_at_ + kTimeInterval;
  if (!everything && now < due && timeless(state) == timeless(state_)) return due;
  state_ = std::move(state);
  state_at_ = now;
  notify_watchers(clients, rpc_notification("state", state_));
  return kNever;
}

void Publisher::publish_busy(const EngineClients& clients, const std::string& text) {
  const std::lock_guard<std::mutex> lock(state_mutex_);
  if (!state_.is_object() || state_["busy"] == text) return;
  state_["busy"] = text;
  notify_watchers(clients, rpc_notification("state", state_));
}

}  // namespace thenar
