#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>
#include <thread>

#include "ew/records/statement_outbox.h"
#include "ew/records/xapi.h"
#include "http.h"
#include "iri.h"

namespace ew {
namespace {

using nlohmann::json;
using records::HttpAnswer;
using records::HttpTrouble;

/// How to go on after a question.
enum class Next {
  on,
  later,  ///< the server is away or busy
  stop    ///< a person has to change something, or to ask later
};

enum class There { yes, no, other, mayNotRead, unknown };

bool isBusy(long status) { return status == 408 || status == 429 || status >= 500; }

class StatementSender {
 public:
  StatementSender(StatementOutbox& outbox, const RecordStore& store, const SendStatementsOptions& options, Progress& progress)
      : outbox_(outbox),
        store_(store),
        options_(options),
        progress_(progress),
        client_(store),
        secrets_(records::secretsIn(store.authorization)) {}
  Result<SendStatementsResult> run();

 private:
  Result<Next> round();
  std::vector<std::string> nextBatch();
  Result<Next> deliver(std::vector<std::string> ids);
  Result<Next> judge(const std::vector<std::string>& ids, const HttpAnswer& answer);
  Result<Next> oneByOne(const std::vector<std::string>& ids);
  Result<Next> put(const std::string& id);
  Result<Next> settleConflict(const std::string& id, const std::string& words);
  Result<Next> settleDoubts(std::vector<std::string>& ids);
  There askFor(const std::string& id, Next& next);
  Next failed(const records::HttpFailure& failure);
  Next refusesUs(const HttpAnswer& answer);
  Result<Next> refuse(const std::string& id, const std::string& words);
  Result<Next> arrived(const std::vector<std::string>& ids);
  bool waitFor(double seconds) const;
  std::string words(const HttpAnswer& answer) const;

