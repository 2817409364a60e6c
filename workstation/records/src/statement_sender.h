#pragma once

#include <set>
#include <string>
#include <vector>

#include "ew/records/statement_outbox.h"
#include "http.h"

namespace ew::records {

/// How to go on after a question.
enum class Next {
  on,
  later,  ///< the server is away or busy
  stop    ///< a person has to change something, or to ask later
};

enum class There { yes, no, other, mayNotRead, unknown };

/// One call of sendStatements().
class StatementSender {
 public:
  StatementSender(StatementOutbox& outbox, const RecordStore& store, const SendStatementsOptions& options, Progress& progress)
      : outbox_(outbox), store_(store), options_(options), progress_(progress), client_(store), secrets_(secretsIn(store.authorization)) {}
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
  Next failed(const HttpFailure& failure);
  Next refusesUs(const HttpAnswer& answer);
  Result<Next> refuse(const std::string& id, const std::string& words);
  Result<Next> arrived(const std::vector<std::string>& ids);
  std::string words(const HttpAnswer& answer) const;

  StatementOutbox& outbox_;
  const RecordStore& store_;
  const SendStatementsOptions& options_;
  Progress& progress_;
  HttpClient client_;
  std::vector<std::string> secrets_;
  SendStatementsResult result_;
  std::size_t whole_ = 0;
  double askedWait_s_ = 0.0;     // by the server, in this round
  bool isSingly_ = false;        // the server failed over several together
  bool isAway_ = false;          // no other statement would fare better
  std::set<std::string> tried_;  // in this round
  bool isCancelled_ = false;
};

}  // namespace ew::records
