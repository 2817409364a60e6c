#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"

namespace ew {

/// How far something has come on its way.
enum class OutboxStatus {
  waiting,   ///< to be sent, perhaps again
  doubtful,  ///< was being sent when the connection or the program ended: the receiver is asked before it is sent again
  stored,    ///< the receiver said it has it; it was not asked yet
  accepted,  ///< the receiver said it has it, and takes no questions; our copy is gone, the note of it stays
  verified,  ///< the receiver was asked afterwards and found it; our copy is gone, the note of it stays
  arrived,   ///< the same, and nothing but its id is remembered: it is no entry any more
  refused    ///< the receiver will not have it; a person has to look at `problem`
};
[[nodiscard]] std::string_view wordOf(OutboxStatus status);
[[nodiscard]] std::optional<OutboxStatus> outboxStatusOf(std::string_view word);

struct OutboxEntry {
  std::string id;
  OutboxStatus status = OutboxStatus::waiting;
  int attempts = 0;
  std::string problem = {};                       ///< of the last attempt, in the receiver's words; empty: none
  std::map<std::string, std::string> about = {};  ///< what its sender has to know of it, by name; may be empty
  bool operator==(const OutboxEntry&) const = default;
};

/// What `about` says by that name; empty: nothing.
[[nodiscard]] std::string aboutOf(const OutboxEntry& entry, const std::string& name);

/// What versions before the notes have left in the folder of an outbox.
struct EarlierNotes {
  std::vector<OutboxEntry> entries;
  std::map<std::string, Error> unreadable;   ///< by id; they stay, and nobody knows how far theirs has come
  std::vector<std::filesystem::path> files;  ///< they go once the entries are noted
};

/// What an outbox is for.
struct OutboxKind {
  std::string ending;                                                           ///< of the copies, with its dot
  bool isNumbered = false;                                                      ///< order: as they were taken; else by id
  bool (*isId)(std::string_view text) = nullptr;                                ///< names of files that are none are somebody else's
  Result<OutboxEntry> (*entryOf)(const std::filesystem::path& copy) = nullptr;  ///< of one without a note; null: its id is all
  Result<EarlierNotes> (*earlierNotes)(const std::filesystem::path& folder) = nullptr;  ///< null: there were none
};

/// Things on their way to one receiver, in a folder of their own that only its owner reads: a copy of each (ID and ending, with a number
/// before it where the order counts) and `notes`, a line for every change of where one stands, the latest last. Each is on the disk before
/// it is relied on: the copy before its note, the note before a copy is removed. So after a crash or without a network nothing is lost, and
/// what has one id is never taken twice, also after it was sent. What was refused and whose copy somebody has deleted is given up: it is no
/// entry any more, and may be added again. One program at a time has the folder.
class Outbox {
 public:
  /// Makes the folder when it is not there, for its owner alone. A copy without a note counts as waiting; what cannot be read is left out
  /// and left where it is (unreadable()).
  /// @error notWritable (also when another program has it, or it cannot be listed), newerFormat, notReadable (the notes, or what is called
  /// so)
  [[nodiscard]] static Result<Outbox> open(const std::filesystem::path& folder, const OutboxKind& kind);
  ~Outbox();
  Outbox(Outbox&&) noexcept;
  Outbox& operator=(Outbox&&) noexcept;

  [[nodiscard]] const std::vector<OutboxEntry>& entries() const;
  [[nodiscard]] const OutboxEntry* find(const std::string& id) const;  ///< null: it is not here, or has arrived
  [[nodiscard]] std::size_t count(OutboxStatus status) const;
  /// Notes and copies that lie here and cannot be read, each with its name and what to do.
  [[nodiscard]] std::vector<Error> unreadable() const;
  /// That notes were damaged when it was opened, and what to do. Their lines are kept in a file beside the notes, so that the next one who
  /// opens it is not told again. Empty: they were whole.
  [[nodiscard]] const std::optional<Message>& damage() const;
  [[nodiscard]] std::filesystem::path copyOf(const OutboxEntry& entry) const;

  /// Whether it is here or was sent before.
  [[nodiscard]] bool knows(const std::string& id) const;
  /// Takes something. @param write puts the copy into the stream @return false when its id is here already or was sent before
  /// @error notWritable, what unreadable() says of it, as `write`
  [[nodiscard]] Result<bool> add(const OutboxEntry& entry, const std::function<Result<void>(std::ostream&)>& write);
  /// Keeps where entries stand now, all of them or none; the copies of those that got there are removed. @error notWritable
  [[nodiscard]] Result<void> keep(const std::vector<OutboxEntry>& changed);
  [[nodiscard]] Result<void> keep(const OutboxEntry& changed) { return keep(std::vector<OutboxEntry>{changed}); }
  /// The same of those that are here, by their ids.
  [[nodiscard]] Result<void> keep(const std::vector<std::string>& ids, OutboxStatus status);
  /// Refused ones wait again. @error notWritable
  [[nodiscard]] Result<void> retryRefused();

 private:
  struct Parts;
  explicit Outbox(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

/// How often something is tried, and how long it is waited between.
struct RetryOptions {
  int mostRounds = 8;            ///< connections that are tried, >= 1
  double firstWait_s = 1.0;      ///< after the first one that failed; twice as long after each further one
  double longestWait_s = 300.0;  ///< at most
  /// Waits so long; false: stop. Empty: sleeps, and looks at `progress` meanwhile.
  std::function<bool(double seconds)> wait = {};

  /// @param failed rounds in a row, >= 1
  [[nodiscard]] double waitAfter_s(int failed) const;
  /// @return whether to go on
  [[nodiscard]] bool waitFor(double seconds, const Progress& progress) const;
};

}  // namespace ew
