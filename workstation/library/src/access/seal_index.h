#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "access/trainee_view.h"
#include "case/outgoing_case.h"
#include "ew/library/sealed_answers.h"
#include "files/file_pieces.h"

namespace ew {

// What answers.sealed holds when it is open: the length of an index (8 bytes, the lowest first), the index, JSON, and the files of the case
// one after another. A file that trainees have to the byte is not there twice: the index says under which name they have it.

struct SealIndex {
  std::string caseId;
  std::string examinationId;
  std::map<std::string, OriginalLesson> lessons;
  std::vector<FileSum> files;                        ///< of the whole case, as filesOfCase
  std::map<std::string, std::string> amongTrainees;  ///< names by which trainees have them, by the case's own
};

/// @param there what trainees get, with sums
[[nodiscard]] SealIndex indexOf(const CaseToHandOn& from, const std::string& examinationId, const LessonsView& lessons,
                                const std::vector<FileSum>& there);

[[nodiscard]] std::uint64_t bytesToSeal(const SealIndex& index);

/// @error notReadable (a file was changed meanwhile), cancelled, of `put`
[[nodiscard]] Result<void> writeSealed(const SealIndex& index, const std::filesystem::path& caseFolder, ByteCount& count,
                                       const TakePiece& put);

/// Takes the content piece by piece and writes the files, each compared with its sum. What the index says is checked as what a stranger
/// sent: who sealed it is not known.
class ContentUnpacker {
 public:
  ContentUnpacker(std::filesystem::path examination, std::filesystem::path to, ByteCount& count)
      : examination_(std::move(examination)), to_(std::move(to)), count_(count) {}
  /// @error badField, newerFormat, tooLarge, notWritable
  [[nodiscard]] Result<void> take(std::span<const std::byte> piece);
  /// @error badField (something is missing)
  [[nodiscard]] Result<void> finish();
  [[nodiscard]] const SealIndex& index() const { return index_; }

 private:
  [[nodiscard]] Result<void> begin();     // the index is whole
  [[nodiscard]] Result<void> nextFile();  // that is to come from the stream; those that trainees have are copied
  [[nodiscard]] Result<void> copyFromTrainees(const FileSum& file);

  std::filesystem::path examination_, to_;
  ByteCount& count_;
  std::string head_;
  std::optional<std::uint64_t> indexLength_;
  bool hasIndex_ = false;
  SealIndex index_;
  std::size_t at_ = 0;
  std::optional<PieceWriter> out_;
  std::optional<Sha256> sum_;
  std::uint64_t left_ = 0;
};

}  // namespace ew
