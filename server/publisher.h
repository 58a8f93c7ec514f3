#pragma once

/// Tells those who watch what has changed: the scene, the state of the session, a frame.

#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "report/json.h"
#include "server/session.h"

namespace thenar {

/// Client at the other end of a connection. The engine's thread calls these functions; they hand
/// over to a thread of their own and return at once.
class EngineClient {
 public:
  virtual ~EngineClient() = default;
  /// A message was dealt with. @param text  the reply; empty: none is wanted
  virtual void reply(std::string text) = 0;
  /// A notification.
  virtual void tell(std::shared_ptr<const std::string> text) = 0;
  /// A frame; one that has not been sent yet is forgotten.
  virtual void show(std::shared_ptr<const std::string> frame) = 0;
  /// Returns true if the client wants notifications and frames.
  [[nodiscard]] virtual bool watches() const = 0;
};

using EngineClients = std::vector<std::shared_ptr<EngineClient>>;

/// State that clients were told last, and changes since. Used by one thread but for tell_busy().
class Publisher {
 public:
  using Clock = std::chrono::steady_clock;

  /// Sends what has changed, at most 60 times a second.
  /// @param clients  all that are connected
  /// @returns when it wants to be called again; the end of time if nothing waits
  Clock::time_point publish(Session& session, const EngineClients& clients);
  /// Tells everything to all clients at the next call: called when a new client watches.
  void tell_all();
  /// Tells what the engine is busy with, beside what was told last.
  void tell_busy(const EngineClients& clients, const std::string& text);

 private:
  void publish_picture(Session& session, const EngineClients& clients, bool everything);
  Clock::time_point publish_state(const Session& session, const EngineClients& clients,
                                  bool everything);

  std::mutex state_mutex_;
  OrderedJson state_;  // told last
  bool told_ = false;  // everything, since someone new has come
  unsigned long revision_ = 0, changes_ = 0;
  std::uint32_t sequence_ = 0;
  Clock::time_point next_, state_at_;
};

/// Sends a text to all who watch.
void tell_watchers(const EngineClients& clients, const std::string& text);

}  // namespace thenar
