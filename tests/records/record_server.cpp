#include "record_server.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>

namespace ew::test {
namespace {

using nlohmann::json;

std::string parameter(const std::string& target, const std::string& name) {
  const auto at = target.find(name + "=");
  if (at == std::string::npos || (target[at - 1] != '?' && target[at - 1] != '&')) return {};
  const auto begin = at + name.size() + 1;
  return target.substr(begin, target.find('&', begin) - begin);
}

std::optional<ServerQuestion> readQuestion(int connection) {
  std::string text;
  std::string chunk(64 << 10, '\0');
  std::size_t end = std::string::npos, length = 0;
  ServerQuestion question;
  while (end == std::string::npos || text.size() < end + 4 + length) {
    const auto count = ::recv(connection, chunk.data(), chunk.size(), 0);
    if (count <= 0) return std::nullopt;
    text.append(chunk, 0, static_cast<std::size_t>(count));
    if (end != std::string::npos || (end = text.find("\r\n\r\n")) == std::string::npos) continue;
    std::size_t line = text.find("\r\n");
    const std::string first = text.substr(0, line);
    question.method = first.substr(0, first.find(' '));
    question.target = first.substr(question.method.size() + 1, first.rfind(' ') - question.method.size() - 1);
    while (line < end) {
      const auto next = text.find("\r\n", line + 2);
      std::string header = text.substr(line + 2, next - line - 2);
      line = next;
      const auto colon = header.find(": ");
      if (colon == std::string::npos) continue;
      std::string name = header.substr(0, colon);
      std::transform(name.begin(), name.end(), name.begin(), [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
      question.headers[name] = header.substr(colon + 2);
    }
    if (const auto at = question.headers.find("content-length"); at != question.headers.end()) length = std::stoul(at->second);
  }
  question.body = text.substr(end + 4, length);
  return question;
}

void sendAll(int connection, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const auto count = ::send(connection, text.data() + done, text.size() - done, MSG_NOSIGNAL);
    if (count <= 0) return;
    done += static_cast<std::size_t>(count);
  }
}

std::string textOf(const ServerAnswer& answer, bool closes = true) {
  std::string text = "HTTP/1.1 " + std::to_string(answer.status) + " Said\r\nX-Experience-API-Version: 1.0.3\r\n";
  for (const std::string& header : answer.headers) text += header + "\r\n";
  if (answer.status != 204) text += "Content-Length: " + std::to_string(answer.body.size()) + "\r\n";
  return text + (closes ? "Connection: close" : "Connection: keep-alive") + "\r\n\r\n" + answer.body;
}

void waitUntilTheyGiveUp(int connection) {
  pollfd waiting{connection, POLLRDHUP, 0};
  ::poll(&waiting, 1, 20'000);
}

}  // namespace

RecordServer::RecordServer() { listen(); }

RecordServer::~RecordServer() { goAway(); }

void RecordServer::listen() {
  listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const int yes = 1;
  ::setsockopt(listener_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(static_cast<std::uint16_t>(port_));
  if (::bind(listener_, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0 || ::listen(listener_, 16) != 0) std::abort();
  socklen_t size = sizeof address;
  ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
  port_ = ntohs(address.sin_port);
  stops_ = false;
  isAway_ = false;
  thread_ = std::thread([this] { serve(); });
}

void RecordServer::goAway() {
  stops_ = true;
  if (thread_.joinable()) thread_.join();
  if (listener_ >= 0) ::close(listener_);
  listener_ = -1;
}

void RecordServer::comeBack() {
  if (listener_ >= 0 && !isAway_) return;
  goAway();
  listen();
}

void RecordServer::serve() {
  while (!stops_ && !isAway_) {
    pollfd waiting{listener_, POLLIN, 0};
    if (::poll(&waiting, 1, 10) <= 0) continue;
    const int connection = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
    if (connection < 0) continue;
    ++connections_;
    while (talk(connection)) {
    }
    ::shutdown(connection, SHUT_WR);
    ::close(connection);
  }
  if (isAway_) {
    ::close(listener_);
    listener_ = -1;
  }
}

/// @return whether there may be another question
bool RecordServer::talk(int connection) {
  const auto question = readQuestion(connection);
  if (!question) return false;
  {
    const std::lock_guard lock(mutex_);
    questions_.push_back(*question);
  }
  const Fault what = fault.with([&](const auto& ask) { return ask ? ask(*question) : Fault::none; });
  std::vector<std::string> busy;
  retryAfter.with([&](const std::string& after) {
    if (!after.empty()) busy.push_back("Retry-After: " + after);
  });
  if (what == Fault::goAway) isAway_ = true;
  if (what == Fault::closeBeforeTaking || what == Fault::goAway) return false;
  const auto only = [&](const ServerAnswer& answer) {
    sendAll(connection, textOf(answer));
    return false;
  };
  if (what == Fault::silence) {
    waitUntilTheyGiveUp(connection);
    return false;
  }
  if (what == Fault::busy429) return only({429, "slow down", busy});
  if (what == Fault::busy503) return only({503, "{\"message\": \"maintenance\"}", busy});
  if (what == Fault::failBefore) return only({500, "oops", {}});
  if (what == Fault::otherPage) return only({200, "<html><h1>Log in</h1></html>", {}});
  bool tookSomething = false;
  ServerAnswer answer = answerTo(*question, tookSomething);
  if (tookSomething)
    taken.with([](const auto& then) {
      if (then) then();
    });
  if (what == Fault::closeAfterTaking) return false;
  if (what == Fault::failAfter) answer = {500, "oops", {}};
  const std::string text = textOf(answer, !keepsConnections);
  sendAll(connection, what == Fault::halfAnswer ? text.substr(0, text.size() / 2) : text);
  if (what == Fault::answerTwice) sendAll(connection, text);
  return keepsConnections && what == Fault::none;
}

ServerAnswer RecordServer::answerTo(const ServerQuestion& question, bool& tookSomething) {
  if (auto answer = other.with([&](const auto& ask) { return ask ? ask(question) : std::nullopt; })) return *answer;
  const std::lock_guard lock(mutex_);
  const bool isKnown = authorization.with([&](const std::string& wanted) {
    return wanted.empty() || (question.headers.contains("authorization") && question.headers.at("authorization") == wanted);
  });
  if (!isKnown) return {401, "{\"message\": \"who are you\"}", {}};
  if (!question.headers.contains("x-experience-api-version")) return {400, "version is missing", {}};
  if (!question.target.starts_with("/xapi/statements")) return {404, "no such resource", {}};
  if (question.method == "GET") return mayBeRead ? find(question.target) : ServerAnswer{403, "not for you", {}};
  json list = json::parse(question.body, nullptr, false);
  const bool isPut = question.method == "PUT";
  if (isPut) list = json::array({list});
  if (!list.is_array()) return {400, "no list", {}};
  const std::size_t before = order_.size();
  const auto sum = [this] {
    int all = 0;
    for (const auto& [id, count] : arrivals_) all += count;
    return all;
  };
  const int stored = sum();
  ServerAnswer answer = take(list, isPut);
  tookSomething = order_.size() > before || sum() > stored;
  return answer;
}

ServerAnswer RecordServer::take(const json& list, bool isPut) {
  json ids = json::array();
  for (const json& each : list) {
    const std::string id = each.value("id", std::string());
    if (bad.with([&](const auto& wrong) { return wrong.contains(id); }))
      return {400, "{\"message\": \"The verb of " + id + " is not known here.\"}", {}};
    if (poison.with([&](const auto& wrong) { return wrong.contains(id); })) return {500, "{\"message\": \"a fault\"}", {}};
    const auto known = statements_.find(id);
    if (known != statements_.end() && (refusesWhatIsThere || known->second != each)) return {409, "{\"message\": \"conflict\"}", {}};
    if (voided_.contains(id)) return {409, "voided", {}};
    ids.push_back(id);
  }
  for (const json& each : list) {
    const std::string id = each["id"];
    const bool isThere = !statements_.emplace(id, each).second;
    if (isThere && knowsIds) continue;
    if (!isThere) order_.push_back(id);
    ++arrivals_[id];
  }
  if (isPut) return {204, "", {}};
  return {200, namesWhatItTook ? ids.dump() : "[]", {"Content-Type: application/json"}};
}

ServerAnswer RecordServer::find(const std::string& target) const {
  if (const std::string id = parameter(target, "voidedStatementId"); !id.empty())
    return voided_.contains(id) && statements_.contains(id) ? ServerAnswer{200, statements_.at(id).dump(), {}} : ServerAnswer{404, "", {}};
  if (const std::string id = parameter(target, "statementId"); !id.empty()) {
    if (!statements_.contains(id) || voided_.contains(id)) return {404, "", {}};
    json found = statements_.at(id);  // as servers hand it out: with what they add
    found["stored"] = "2026-11-26T12:00:00.000Z";
    found["authority"] = {{"objectType", "Agent"}, {"mbox", "mailto:store@example.org"}};
    return {200, found.dump(), {"Content-Type: application/json"}};
  }
  return {200, json({{"statements", json::array()}, {"more", ""}}).dump(), {}};
}

std::map<std::string, int> RecordServer::arrivals() const {
  const std::lock_guard lock(mutex_);
  return arrivals_;
}
std::vector<std::string> RecordServer::order() const {
  const std::lock_guard lock(mutex_);
  return order_;
}
json RecordServer::stored(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  const auto at = statements_.find(id);
  return at == statements_.end() ? json() : at->second;
}
void RecordServer::store(const json& statement) {
  const std::lock_guard lock(mutex_);
  statements_[statement["id"]] = statement;
  ++arrivals_[statement["id"].get<std::string>()];
  order_.push_back(statement["id"]);
}
void RecordServer::voidStatement(const std::string& id) {
  const std::lock_guard lock(mutex_);
  voided_.insert(id);
}
std::vector<ServerQuestion> RecordServer::questions() const {
  const std::lock_guard lock(mutex_);
  return questions_;
}
int RecordServer::writes() const {
  const auto all = questions();
  return static_cast<int>(std::count_if(all.begin(), all.end(), [](const ServerQuestion& each) { return each.writes(); }));
}

}  // namespace ew::test
