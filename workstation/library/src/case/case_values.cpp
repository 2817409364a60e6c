#include "ew/library/case_values.h"
#include "ew/library/echoes_field.h"

namespace ew {

const std::string& titleForTrainees(const Case& shown) { return shown.titleForTrainees.empty() ? shown.title : shown.titleForTrainees; }

const char* nameOf(CaseTarget::Kind kind) {
  switch (kind) {
    case CaseTarget::Kind::point:
      return "point";
    case CaseTarget::Kind::plane:
      return "plane";
    case CaseTarget::Kind::structure:
      return "structure";
  }
  return "";
}

bool hasNoVolume(const Case& opened) { return opened.volume.file.empty() && opened.volume.recipe.empty(); }

Case withoutEchoes(Case edited) {
  edited.otherFields.erase(kEchoesField);
  return edited;
}

}  // namespace ew
