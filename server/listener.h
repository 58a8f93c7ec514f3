#pragma once

/// Accepting of connections at an address, on a thread of its own.

#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <boost/asio.hpp>

#include "base/error.h"
#include "server/access.h"

namespace thenar {

/// Acceptor of a server, and the thread on which its connections run.
/// @tparam Net  state that connections share, with its `context` and its connections in `peers`
/// @tparam Connection  made of a socket and the shared state
template <typename Net, typename Connection>
class ConnectionListener {
 public:
  /// @param free_port  setting that takes a free port, for messages
  /// @throws InputError if the server cannot listen at the address and port
  ConnectionListener(std::shared_ptr<Net> net, const ServerAccess& access,
                     const std::string& free_port)
      : net_(std::move(net)), acceptor_(net_->context), retry_timer_(net_->context) {
    try {
      const boost::asio::ip::tcp::endpoint end(boost::asio::ip::make_address(access.address),
                                               static_cast<unsigned short>(access.port));
      acceptor_.open(end.protocol());
      acceptor_.set_option(boost::asio::socket_base::reuse_address(true));
      acceptor_.bind(end);
      acceptor_.listen();
      port_ = acceptor_.local_endpoint().port();
    } catch (const boost::system::system_error& error) {
      throw InputError(fmt::format("cannot listen at {}, port {}: {}; {} takes a free one",
                                   access.address, access.port, error.code().message(), free_port));
    }
  }

  /// Finishes all connections, and closes after 0.3 s those that are still open.
  ~ConnectionListener() {
    if (!thread_.joinable()) return;
    boost::asio::steady_timer deadline(net_->context);
    boost::asio::post(net_->context, [&] {
      boost::system::error_code ignored;
      acceptor_.close(ignored);
      retry_timer_.cancel();
      for (const auto& peer : net_->peers.connected()) peer->finish();
      deadline.expires_after(std::chrono::milliseconds(300));
      deadline.async_wait([this](boost::system::error_code) {
        for (const auto& peer : net_->peers.connected()) peer->drop();
      });
    });
    thread_.join();
  }

  ConnectionListener(const ConnectionListener&) = delete;
  ConnectionListener& operator=(const ConnectionListener&) = delete;

  /// Begins to accept connections.
  void start() {
    accept();
    thread_ = std::thread([this] { net_->context.run(); });
  }

  [[nodiscard]] int port() const { return port_; }

 private:
  void accept() {
    acceptor_.async_accept(
        [this](boost::system::error_code error, boost::asio::ip::tcp::socket socket) {
          if (!acceptor_.is_open()) return;
          if (!error) {
            const auto connection = std::make_shared<Connection>(std::move(socket), net_);
            net_->peers.add(connection);
            connection->begin();
            return accept();
          }
          // Accepting fails if no file descriptor is left: try again later.
          retry_timer_.expires_after(std::chrono::milliseconds(50));
          retry_timer_.async_wait([this](boost::system::error_code stopped) {
            if (!stopped) accept();
          });
        });
  }

  std::shared_ptr<Net> net_;
  boost::asio::ip::tcp::acceptor acceptor_;
  boost::asio::steady_timer retry_timer_;
  int port_ = 0;
  std::thread thread_;
};

}  // namespace thenar
