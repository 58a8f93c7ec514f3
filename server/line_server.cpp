#include "server/line_server.h"

#include <array>
#include <chrono>
#include <deque>
#include <list>
#include <optional>
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

// Of what a client has asked without a reply so far, and of replies that it has not taken: beyond
// these it is read no further. Replies that nobody takes end its connection.
constexpr std::size_t kMostUnanswered = 256;            // requests
constexpr std::size_t kMostAskedBytes = kMaxLineBytes;  // [bytes]
constexpr std::size_t kMostUnread = 64UL << 20U;        // [bytes]
// Of all clients together; then only those are read that have no request without a reply.
constexpr std::size_t kMostAskedOfAll = 32UL << 20U;    // [bytes]
constexpr std::size_t kMostUnreadOfAll = 128UL << 20U;  // [bytes]
// Of connections that have not asked for anything, where a token is wanted.
constexpr std::size_t kMostStrangers = 64;         // also where none is wanted
constexpr std::size_t kLongestGreeting = 4096;     // [bytes]
constexpr std::chrono::seconds kGreetingTime{10};  // until the token is shown
constexpr std::chrono::milliseconds kLastWords{300};

const std::string kNoGreeting = "wanted session.hello with the token first";

class LineClient;

/// State that all connections of a server share. It holds the context on which they run, so that a
/// connection that the engine still knows does not outlive the context.
struct LineNet {
  LineNet(Engine& the_engine, ServerAccess the_access)
      : engine(the_engine), access(std::move(the_access)) {}

  Engine& engine;
  ServerAccess access;
  net::io_context context{1};
  PeerSet<LineClient> clients;
  std::list<LineClient*> strangers;  // the oldest first; each takes itself out
  std::size_t asked = 0;             // of all clients [bytes]
  std::size_t unread = 0;            // of all clients [bytes]
};

/// A program that is connected. The server's thread uses all members; what the engine calls hands
/// over to it.
class LineClient final : public EngineClient, public std::enable_shared_from_this<LineClient> {
 public:
  LineClient(tcp::socket socket, std::shared_ptr<LineNet> shared)
      : net_(std::move(shared)), socket_(std::move(socket)), greeting_(net_->context) {}
  ~LineClient() override {
    end_waiting();
    net_->clients.remove(this);
  }
  LineClient(const LineClient&) = delete;
  LineClient& operator=(const LineClient&) = delete;

  void begin() {
    boost::system::error_code ignored;
    socket_.set_option(tcp::no_delay(true), ignored);
    socket_.set_option(net::socket_base::keep_alive(true), ignored);
    // Strangers take no place of a client, nor of who comes after them.
    if (net_->strangers.size() >= kMostStrangers) {
      const auto oldest = net_->strangers.front()->shared_from_this();
      oldest->drop();
    }
    stranger_ = net_->strangers.insert(net_->strangers.end(), this);
    read();
    if (net_->access.token.empty()) return;
    greeting_.expires_after(kGreetingTime);
    greeting_.async_wait([self = shared_from_this()](boost::system::error_code stopped) {
      if (!stopped && self->stranger_) self->drop();
    });
  }

