#include "ew/trackers/igtl_bodies.h"

namespace ew {
namespace {

Message meaningOfIgtlCode(int code) {
  switch (code) {
    case 3:
      return say<"the tracker was stopped in an emergency">();
    case 4:
      return say<"it does not find a file, a setting or a device">();
    case 5:
      return say<"it does not allow access">();
    case 6:
      return say<"it is busy">();
    case 7:
      return say<"it waits in vain for its own device; check the cable and the power of the tracker">();
    case 8:
      return say<"a place cannot be reached, or a number is too large">();
    case 9:
      return say<"what it received was damaged">();
    case 10:
      return say<"its settings are wrong">();
    case 11:
      return say<"it lacks memory or storage">();
    case 12:
      return say<"it does not know what it was asked for">();
    case 13:
      return say<"it is not ready yet">();
    case 14:
      return say<"it is operated by hand and takes no commands">();
    case 15:
      return say<"the device is switched off">();
    case 16:
      return say<"the device is not there">();
    case 17:
      return say<"it does not know this version of the protocol">();
    case 18:
      return say<"the device is broken">();
    case 19:
      return say<"it is shutting down">();
    default:
      return say<"it reports an error without saying which">();
  }
}

}  // namespace

Message igtlStatusSentence(const IgtlStatus& status) {
  std::string words = status.text.empty() ? status.name : status.text;
  while (!words.empty() && (words.back() == '.' || words.back() == ' ')) words.pop_back();
  if (words.empty()) return say<"The tracker's server reports: %1.">(meaningOfIgtlCode(status.code));
  return say<"The tracker's server reports: %1. In its own words: %2.">(meaningOfIgtlCode(status.code), verbatim(words));
}

}  // namespace ew
