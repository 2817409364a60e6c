#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ew/core/data_file.h"
#include "ew/core/result.h"
#include "ew/library/case.h"
#include "ew/library/lesson.h"

namespace ew {

/// What cases of one kind have in common (resources/templates/NAME.json, resources/schemas/template.schema.json).
struct CaseTemplate {
  std::string id;  ///< the file's name without ending
  Words title;
  Words text;                      ///< what it is for, a sentence
  Case prefilled;                  ///< region, mannequin, probes, scene, tags, difficulty; no id, no title, no volume
  std::vector<Words> indications;  ///< to choose from or to change
  std::string preset;              ///< of the console ("abdomen-convex-3.5")
  std::vector<Words> targets;      ///< names of planes and structures that such a case usually asks for
  std::vector<Lesson> lessons;     ///< outlines, whose steps still need their targets
};

/// The program's templates by title. What cannot be read is left out of the list and told.
struct TemplateList {
  std::vector<CaseTemplate> templates;
  std::vector<Error> problems;
};
[[nodiscard]] TemplateList listTemplates();
/// @error notFound (no such template: with the ids there are), badHeader, badField, newerFormat
[[nodiscard]] Result<CaseTemplate> readTemplate(const std::string& id);

/// A case with what the template has and the case has not.
[[nodiscard]] Case withTemplate(Case edited, const CaseTemplate& from);

}  // namespace ew
