#include "ew/export/outbox.h"
#include "folder.h"

/// An outbox in which somebody else wrote a note and a copy.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace ew;
  static const auto folder = fuzz::ownFolder() / "outbox";
  std::filesystem::create_directories(folder);
  const auto parts = fuzz::partsOf(bytes, size);
  fuzz::put("outbox/1.2.3.json", parts[0]);
  fuzz::put("outbox/1.2.4.dcm", parts.back());
  fuzz::put("outbox/notes", parts.size() > 2 ? parts[1] : "");
  const auto outbox = DicomOutbox::open(folder);
  if (!outbox) {
    fuzz::checkSentence(outbox.error());
    return 0;
  }
  if (parts.size() <= 2) fuzz::mustHold(outbox->entries().size() + outbox->unreadable().size() == 2);
  for (const Error& each : outbox->unreadable()) fuzz::checkSentence(each);
  return 0;
}