  void reply(std::string text) override {
    net::post(socket_.get_executor(), [self = shared_from_this(), text = std::move(text)] {
      self->end_asking();
      if (!text.empty()) self->put(text);
      self->go_on();
    });
  }
  void notify(std::shared_ptr<const std::string> /*text*/) override {}
  void send_frame(std::shared_ptr<const std::string> /*frame*/) override {}
  [[nodiscard]] bool is_watching() const override { return false; }

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
    if (number_ > 0) net_->engine.remove_client(number_);
    number_ = -1;
    // Whoever is gone holds nothing.
    while (!asked_.empty()) end_asking();
    texts_.clear();
    count_unread(-static_cast<std::ptrdiff_t>(unread_));
  }
  [[nodiscard]] std::size_t unread() const { return unread_; }

 private:
  /// Becomes a client of the engine. @returns whether there was room
  bool join() {
    end_waiting();
    try {
      number_ = net_->engine.add_client(shared_from_this());
      return true;
    } catch (const InputError& error) {
      refuse(error.what());
      return false;
    }
  }
  /// Removes the connection from the strangers.
  void end_waiting() {
    if (!stranger_) return;
    net_->strangers.erase(*std::exchange(stranger_, std::nullopt));
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
    if (!begun_) {
      const StreamStart start = stream_start({piece_.data(), count});
      if (start == StreamStart::kOther) return drop();
      begun_ = start == StreamStart::kRequest;
    }
    lines_.add(piece_.data(), count);
    while (const auto line = lines_.next_line())
      if (!take(*line)) return;
    if (stranger_ && !net_->access.token.empty() && lines_.pending_bytes() > kLongestGreeting)
      return refuse(kNoGreeting);
    go_on();
  }

  /// Whoever sends no more may still wait for replies.
  void on_end() {
    if (const auto line = lines_.take_rest())
      if (!take(*line)) return;
    ended_ = true;
    go_on();
  }

  /// @returns whether the client stays
  bool take(const SplitLine& line) {
    const std::string& token = net_->access.token;
    if (stranger_ && !token.empty() && !is_hello_with_token(line.text, token)) {
      refuse(kNoGreeting);
      return false;
    }
    if (stranger_ && !join()) return false;
    asked_.push_back(line.text.size());
    asked_bytes_ += line.text.size();
    net_->asked += line.text.size();
    if (line.too_long)
      reply(too_long_reply());
    else
      net_->engine.receive(number_, line.text);
    return true;
  }

  /// The request that was asked first has its reply.
  void end_asking() {
    if (asked_.empty()) return;
    asked_bytes_ -= asked_.front();
    net_->asked -= asked_.front();
    asked_.pop_front();
  }

  /// Sends the reason of a refusal, and ends.
  void refuse(const std::string& why) {
    put(json_text(rpc_reply(nullptr, {{}, RpcFailure{RpcCode::kRefused, why}}), -1));
    finish();
  }

  /// Reads on where few requests wait; ends where nothing is left to do.
  void go_on() {
    if (number_ < 0) return;
    if (!ended_ && !reading_ && has_room()) return read();
    if (ended_ && asked_.empty() && texts_.empty() && !writing_) drop();
  }

  /// Returns true if more requests may be read before replies are made and taken by the client.
  [[nodiscard]] bool has_room() const {
    if (unread_ >= kMostAskedBytes) return false;
    return asked_.empty() || (asked_.size() < kMostUnanswered && asked_bytes_ < kMostAskedBytes &&
                              net_->asked < kMostAskedOfAll);
  }

  void put(const std::string& text) {
    if (number_ < 0) return;
    texts_.push_back(text + "\n");
    count_unread(static_cast<std::ptrdiff_t>(texts_.back().size()));
    if (unread_ > kMostUnread) return drop();
    if (net_->unread > kMostUnreadOfAll) drop_worst();
    write();
  }

  void count_unread(std::ptrdiff_t bytes) {
    unread_ += static_cast<std::size_t>(bytes);
    net_->unread += static_cast<std::size_t>(bytes);
  }

  /// Ends the connection with the most replies that nobody takes.
  void drop_worst() {
    std::shared_ptr<LineClient> worst;
    for (const auto& client : net_->clients.connected())
      if (worst == nullptr || client->unread() > worst->unread()) worst = client;
    if (worst != nullptr) worst->drop();
  }

  void write() {
    if (writing_ || texts_.empty() || number_ < 0) return;
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
          self->count_unread(-static_cast<std::ptrdiff_t>(out->size()));
          self->write();
          self->go_on();
        });
  }

  std::shared_ptr<LineNet> net_;
  tcp::socket socket_;
  net::steady_timer greeting_;
  std::array<char, 65536> piece_{};
  LineSplitter lines_{kMaxLineBytes};
  int number_ = 0;                                            // of the engine; -1: gone
  std::deque<std::size_t> asked_;                             // bytes of each request
  std::size_t asked_bytes_ = 0, unread_ = 0;                  // [bytes]
  std::optional<std::list<LineClient*>::iterator> stranger_;  // among them; until it is greeted
  bool begun_ = false, ended_ = false, reading_ = false, writing_ = false;
  std::deque<std::string> texts_;
};

}  // namespace

bool is_hello_with_token(const std::string& line, const std::string& token) {
  const auto request = short_request(line, "session.hello");
  if (!request || request->failure) return false;
  const auto shown = request->params.find("token");
  return shown != request->params.end() && shown->is_string() &&
         same_token(shown->get<std::string>(), token);
}

std::string too_long_reply() {
  const RpcFailure failure{RpcCode::kTooLarge,
                           fmt::format("a line of more than {} bytes", kMaxLineBytes)};
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
      for (const auto& client : net_->clients.connected()) client->finish();
      patience.expires_after(kLastWords);
      patience.async_wait([this](boost::system::error_code) {
        for (const auto& client : net_->clients.connected()) client->drop();
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
