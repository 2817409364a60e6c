#include "ew/library/bundle.h"
#include "ew/library/kept_examination.h"
#include "ew/library/sealed_answers.h"
#include "files/private_folder.h"

namespace ew {

namespace fs = std::filesystem;

Result<Examination> exportExamination(const fs::path& caseFolder, const fs::path& file, const ExaminationOptions& options,
                                      Progress& progress) {
  if (auto kept = keepsExamination(file); !kept) return passOn(kept.error());
  const auto beside = PrivateFolder::makeBeside(file);
  if (!beside)
    return failure(ErrorCode::notWritable, say<"Nothing can be written beside \"%1\"; choose another folder.">(file),
                   {{"file", file.string()}});
  PartOfProgress making(progress, 0.0, 0.8), exporting(progress, 0.8, 1.0);
  auto made = makeExamination(caseFolder, beside->path() / "examination", options, making);
  if (!made) return made;
  auto header = exportBundle(beside->path() / "examination", file, exporting);
  if (!header) return passOn(header.error());
  made->bundle = std::move(*header);
  return made;
}

}  // namespace ew
