#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/io/outbox.h"
#include "ew/records/record_store.h"

namespace ew {

/// Statements on their way to one record store (ew/io/outbox.h), in the order they were taken. The id of each that arrived is remembered
/// for ever, so that what has one id is never taken twice.
class StatementOutbox : public Outbox {
 public:
  /// As Outbox::open. The lists of earlier versions (`sending`, `sent`, ID.refused) are taken over.
  [[nodiscard]] static Result<StatementOutbox> open(const std::filesystem::path& folder);

  /// @return false when one with this id is here already or was sent before: the first word stands
  /// @error badField (no UUID for an id, no actor, verb or object, not UTF-8), tooLarge, notWritable
  [[nodiscard]] Result<bool> add(const nlohmann::json& statement);
  /// A statement as it was taken, byte for byte as it is sent. @error notFound, notReadable
  [[nodiscard]] Result<std::string> textOf(const std::string& id) const;

  /// Notes that these are about to be sent: from now on they are doubtful, also after a crash. @error notWritable
  [[nodiscard]] Result<void> announce(const std::vector<std::string>& ids) { return keep(ids, OutboxStatus::doubtful); }
  /// They did not get there after all, as is certain: they wait.
  void withdraw(const std::vector<std::string>& ids);
  /// They arrived. @error notWritable
  [[nodiscard]] Result<void> keepSent(const std::vector<std::string>& ids) { return keep(ids, OutboxStatus::arrived); }
  /// @error notWritable
  [[nodiscard]] Result<void> keepRefused(const std::string& id, const std::string& problem);

 private:
  explicit StatementOutbox(Outbox&& outbox) : Outbox(std::move(outbox)) {}
};

/// Rounds are those in a row that bring nothing new. A server that asks for a longer wait than the longest ends the call.
struct SendStatementsOptions : RetryOptions {
  std::size_t mostTogether = 50;  ///< statements in one question, >= 1
  std::size_t mostTogether_bytes = 512u << 10;
};

struct SendStatementsResult {
  std::size_t sent = 0;     ///< arrived in this call, or found there
  std::size_t refused = 0;  ///< in this call
  std::size_t left = 0;     ///< waiting or doubtful
  int rounds = 0;
  Message problem;  ///< why something is left; empty: nothing is
};

/// Sends what waits, in order (POST, several at a time). What a server says it has counts as arrived. A doubtful statement is asked for by
/// its id first. Of several of which one is refused (400, 409, 413) each is sent by itself (PUT), so that one does not hold up the others;
/// one that is there already and says the same counts as arrived, one that says something else as refused. A server that is away or busy
/// (no connection, 408, 429, 5xx) is tried again after growing waits, and not before it asks for (Retry-After). A server that does not let
/// us in, that sends us elsewhere, that cannot prove who it is or that is no record store ends the call.
/// @error badField (endpoint or limits), notWritable (the outbox), cancelled (within 0.5 s)
[[nodiscard]] Result<SendStatementsResult> sendStatements(StatementOutbox& outbox, const RecordStore& store,
                                                          const SendStatementsOptions& options = {}, Progress& progress = noProgress());

}  // namespace ew
