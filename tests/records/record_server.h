#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace ew::test {

struct ServerQuestion {
  std::string method;
  std::string target;                          ///< "/xapi/statements?statementId=..."
  std::map<std::string, std::string> headers;  ///< names in small letters
  std::string body;
  [[nodiscard]] bool writes() const { return method == "POST" || method == "PUT"; }
};

struct ServerAnswer {
  int status = 200;
  std::string body;
  std::vector<std::string> headers;
};

/// What goes wrong with one question.
enum class Fault {
  none,
  closeBeforeTaking,  ///< the connection ends, nothing is stored
  closeAfterTaking,   ///< it is stored, the connection ends without an answer
  halfAnswer,         ///< it is stored, the answer breaks off
  answerTwice,        ///< the answer comes twice over the same connection
  busy429,
  busy503,
  failBefore,  ///< 500, nothing is stored
  failAfter,   ///< 500, it is stored
  otherPage,   ///< 200 with a page of HTML: a network that wants a login
  silence,     ///< no answer until the other side gives up
  goAway       ///< closes before taking, and nobody listens until comeBack()
};

/// What a test may tell the server at any time: the server uses it on its own thread, and what is told waits until that is done.
template <class T>
class Told {
 public:
  Told() = default;
  explicit Told(T value) : value_(std::move(value)) {}
  Told(const Told&) = delete;
  Told& operator=(const Told&) = delete;
  void operator=(T value) {
    const std::lock_guard lock(mutex_);
    value_ = std::move(value);
  }
  template <class Use>
  auto with(const Use& use) const {
    const std::lock_guard lock(mutex_);
    return use(value_);
  }

 private:
  mutable std::recursive_mutex mutex_;
  T value_{};
};

/// A record store for tests on 127.0.0.1. It stores a statement as often as it is told to, unless `knowsIds`: what arrives twice is seen.
class RecordServer {
 public:
  RecordServer();
  ~RecordServer();
  RecordServer(const RecordServer&) = delete;
  RecordServer& operator=(const RecordServer&) = delete;

  [[nodiscard]] int port() const { return port_; }
  [[nodiscard]] std::string endpoint() const { return "http://127.0.0.1:" + std::to_string(port_) + "/xapi/"; }
  void goAway();    ///< nobody listens any more
  void comeBack();  ///< on the same port

  // Set before the first question; what is told, at any time.
  bool knowsIds = false;               ///< as the standard asks: what is there already is not stored again
  bool refusesWhatIsThere = false;     ///< 409 also when it is the same
  bool mayBeRead = true;               ///< else GET is 403
  bool keepsConnections = false;       ///< open after an answer, as most servers do
  bool namesWhatItTook = true;         ///< else POST answers []
  Told<std::string> authorization;     ///< asked for when not empty
  Told<std::string> retryAfter{"7"};   ///< of 429 and 503; empty: not said
  Told<std::set<std::string>> bad;     ///< ids that are 400
  Told<std::set<std::string>> poison;  ///< ids over which it fails with 500
  Told<std::function<Fault(const ServerQuestion&)>> fault;
  Told<std::function<std::optional<ServerAnswer>(const ServerQuestion&)>> other;  ///< asked first
  Told<std::function<void()>> taken;                                              ///< after storing, before the answer

  /// How often each id was stored.
  [[nodiscard]] std::map<std::string, int> arrivals() const;
  [[nodiscard]] std::vector<std::string> order() const;  ///< of ids as they were stored first
  [[nodiscard]] nlohmann::json stored(const std::string& id) const;
  void store(const nlohmann::json& statement);
  void voidStatement(const std::string& id);
  [[nodiscard]] std::vector<ServerQuestion> questions() const;
  [[nodiscard]] int writes() const;
  [[nodiscard]] int connections() const { return connections_; }

 private:
  void listen();
  void serve();
  bool talk(int connection);
  ServerAnswer answerTo(const ServerQuestion& question, bool& tookSomething);
  ServerAnswer take(const nlohmann::json& list, bool isPut);
  ServerAnswer find(const std::string& target) const;

  int port_ = 0;
  std::atomic<int> listener_{-1};
  std::atomic<bool> stops_{false};
  std::atomic<bool> isAway_{false};
  std::atomic<int> connections_{0};
  std::thread thread_;
  mutable std::mutex mutex_;
  std::map<std::string, nlohmann::json> statements_;
  std::set<std::string> voided_;
  std::map<std::string, int> arrivals_;
  std::vector<std::string> order_;
  std::vector<ServerQuestion> questions_;
};

}  // namespace ew::test
