#pragma once

/// Publishing of changes to watching clients: the scene, the state of the session, frames.

#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "report/json.h"
#include "server/session.h"

namespace thenar {

/// Client of an engine. The engine's thread calls these functions; they pass the data to the thread
/// of the connection and return at once.
class EngineClient {
 public:
  virtual ~EngineClient() = default;
  /// Sends the reply to a message. @param text  reply; empty: the message was a notification
  virtual void reply(std::string text) = 0;
  /// Sends a notification.
  virtual void notify(std::shared_ptr<const std::string> text) = 0;
  /// Sends a frame, in place of an older one that has not been sent.
  virtual void send_frame(std::shared_ptr<const std::string> frame) = 0;
  /// Returns true if the client wants notifications and frames.
  [[nodiscard]] virtual bool is_watching() const = 0;
};

using EngineClients = std::vector<std::shared_ptr<EngineClient>>;

/// Publisher of changes since the last update. Not thread-safe, except for publish_busy().
class Publisher {
 public:
  using Clock = std::chrono::steady_clock;

  /// Sends changes to all watching clients, at most 60 times a second.
  /// @param clients  all connected clients
  /// @return time of the next call; Clock::time_point::max() if no change is pending
  Clock::time_point publish(Session& session, const EngineClients& clients);
  /// Makes the next publish() send everything, for a new client.
  void request_full_update();
  /// Sends the last state with the activity of the engine.
  void publish_busy(const EngineClients& clients, const std::string& text);

 private:
  void publish_picture(Session& session, const EngineClients& clients, bool everything);
  Clock::time_point publish_state(const Session& session, const EngineClients& clients,
                                  bool everything);

  std::mutex state_mutex_;
  OrderedJson state_;           // last state that was sent
  bool is_up_to_date_ = false;  // false: send everything
  unsigned long revision_ = 0, changes_ = 0;
  std::uint32_t sequence_ = 0;
  Clock::time_point next_, state_at_;
};

/// Sends a notification to all watching clients.
void notify_watchers(const EngineClients& clients, const std::string& text);

}  // namespace thenar
