// The bytes as a stitch project, and as a file that keeps unsaved work.
#include "ew/stitching/project.h"
#include "logic/stitch_document.h"
#include "one_text.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace ew;
  const std::string text(reinterpret_cast<const char*>(bytes), size);
  fuzz::OneText files(text);
  if (const auto transform = stitching::parseRigidRows(text, "transform"); !transform) fuzz::checkError(transform.error());
  const auto project = stitching::parseProject(text, "/folder");
  if (!project) {
    fuzz::checkError(project.error());
  } else {
    // What was read is written so that it is read again, to the same project.
    const auto again = stitching::parseProject(stitching::projectText(*project, "/folder"), "/folder");
    fuzz::mustHold(again.has_value() && *again == *project);
  }
  const auto file = fuzz::asFile(bytes, size, ".json");
  stitching::StitchDocument document(files, file);
  const auto left = document.leftIn(file);
  if (!left)
    fuzz::checkError(left.error());
  else if (*left)
    document.takeOver(**left);
  return 0;
}
