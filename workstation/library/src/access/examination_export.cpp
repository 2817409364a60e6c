#include <cstdlib>

#include "ew/library/bundle.h"
#include "ew/library/kept_examination.h"
#include "ew/library/sealed_answers.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

/// A folder of this call's own beside a file that is to be written, of mode 0700, and gone afterwards: it is on the same medium, which has
/// to have the room anyway.
class FolderBeside {
 public:
  explicit FolderBeside(const fs::path& file) {
    std::error_code failed;
    std::string name = (fs::absolute(file, failed).parent_path() / ".ew-examination-XXXXXX").string();
    if (::mkdtemp(name.data()) != nullptr) path_ = name;
  }
  ~FolderBeside() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }
  FolderBeside(const FolderBeside&) = delete;
  FolderBeside& operator=(const FolderBeside&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

}  // namespace

Result<Examination> exportExamination(const fs::path& caseFolder, const fs::path& file, const ExaminationOptions& options,
                                      Progress& progress) {
  if (auto kept = keepsExamination(file); !kept) return passOn(kept.error());
  const FolderBeside beside(file);
  if (beside.path().empty())
    return failure(ErrorCode::notWritable, say<"Nothing can be written beside \"%1\"; choose another folder.">(file),
                   {{"file", file.string()}});
  PartOfProgress making(progress, 0.0, 0.8), exporting(progress, 0.8, 1.0);
  auto made = makeExamination(caseFolder, beside.path() / "examination", options, making);
  if (!made) return made;
  auto header = exportBundle(beside.path() / "examination", file, exporting);
  if (!header) return passOn(header.error());
  made->bundle = std::move(*header);
  return made;
}

}  // namespace ew
