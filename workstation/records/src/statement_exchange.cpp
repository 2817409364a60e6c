#include <algorithm>

#include "ew/core/foreign_json.h"
#include "ew/records/xapi.h"
#include "iri.h"
#include "statement_sender.h"

// What single questions and answers mean; when which is asked stands in statement_sending.cpp.

namespace ew::records {
namespace {

bool isBusy(long status) { return status == 408 || status == 429 || status >= 500; }

}  // namespace

std::string StatementSender::words(const HttpAnswer& answer) const {
  const std::string said = wordsOf(answer, secrets_);
  return std::to_string(answer.status) + (said.empty() ? "" : " " + said);
}

/// No answer. What was sent stays doubtful unless it is certain that nothing got there.
Next StatementSender::failed(const HttpFailure& failure) {
  isCancelled_ = failure.trouble == HttpTrouble::cancelled;
  isAway_ = true;
  const std::string why = tamed(failure.why, secrets_);
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
    askedWait_s_ = std::max(askedWait_s_, waitAskedFor_s(answer));
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
    const auto answer = client_.ask(questionFor(store_, "GET", std::string("statements?") + name + "=" + id), progress_);
    if (!answer) {
      next = failed(answer.error());
      return There::unknown;
    }
    if (answer->status == 401 || answer->status == 403) return There::mayNotRead;
    if (answer->status == 404) continue;
    const auto theirs = jsonOrNull(answer->body);
    if (answer->status != 200 || !theirs.is_object() || !theirs.contains("verb")) {
      next = refusesUs(*answer);
      return There::unknown;
    }
    const auto text = outbox_.textOf(id);
    return text && saysTheSame(jsonOrNull(*text), theirs) ? There::yes : There::other;
  }
  return There::no;
}

/// Asks for each that is doubtful; those that are not there stay in `ids`.
Result<Next> StatementSender::settleDoubts(std::vector<std::string>& ids) {
  std::vector<std::string> left;
  for (const std::string& id : ids) {
    const auto& entries = outbox_.entries();
    const auto entry = std::find_if(entries.begin(), entries.end(), [&](const OutboxEntry& each) { return each.id == id; });
    if (entry == entries.end() || entry->status != OutboxStatus::doubtful) {
      left.push_back(id);
      continue;
    }
    Next next = Next::on;
    const There there = askFor(id, next);
    if (there == There::unknown) return next;
    Result<Next> settled = Next::on;
    if (there == There::yes) settled = arrived({id});
    if (there == There::other) {
      const auto own = outbox_.textOf(id);  // without it nobody can say that the server's is another
      settled = refuse(id, own ? "The server has another statement with this id." : own.error().sentence());
    }
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
  const auto answer = client_.ask(questionFor(store_, "PUT", "statements?statementId=" + id, *text), progress_);
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

}  // namespace ew::records
