#include "ew/library/case_values.h"
#include "ew/core/word_table.h"
#include "ew/library/echoes_field.h"

namespace ew {

const std::string& titleForTrainees(const Case& shown) { return shown.titleForTrainees.empty() ? shown.title : shown.titleForTrainees; }

constexpr WordTable<CaseTarget::Kind, 3> kCaseTargetKindWords{
    {{"point", CaseTarget::Kind::point}, {"plane", CaseTarget::Kind::plane}, {"structure", CaseTarget::Kind::structure}}};
const char* nameOf(CaseTarget::Kind kind) { return wordIn(kCaseTargetKindWords, kind); }

bool hasNoVolume(const Case& opened) { return opened.volume.file.empty() && opened.volume.recipe.empty(); }

Case withoutEchoes(Case edited) {
  edited.otherFields.erase(kEchoesField);
  return edited;
}

}  // namespace ew
