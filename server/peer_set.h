#pragma once

/// The connections of a server that are alive, whichever thread lets go of them last.

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace thenar {

/// Knows connections without keeping them: each takes itself out when it goes.
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
  /// Returns the peers that are connected now.
  [[nodiscard]] std::vector<std::shared_ptr<Peer>> all() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::vector<std::shared_ptr<Peer>> found;
    for (const auto& [key, peer] : peers_)
      if (auto there = peer.lock()) found.push_back(std::move(there));
    return found;
  }
  [[nodiscard]] std::size_t size() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return peers_.size();
  }

 private:
  mutable std::mutex mutex_;
  std::map<const Peer*, std::weak_ptr<Peer>> peers_;
};

}  // namespace thenar
