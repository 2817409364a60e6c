#include <algorithm>
#include <cmath>

#include "ew/core/foreign_json.h"
#include "iri.h"
#include "statement_sender.h"

namespace ew {
namespace records {

using nlohmann::json;

/// A statement over which the server itself fails does not hold up the others; a server that is away or busy does.
Result<Next> StatementSender::oneByOne(const std::vector<std::string>& ids) {
  Next worst = Next::on;
  for (const std::string& id : ids) {
    std::vector<std::string> one = {id};
    if (auto settled = settleDoubts(one); !settled || *settled == Next::stop || isAway_) return settled;
    if (one.empty()) continue;
    auto next = put(id);
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
  const auto list = jsonOrNull(answer.body);
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
    if (!text || !jsonOrNull(*text).is_object()) {
      if (auto kept = refuse(id, text ? "The file in the outbox is damaged." : text.error().sentence()); !kept) return kept;
      continue;
    }
    body += (whole.empty() ? "" : ",") + *text;
    whole.push_back(id);
  }
  if (whole.empty()) return Next::on;
  if (auto announced = outbox_.announce(whole); !announced) return passOn(announced.error());
  const auto answer = client_.ask(questionFor(store_, "POST", "statements", body + "]"), progress_);
  if (answer) return judge(whole, *answer);
  if (answer.error().trouble == HttpTrouble::unreachable || answer.error().trouble == HttpTrouble::untrusted) outbox_.withdraw(whole);
  return failed(answer.error());
}

/// The next statements that go together, of those that were not tried in this round.
std::vector<std::string> StatementSender::nextBatch() {
  std::vector<std::string> ids;
  std::size_t bytes = 0;
  for (const OutboxEntry& entry : outbox_.entries()) {
    if (ids.size() >= options_.mostTogether) break;
    if (entry.status == OutboxStatus::refused || tried_.contains(entry.id)) continue;
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
    auto next = deliver(ids);
    if (!next || *next == Next::stop) return next;
    if (*next == Next::later && (isAway_ || !wasSingly)) return next;
    if (*next == Next::later) worst = Next::later;
  }
}

Result<SendStatementsResult> StatementSender::run() {
  whole_ = outbox_.entries().size() - outbox_.count(OutboxStatus::refused);
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
    isCancelled_ = !options_.waitFor(std::max(options_.waitAfter_s(inVain), askedWait_s_), progress_);
    if (isCancelled_) break;
  }
  if (isCancelled_) return failure(ErrorCode::cancelled, say<"Stopped as asked; statements that were not sent yet stay in the outbox.">());
  result_.left = outbox_.entries().size() - outbox_.count(OutboxStatus::refused);
  return result_;
}

}  // namespace records

Result<SendStatementsResult> sendStatements(StatementOutbox& outbox, const RecordStore& store, const SendStatementsOptions& options,
                                            Progress& progress) {
  RecordStore checked = store;
  auto endpoint = records::safeEndpoint(store.endpoint, store.allowsHttp, say<"The record store's address">());
  if (!endpoint) return passOn(endpoint.error());
  checked.endpoint = *endpoint;
  if (options.mostTogether < 1 || options.mostRounds < 1 || !(store.timeout_s > 0.0) || !(store.connect_s > 0.0))
    return failure(ErrorCode::badField,
                   say<"The limits of sending must be at least 1 statement, 1 round and more than 0 s; check them.">());
  return records::StatementSender(outbox, checked, options, progress).run();
}

}  // namespace ew