  StatementOutbox& outbox_;
  const RecordStore& store_;
  const SendStatementsOptions& options_;
  Progress& progress_;
  records::HttpClient client_;
  std::vector<std::string> secrets_;
  SendStatementsResult result_;
  std::size_t whole_ = 0;
  double askedWait_s_ = 0.0;     // by the server, in this round
  bool isSingly_ = false;        // the server failed over several together
  bool isAway_ = false;          // no other statement would fare better
  std::set<std::string> tried_;  // in this round
  bool isCancelled_ = false;
};

std::string StatementSender::words(const HttpAnswer& answer) const {
  const std::string said = records::wordsOf(answer, secrets_);
  return std::to_string(answer.status) + (said.empty() ? "" : " " + said);
}

/// No answer. What was sent stays doubtful unless it is certain that nothing got there.
Next StatementSender::failed(const records::HttpFailure& failure) {
  isCancelled_ = failure.trouble == HttpTrouble::cancelled;
  isAway_ = true;
  const std::string why = records::tamed(failure.why, secrets_);
  if (failure.trouble == HttpTrouble::untrusted) {
    result_.problem = say<"The record store %1 cannot prove who it is (%2); nothing was sent. Check the address and the certificates.">(
        store_.endpoint, verbatim(why));
    return Next::stop;
  }
  result_.problem = say<"The record store %1 cannot be reached (%2).">(store_.endpoint, verbatim(why));
  return isCancelled_ ? Next::stop : Next::later;
}

/// An answer that is neither yes nor about a statement.
Next StatementSender::refusesUs(const HttpAnswer& answer) {
  if (isBusy(answer.status)) {
    askedWait_s_ = std::max(askedWait_s_, records::waitAskedFor_s(answer));
    isAway_ = isAway_ || answer.status != 500;
    result_.problem = say<"The record store %1 is busy or fails (%2).">(store_.endpoint, verbatim(words(answer)));
    return Next::later;
  }
  if (answer.status == 401 || answer.status == 403)
    result_.problem =
        say<"The record store %1 does not accept user and password (%2); check the settings.">(store_.endpoint, verbatim(words(answer)));
  else if (answer.status >= 300 && answer.status < 400)
    result_.problem =
        say<"The record store %1 sends us elsewhere (%2); passwords are not sent on, so put the final address in the settings.">(
            store_.endpoint, verbatim(std::to_string(answer.status)));
  else
    result_.problem =
        say<"What answers at %1 does not act like a record store (%2); check the address.">(store_.endpoint, verbatim(words(answer)));
  return Next::stop;
}

Result<Next> StatementSender::arrived(const std::vector<std::string>& ids) {
  if (auto kept = outbox_.keepSent(ids); !kept) return passOn(kept.error());
  result_.sent += ids.size();
  progress_.report(say<"Sending statements">(),
                   whole_ > 0 ? static_cast<double>(result_.sent + result_.refused) / static_cast<double>(whole_) : 1.0);
  return Next::on;
}

Result<Next> StatementSender::refuse(const std::string& id, const std::string& why) {
  if (auto kept = outbox_.keepRefused(id, why); !kept) return passOn(kept.error());
  ++result_.refused;
  return Next::on;
}

/// Whether the server has a statement. @param next how to go on when that is not known
There StatementSender::askFor(const std::string& id, Next& next) {
  for (const char* name : {"statementId", "voidedStatementId"}) {
    const auto answer = client_.ask(records::questionFor(store_, "GET", std::string("statements?") + name + "=" + id), progress_);
    if (!answer) {
      next = failed(answer.error());
      return There::unknown;
    }
    if (answer->status == 401 || answer->status == 403) return There::mayNotRead;
    if (answer->status == 404) continue;
    const auto theirs = json::parse(answer->body, nullptr, false);
    if (answer->status != 200 || !theirs.is_object() || !theirs.contains("verb")) {
      next = refusesUs(*answer);
      return There::unknown;
    }
    const auto text = outbox_.textOf(id);
    return text && saysTheSame(json::parse(*text, nullptr, false), theirs) ? There::yes : There::other;
  }
  return There::no;
}

/// Asks for each that is doubtful; those that are not there stay in `ids`.
Result<Next> StatementSender::settleDoubts(std::vector<std::string>& ids) {
  std::vector<std::string> left;
  for (const std::string& id : ids) {
    const auto& entries = outbox_.entries();
    const auto entry = std::find_if(entries.begin(), entries.end(), [&](const StatementEntry& each) { return each.id == id; });
    if (entry == entries.end() || entry->status != StatementStatus::doubtful) {
      left.push_back(id);
      continue;
    }
    Next next = Next::on;
    const There there = askFor(id, next);
    if (there == There::unknown) return next;
    Result<Next> settled = Next::on;
    if (there == There::yes) settled = arrived({id});
    if (there == There::other) settled = refuse(id, "The server has another statement with this id.");
    if (!settled) return settled;
    if (there == There::no || there == There::mayNotRead) left.push_back(id);
  }
  ids = std::move(left);
  return Next::on;
}

Result<Next> StatementSender::settleConflict(const std::string& id, const std::string& why) {
  Next next = Next::on;
  switch (askFor(id, next)) {
    case There::yes:
      return arrived({id});
    case There::unknown:
      return next;
    case There::other:
      return refuse(id, "The server has another statement with this id (" + why + ").");
    default:
      return refuse(id, why);
  }
}

Result<Next> StatementSender::put(const std::string& id) {
  const auto text = outbox_.textOf(id);
  if (!text) return refuse(id, text.error().sentence());
  if (auto announced = outbox_.announce({id}); !announced) return passOn(announced.error());
  const auto answer = client_.ask(records::questionFor(store_, "PUT", "statements?statementId=" + id, *text), progress_);
  if (!answer) {
    if (answer.error().trouble == HttpTrouble::unreachable || answer.error().trouble == HttpTrouble::untrusted) outbox_.withdraw({id});
    return failed(answer.error());
  }
  const long status = answer->status;
  if (status == 204) return arrived({id});
  if (status == 409) return settleConflict(id, words(*answer));
  if (status == 200) {  // not what PUT answers: a server of its own mind, or a page of a network that wants a login
    std::vector<std::string> left = {id};
    if (auto settled = settleDoubts(left); !settled || *settled != Next::on) return settled;
    return left.empty() ? Next::on : refusesUs(*answer);
  }
  if (status == 400 || status == 413 || status == 422) return refuse(id, words(*answer));
  return refusesUs(*answer);
}

/// A statement over which the server itself fails does not hold up the others; a server that is away or busy does.
Result<Next> StatementSender::oneByOne(const std::vector<std::string>& ids) {
  Next worst = Next::on;
  for (const std::string& id : ids) {
    std::vector<std::string> one = {id};
    if (auto settled = settleDoubts(one); !settled || *settled == Next::stop || isAway_) return settled;
    if (one.empty()) continue;
    const auto next = put(id);
    if (!next || *next == Next::stop || isAway_) return next;
    if (*next == Next::later) worst = Next::later;
  }
  return worst;
}

Result<Next> StatementSender::judge(const std::vector<std::string>& ids, const HttpAnswer& answer) {
  if (answer.status == 400 || answer.status == 409 || answer.status == 413 || answer.status == 422) {
    outbox_.withdraw(ids);  // of several none is kept when one is refused (Part Three, 2.1.2)
    return oneByOne(ids);
  }
  if (answer.status != 200 && answer.status != 204) {
    isSingly_ = isSingly_ || answer.status == 500;
    return refusesUs(answer);
  }
  const auto list = json::parse(answer.body, nullptr, false);
  std::vector<std::string> named;
  if (list.is_array())
    for (const json& each : list)
      if (each.is_string()) named.push_back(each.get<std::string>());
  const auto isNamed = [&](const std::string& id) { return std::find(named.begin(), named.end(), id) != named.end(); };
  if (std::all_of(ids.begin(), ids.end(), isNamed)) return arrived(ids);
  // It says yes without naming what it took: a server of its own mind, or a page of a network that wants a login.
  std::vector<std::string> left = ids;
  if (auto settled = settleDoubts(left); !settled || *settled != Next::on) return settled;
  return left.empty() ? Next::on : refusesUs(answer);
}

Result<Next> StatementSender::deliver(std::vector<std::string> ids) {
  if (auto settled = settleDoubts(ids); !settled || *settled != Next::on) return settled;
  if (ids.empty()) return Next::on;
  if (isSingly_) return oneByOne(ids);
  std::string body = "[";
  std::vector<std::string> whole;
  for (const std::string& id : ids) {
    const auto text = outbox_.textOf(id);
    if (!text || !json::accept(*text)) {
      if (auto kept = refuse(id, text ? "The file in the outbox is damaged." : text.error().sentence()); !kept) return kept;
      continue;
    }
    body += (whole.empty() ? "" : ",") + *text;
    whole.push_back(id);
  }
  if (whole.empty()) return Next::on;
  if (auto announced = outbox_.announce(whole); !announced) return passOn(announced.error());
  const auto answer = client_.ask(records::questionFor(store_, "POST", "statements", body + "]"), progress_);
  if (answer) return judge(whole, *answer);
  if (answer.error().trouble == HttpTrouble::unreachable || answer.error().trouble == HttpTrouble::untrusted) outbox_.withdraw(whole);
  return failed(answer.error());
}

/// The next statements that go together, of those that were not tried in this round.
std::vector<std::string> StatementSender::nextBatch() {
  std::vector<std::string> ids;
  std::size_t bytes = 0;
  for (const StatementEntry& entry : outbox_.entries()) {
    if (ids.size() >= options_.mostTogether) break;
    if (entry.status == StatementStatus::refused || tried_.contains(entry.id)) continue;
    const auto text = outbox_.textOf(entry.id);
    bytes += text ? text->size() : 0;
    if (!ids.empty() && bytes > options_.mostTogether_bytes) break;
    ids.push_back(entry.id);
  }
  tried_.insert(ids.begin(), ids.end());
  return ids;
}

Result<Next> StatementSender::round() {
  ++result_.rounds;
  askedWait_s_ = 0.0;
  isAway_ = false;
  tried_.clear();
  Next worst = Next::on;
  for (;;) {
    isCancelled_ = progress_.cancelRequested();
    if (isCancelled_) return Next::stop;
    const auto ids = nextBatch();
    if (ids.empty()) return worst;
    const bool wasSingly = isSingly_;
    const auto next = deliver(ids);
    if (!next || *next == Next::stop) return next;
    if (*next == Next::later && (isAway_ || !wasSingly)) return next;
    if (*next == Next::later) worst = Next::later;
  }
}

bool StatementSender::waitFor(double seconds) const {
  if (options_.wait) return options_.wait(seconds);
  const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (std::chrono::steady_clock::now() < until) {
    if (progress_.cancelRequested()) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return true;
}

Result<SendStatementsResult> StatementSender::run() {
  whole_ = outbox_.entries().size() - outbox_.count(StatementStatus::refused);
  for (int inVain = 0;;) {
    const std::size_t before = result_.sent + result_.refused;
    const auto next = round();
    if (!next) return passOn(next.error());
    if (*next == Next::on) result_.problem = {};
    if (*next != Next::later) break;
    inVain = result_.sent + result_.refused > before ? 1 : inVain + 1;
    if (inVain >= options_.mostRounds) break;
    if (askedWait_s_ > options_.longestWait_s) {
      result_.problem = say<"The record store %1 asks to be left alone for %2 s; send again after that.">(
          store_.endpoint, static_cast<long long>(std::ceil(std::min(askedWait_s_, 1e9))));
      break;
    }
    const double wait_s = std::min(options_.firstWait_s * std::pow(2.0, inVain - 1), options_.longestWait_s);
    isCancelled_ = !waitFor(std::max(wait_s, askedWait_s_));
    if (isCancelled_) break;
  }
  if (isCancelled_) return failure(ErrorCode::cancelled, say<"Stopped as asked; statements that were not sent yet stay in the outbox.">());
  result_.left = outbox_.entries().size() - outbox_.count(StatementStatus::refused);
  return result_;
}

}  // namespace

Result<SendStatementsResult> sendStatements(StatementOutbox& outbox, const RecordStore& store, const SendStatementsOptions& options,
                                            Progress& progress) {
  RecordStore checked = store;
  auto endpoint = records::safeEndpoint(store.endpoint, store.allowsHttp, say<"The record store's address">());
  if (!endpoint) return passOn(endpoint.error());
  checked.endpoint = *endpoint;
  if (options.mostTogether < 1 || options.mostRounds < 1 || !(store.timeout_s > 0.0) || !(store.connect_s > 0.0))
    return failure(ErrorCode::badField,
                   say<"The limits of sending must be at least 1 statement, 1 round and more than 0 s; check them.">());
  return StatementSender(outbox, checked, options, progress).run();
}

}  // namespace ew
