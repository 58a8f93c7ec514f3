#include "server/line_server.h"

#include <array>
#include <chrono>
#include <deque>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <boost/asio.hpp>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "server/lines.h"
#include "server/peer_set.h"
#include "server/rpc.h"

namespace thenar {
namespace {

namespace net = boost::asio;
using net::ip::tcp;

constexpr std::size_t kMostUnread = 64UL << 20U;   // replies that a client does not take [bytes]
constexpr std::size_t kMostUnanswered = 256;       // requests without a reply; then it waits
constexpr std::size_t kMostUngreeted = 256;        // connections that have not shown the token
constexpr std::chrono::seconds kGreetingTime{10};  // that they have for it
constexpr std::chrono::milliseconds kLastWords{300};

class LineClient;

/// What all connections of a server share. It holds the context that they run on, so that one which
/// the engine still knows does not outlive it.
struct LineNet {
  LineNet(Engine& the_engine, ServerAccess the_access)
      : engine(the_engine), access(std::move(the_access)) {}

  Engine& engine;
  ServerAccess access;
  net::io_context context{1};
  PeerSet<LineClient> clients;
  std::size_t ungreeted = 0;  // connections that have not shown the token
};

/// A program that is connected. The server's thread uses all members; what the engine calls hands
/// over to it.
class LineClient final : public EngineClient, public std::enable_shared_from_this<LineClient> {
 public:
  LineClient(tcp::socket socket, std::shared_ptr<LineNet> shared)
      : net_(std::move(shared)), socket_(std::move(socket)), greeting_(net_->context) {}
  ~LineClient() override { net_->clients.remove(this); }
  LineClient(const LineClient&) = delete;
  LineClient& operator=(const LineClient&) = delete;

  void begin() {
    boost::system::error_code ignored;
    socket_.set_option(tcp::no_delay(true), ignored);
    socket_.set_option(net::socket_base::keep_alive(true), ignored);
    if (net_->access.token.empty()) {
      if (join()) read();
      return;
    }
    // Strangers take no place of a client, and are bounded by themselves.
    if (net_->ungreeted >= kMostUngreeted) return drop();
    waits_ = true;
    ++net_->ungreeted;
    greeting_.expires_after(kGreetingTime);
    greeting_.async_wait([self = shared_from_this()](boost::system::error_code stopped) {
      if (!stopped && self->waits_) self->drop();
    });
    read();
  }

  void reply(std::string text) override {
    net::post(socket_.get_executor(), [self = shared_from_this(), text = std::move(text)] {
      --self->asked_;
      if (!text.empty()) self->put(text);
      self->go_on();
    });
  }
  void tell(std::shared_ptr<const std::string> /*text*/) override {}
  void show(std::shared_ptr<const std::string> /*frame*/) override {}
  [[nodiscard]] bool watches() const override { return false; }

  /// Ends when all is sent.
  void finish() {
    ended_ = true;
    go_on();
  }
  /// Ends now.
  void drop() {
    boost::system::error_code ignored;
    socket_.close(ignored);
    end_waiting();
    if (number_ > 0) net_->engine.leave(number_);
    number_ = -1;
    texts_.clear();
  }

 private:
  /// Becomes a client of the engine. @returns whether there was room
  bool join() {
    greeted_ = true;
    try {
      number_ = net_->engine.join(shared_from_this());
      return true;
    } catch (const InputError& error) {
      refuse(error.what());
      return false;
    }
  }
  /// Is a stranger no longer.
  void end_waiting() {
    if (!std::exchange(waits_, false)) return;
    --net_->ungreeted;
    greeting_.cancel();
  }

  void read() {
    reading_ = true;
    socket_.async_read_some(
        net::buffer(piece_),
        [self = shared_from_this()](boost::system::error_code error, std::size_t count) {
          self->reading_ = false;
          if (self->number_ < 0) return;
          if (error == net::error::eof) return self->on_end();
          if (error) return self->drop();
          self->on_bytes(count);
        });
  }

  void on_bytes(std::size_t count) {
    if (!std::exchange(begun_, true) && looks_like_http({piece_.data(), 1})) return drop();
    lines_.add(piece_.data(), count);
    while (const auto line = lines_.next())
      if (!take(*line)) return;
    go_on();
  }

  /// Whoever sends no more may still wait for replies.
  void on_end() {
    if (const auto line = lines_.rest())
      if (!take(*line)) return;
    ended_ = true;
    go_on();
  }

  /// @returns whether the client stays
  bool take(const SplitLine& line) {
    if (!greeted_ && !greets_with(line.text, net_->access.token)) {
      refuse("wanted session.hello with the token first");
      return false;
    }
    if (!greeted_) {
      end_waiting();
      if (!join()) return false;
    }
    ++asked_;
    if (line.too_long)
      reply(too_long_reply());
    else
      net_->engine.receive(number_, line.text);
    return true;
  }

