#include "ew/library/edit_autosave.h"

#include <optional>
#include <utility>

namespace ew {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFile = "case-edits.json";

std::optional<EditAutosave::Left> editsIn(OwnFolder::Left left) {
  const auto place = left.note.find("case_folder"), manifest = left.note.find("manifest"), size = left.note.find("read_bytes"),
             hash = left.note.find("read_hash");
  const auto end = left.note.end();
  if (place == end || !place->is_string() || manifest == end || !manifest->is_object() || size == end || !size->is_number_unsigned() ||
      hash == end || !hash->is_number_unsigned())
    return std::nullopt;
  return EditAutosave::Left{std::move(left.folder),
                            place->get<std::string>(),
                            std::move(*manifest),
                            {size->get<std::uint64_t>(), hash->get<std::uint64_t>()},
                            systemTimeOf(left.written)};
}

}  // namespace

EditAutosave::EditAutosave(fs::path root) : own_(std::move(root)) {}

EditAutosave::~EditAutosave() { forget(); }

Result<void> EditAutosave::keep(const Case& edited, const Fingerprint& asRead) {
  if (const std::string problem = own_.make(); !problem.empty())
    return failure(ErrorCode::notWritable,
                   say<"Unsaved changes of the case cannot be kept in '%1' (%2), so a crash would lose them; save the case often.">(
                       own_.root(), problem),
                   {{"folder", own_.root().string()}});
  return own_.writeNote(kFile, {{"case_folder", edited.folder.string()},
                                {"manifest", manifestOf(edited)},
                                {"read_bytes", asRead.size_bytes},
                                {"read_hash", asRead.hash}});
}

void EditAutosave::forget() { own_.remove(); }

std::vector<EditAutosave::Left> EditAutosave::left() const {
  std::vector<Left> found;
  for (OwnFolder::Left& each : own_.leftWith(kFile))
    if (auto left = editsIn(std::move(each))) found.push_back(std::move(*left));
  return found;
}

void EditAutosave::remove(const Left& decided) { OwnFolder::discard(decided.kept, {kFile}); }

}  // namespace ew
