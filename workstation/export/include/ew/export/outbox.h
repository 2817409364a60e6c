#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/io/outbox.h"

namespace ew {

/// Objects on their way to one archive (ew/io/outbox.h): UID.dcm is a copy of each. An object keeps its identifier, so that nothing gets
/// there twice.
class DicomOutbox : public Outbox {
 public:
  /// As Outbox::open. The notes of earlier versions, a UID.json beside each copy, are taken over.
  [[nodiscard]] static Result<DicomOutbox> open(const std::filesystem::path& folder);
  /// Takes a copy of a DICOM file. @return false when the object is here already or was sent before
  /// @error notFound, notReadable, badHeader (no DICOM object with its identifiers, or bytes behind it), truncated, notWritable, what
  /// unreadable() says of its note
  [[nodiscard]] Result<bool> add(const std::filesystem::path& file);

 private:
  explicit DicomOutbox(Outbox&& outbox) : Outbox(std::move(outbox)) {}
};

// What an entry of it is about.
inline constexpr const char* kObjectClass = "class";
inline constexpr const char* kObjectStudy = "study";
inline constexpr const char* kObjectSeries = "series";

/// An application entity that stores objects.
struct DicomArchive {
  std::string host;
  int port = 104;
  std::string aeTitle;                   ///< of the archive, 1 to 16 characters
  std::string ownAeTitle = "ECHOWEAVE";  ///< what the archive knows this program by
  double timeout_s = 30.0;               ///< of the network, > 0
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
[[nodiscard]] Result<SendResult> sendOutbox(DicomOutbox& outbox, const DicomArchive& archive, const RetryOptions& options = {},
                                            Progress& progress = noProgress());

/// Asks an archive whether it is there and talks to this program (C-ECHO). @error badField, notReadable (no, and why), cancelled
[[nodiscard]] Result<void> askArchive(const DicomArchive& archive, const Progress& progress = noProgress());

}  // namespace ew