  /// Says why, and ends.
  void refuse(const std::string& why) {
    put(json_text(rpc_reply(nullptr, {{}, RpcFailure{RpcCode::kRefused, why}}), -1));
    finish();
  }

  /// Reads on where few requests wait; ends where nothing is left to do.
  void go_on() {
    if (number_ < 0) return;
    if (!ended_ && !reading_ && asked_ < kMostUnanswered) return read();
    if (ended_ && asked_ == 0 && texts_.empty() && !writing_) drop();
  }

  void put(const std::string& text) {
    if (number_ < 0) return;
    texts_.push_back(text + "\n");
    unread_ += texts_.back().size();
    if (unread_ > kMostUnread) return drop();
    write();
  }

  void write() {
    if (writing_ || texts_.empty()) return;
    writing_ = true;
    // A short reply goes out with those that wait beside it.
    auto out = std::make_shared<std::string>();
    while (!texts_.empty() && (out->empty() || out->size() + texts_.front().size() < 65536)) {
      *out += texts_.front();
      texts_.pop_front();
    }
    net::async_write(
        socket_, net::buffer(*out),
        [self = shared_from_this(), out](boost::system::error_code error, std::size_t) {
          self->writing_ = false;
          if (self->number_ < 0) return;
          if (error) return self->drop();
          self->unread_ -= out->size();
          self->write();
          self->go_on();
        });
  }

  std::shared_ptr<LineNet> net_;
  tcp::socket socket_;
  net::steady_timer greeting_;
  std::array<char, 65536> piece_{};
  LineSplitter lines_{kLongestLine};
  int number_ = 0;  // of the engine; -1: gone
  std::size_t asked_ = 0, unread_ = 0;
  bool waits_ = false;  // among the strangers
  bool begun_ = false, greeted_ = false, ended_ = false, reading_ = false, writing_ = false;
  std::deque<std::string> texts_;
};

}  // namespace

bool greets_with(const std::string& line, const std::string& token) {
  const auto request = short_request(line, "session.hello");
  if (!request || request->failure) return false;
  const auto shown = request->params.find("token");
  return shown != request->params.end() && shown->is_string() &&
         same_token(shown->get<std::string>(), token);
}

std::string too_long_reply() {
  const RpcFailure failure{RpcCode::kTooLarge,
                           fmt::format("a line of more than {} bytes", kLongestLine)};
  return json_text(rpc_reply(nullptr, {{}, failure}), -1);
}

class LineServer::Network {
 public:
  Network(Engine& engine, const ServerAccess& access)
      : net_(std::make_shared<LineNet>(engine, access)),
        acceptor_(net_->context),
        pause_(net_->context) {
    try {
      const tcp::endpoint end(net::ip::make_address(access.address),
                              static_cast<unsigned short>(access.port));
      acceptor_.open(end.protocol());
      acceptor_.set_option(net::socket_base::reuse_address(true));
      acceptor_.bind(end);
      acceptor_.listen();
      port_ = acceptor_.local_endpoint().port();
    } catch (const boost::system::system_error& error) {
      throw InputError(fmt::format("cannot listen at {}, port {}: {}; port 0 takes a free one",
                                   access.address, access.port, error.code().message()));
    }
    accept();
    thread_ = std::thread([this] { net_->context.run(); });
  }

  ~Network() {
    net::steady_timer patience(net_->context);
    net::post(net_->context, [&] {
      boost::system::error_code ignored;
      acceptor_.close(ignored);
      pause_.cancel();
      for (const auto& client : net_->clients.all()) client->finish();
      patience.expires_after(kLastWords);
      patience.async_wait([this](boost::system::error_code) {
        for (const auto& client : net_->clients.all()) client->drop();
      });
    });
    thread_.join();
  }

  Network(const Network&) = delete;
  Network& operator=(const Network&) = delete;

  [[nodiscard]] int port() const { return port_; }

 private:
  void accept() {
    acceptor_.async_accept([this](boost::system::error_code error, tcp::socket socket) {
      if (!acceptor_.is_open()) return;
      if (!error) {
        const auto client = std::make_shared<LineClient>(std::move(socket), net_);
        net_->clients.add(client);
        client->begin();
        return accept();
      }
      // No file is left for a connection: it is tried again in a while.
      pause_.expires_after(std::chrono::milliseconds(50));
      pause_.async_wait([this](boost::system::error_code stopped) {
        if (!stopped) accept();
      });
    });
  }

  std::shared_ptr<LineNet> net_;
  tcp::acceptor acceptor_;
  net::steady_timer pause_;
  int port_ = 0;
  std::thread thread_;
};

LineServer::LineServer(Engine& engine, const ServerAccess& access)
    : network_(std::make_unique<Network>(engine, access)) {}

LineServer::~LineServer() = default;

int LineServer::port() const { return network_->port(); }

}  // namespace thenar
