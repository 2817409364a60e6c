#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/export/dicom_study.h"

namespace ew {

/// How far an object has come on its way to an archive.
enum class OutboxStatus {
  waiting,   ///< to be sent, perhaps again
  stored,    ///< the archive said it has it; it was not asked yet
  accepted,  ///< the archive said it has it, and takes no questions; our copy is gone, the note of it stays
  verified,  ///< the archive was asked afterwards and found it; our copy is gone, the note of it stays
  refused    ///< the archive will not have it; a person has to look at `problem`
};
[[nodiscard]] std::string_view wordOf(OutboxStatus status);

struct OutboxEntry {
  DicomReference object;
  std::string studyUid;
  std::string seriesUid;
  OutboxStatus status = OutboxStatus::waiting;
  int attempts = 0;
  std::string problem;  ///< of the last attempt, in English; empty: none
  bool operator==(const OutboxEntry&) const = default;
};

/// Objects on their way to one archive, in a folder of their own: UID.dcm is a copy of the object, UID.json where it stands. Only the owner
/// can read them. Each file is written complete or not at all, the copy before the note, so that after a crash or without a network nothing
/// is lost; an object keeps its identifier, and one that is here already, or was sent from here, is not taken again, so that nothing gets
/// there twice. One program at a time has the folder.
class Outbox {
 public:
  /// Makes the folder when it is not there, for its owner alone. A copy without a note counts as waiting; what cannot be read is left out
  /// and left where it is (unreadable()). @error notWritable (also when another program has it)
  [[nodiscard]] static Result<Outbox> open(const std::filesystem::path& folder);
  ~Outbox();
  Outbox(Outbox&&) noexcept;
  Outbox& operator=(Outbox&&) noexcept;

  /// Takes a copy of a DICOM file. @return false when the object is here already or was sent before
  /// @error notFound, notReadable, badHeader (no DICOM object with its identifiers, or bytes behind it), truncated, notWritable, what
  /// unreadable() says of its note
  [[nodiscard]] Result<bool> add(const std::filesystem::path& file);
  /// By identifier.
  [[nodiscard]] const std::vector<OutboxEntry>& entries() const;
  /// Notes and copies that lie here and cannot be read, each with its name and what to do.
  [[nodiscard]] std::vector<Error> unreadable() const;
  [[nodiscard]] std::size_t count(OutboxStatus status) const;
  [[nodiscard]] std::filesystem::path copyOf(const OutboxEntry& entry) const;
  /// Keeps where an object stands now; the copy of a verified or accepted one is removed. @error notWritable
  [[nodiscard]] Result<void> keep(const OutboxEntry& entry);
  /// Refused objects wait again. @error notWritable
  [[nodiscard]] Result<void> retryRefused();

 private:
  struct Parts;
  explicit Outbox(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

/// An application entity that stores objects.
struct DicomArchive {
  std::string host;
  int port = 104;
  std::string aeTitle;                   ///< of the archive, 1 to 16 characters
  std::string ownAeTitle = "ECHOWEAVE";  ///< what the archive knows this program by
  double timeout_s = 30.0;               ///< of the network, > 0
};

struct SendOptions {
  int mostRounds = 8;        ///< connections that are tried, >= 1
  double firstWait_s = 1.0;  ///< after the first one that failed; twice as long after each further one
  double longestWait_s = 300.0;
  /// Waits so long; false: stop. Empty: sleeps.
  std::function<bool(double seconds)> wait = {};
};

struct SendResult {
  std::size_t verified = 0;  ///< in this call
  std::size_t accepted = 0;  ///< in this call
  std::size_t refused = 0;   ///< in this call
  std::size_t left = 0;      ///< waiting, stored and not yet verified, or not readable
  int rounds = 0;
  Message problem;  ///< of the last round, then what cannot be read; empty: there was none
};

/// Sends what waits (C-STORE), and asks the archive afterwards for every object (C-FIND at IMAGE level); only what it finds counts as done.
/// An object that it said to have stored and does not find is sent again. Where connections fail or break it waits and tries again. Of an
/// archive that takes no questions (gateways do not, others refuse them) its word counts: what it said to have stored is accepted.
/// @error badField (host, port or title), notWritable (the outbox), cancelled
[[nodiscard]] Result<SendResult> sendOutbox(Outbox& outbox, const DicomArchive& archive, const SendOptions& options = {},
                                            Progress& progress = noProgress());

/// Asks an archive whether it is there and talks to this program (C-ECHO). @error badField, notReadable (no, and why), cancelled
[[nodiscard]] Result<void> askArchive(const DicomArchive& archive, const Progress& progress = noProgress());

}  // namespace ew
