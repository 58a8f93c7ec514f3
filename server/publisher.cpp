#include "server/publisher.h"

#include <utility>

#include <nlohmann/json.hpp>

#include "base/lists.h"
#include "server/frame.h"
#include "server/rpc.h"
#include "server/scene_message.h"

namespace thenar {
namespace {

constexpr std::chrono::microseconds kFrame{16'667};   // between two frames
constexpr std::chrono::milliseconds kClockTick{100};  // between two states that differ in time
constexpr auto kNever = Publisher::Clock::time_point::max();

bool is_watched(const EngineClients& clients) {
  return any_of(clients, [](const auto& client) { return client->is_watching(); });
}

/// A state without the time of a motion, which changes at every step.
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
  if (!is_watched(clients)) return kNever;
  const LiveModel* model = session.shown_model();
  const bool moved = model != nullptr && model->changes() != changes_;
  const bool pictured = !is_up_to_date_ || moved || session.revision() != revision_;
  // Too soon: whoever calls comes again when it is time, and sends the latest then.
  const auto now = Clock::now();
  if (pictured && now < next_) return next_;
  // Whatever fails below is not tried again before something changes.
  const bool everything = !std::exchange(is_up_to_date_, true);
  // State goes first, so that whoever sees a scene knows what it is of.
  const auto due = publish_state(session, clients, everything);
  if (pictured) {
    next_ = now + kFrame;
    publish_picture(session, clients, everything);
  }
  return due;
}

void Publisher::publish_picture(Session& session, const EngineClients& clients, bool everything) {
  const LiveModel* model = session.shown_model();
  const bool new_scene = everything || session.revision() != revision_;
  revision_ = session.revision();
  changes_ = model == nullptr ? 0 : model->changes();
  if (new_scene) notify_watchers(clients, rpc_notification("scene", scene_message(session)));
  if (model == nullptr) return;
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
  // Time alone is told ten times a second; frames carry it, too.
  const auto now = Clock::now();
  const auto due = state_at_ + kClockTick;
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
