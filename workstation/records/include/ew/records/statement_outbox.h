#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/records/record_store.h"

namespace ew {

/// Where a statement stands that has not arrived.
enum class StatementStatus {
  waiting,   ///< to be sent
  doubtful,  ///< was being sent when the connection or the program ended: the server is asked before it is sent again
  refused    ///< the server will not have it; a person has to look at `problem`
};
[[nodiscard]] std::string_view wordOf(StatementStatus status);

struct StatementEntry {
  std::string id;  ///< UUID in small letters
  StatementStatus status = StatementStatus::waiting;
  std::string problem;  ///< of one that was refused: the server's words
  bool operator==(const StatementEntry&) const = default;
};

/// Statements on their way to one record store, in a folder of their own that only its owner reads. NUMBER-ID.json is a statement, in the
/// order they were taken; ID.refused says why a server did not take one; `sending` names those that are being sent right now; `sent` has a
/// line for each that arrived. Each is on the disk before it is relied on, and a statement goes only after its line in `sent` is there: so
/// nothing is lost in a crash, and what has one id is never taken twice, also after it was sent. One program at a time has the folder.
class StatementOutbox {
 public:
  /// Makes the folder when it is not there. @error notWritable (also when another program has it), notReadable
  [[nodiscard]] static Result<StatementOutbox> open(const std::filesystem::path& folder);
  ~StatementOutbox();
  StatementOutbox(StatementOutbox&&) noexcept;
  StatementOutbox& operator=(StatementOutbox&&) noexcept;

  /// @return false when one with this id is here already or was sent before: the first word stands
  /// @error badField (no UUID for an id, no actor, verb or object, not UTF-8), tooLarge, notWritable
  [[nodiscard]] Result<bool> add(const nlohmann::json& statement);

  /// Those that have not arrived, in the order they were taken.
  [[nodiscard]] const std::vector<StatementEntry>& entries() const;
  [[nodiscard]] std::size_t count(StatementStatus status) const;
  /// How many arrived, ever.
  [[nodiscard]] std::size_t sentCount() const;
  /// A statement as it was taken, byte for byte as it is sent. @error notFound, notReadable
  [[nodiscard]] Result<std::string> textOf(const std::string& id) const;

  /// Notes that these are about to be sent: from now on they are doubtful, also after a crash. @error notWritable
  [[nodiscard]] Result<void> announce(const std::vector<std::string>& ids);
  /// They did not get there after all, as is certain: they wait.
  void withdraw(const std::vector<std::string>& ids);
  /// They arrived. @error notWritable
  [[nodiscard]] Result<void> keepSent(const std::vector<std::string>& ids);
  /// @error notWritable
  [[nodiscard]] Result<void> keepRefused(const std::string& id, const std::string& problem);
  /// Refused statements wait again. @error notWritable
  [[nodiscard]] Result<void> retryRefused();

 private:
  struct Parts;
  explicit StatementOutbox(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

struct SendStatementsOptions {
  std::size_t mostTogether = 50;  ///< statements in one question, >= 1
  std::size_t mostTogether_bytes = 512u << 10;
  int mostRounds = 8;            ///< in a row that bring nothing new, >= 1
  double firstWait_s = 1.0;      ///< after the first such round; twice as long after each further one
  double longestWait_s = 300.0;  ///< a server that asks for a longer one ends the call
  /// Waits so long; false: stop. Empty: sleeps, and looks at `progress` meanwhile.
  std::function<bool(double seconds)> wait = {};
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
