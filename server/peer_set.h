#pragma once

/// Set of the live connections of a server; thread-safe.

#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace thenar {

/// Set of weak references to connections; each connection removes itself in its destructor.
template <typename Peer>
class PeerSet {
 public:
  void add(const std::shared_ptr<Peer>& peer) {
    const std::lock_guard<std::mutex> lock(mutex_);
    peers_[peer.get()] = peer;
  }
  void remove(const Peer* peer) {
    const std::lock_guard<std::mutex> lock(mutex_);
    peers_.erase(peer);
  }
  /// Returns all peers that are currently connected.
  [[nodiscard]] std::vector<std::shared_ptr<Peer>> connected() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::vector<std::shared_ptr<Peer>> found;
    for (const auto& [key, peer] : peers_)
      if (auto there = peer.lock()) found.push_back(std::move(there));
    return found;
  }

 private:
  mutable std::mutex mutex_;
  std::map<const Peer*, std::weak_ptr<Peer>> peers_;
};

}  // namespace thenar
