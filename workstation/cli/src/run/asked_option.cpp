#include "run/asked_option.h"

#include "ew/library/file_import.h"

namespace ew::cli {

std::string optionFor(const std::string& asked) {
  if (asked == "region") return "--region N";
  if (asked == "pixel-mm") return "--pixel-mm X,Y (with --region all for the whole image)";
  if (asked == "spacing") return "--spacing X[,Y,Z]";
  if (asked == "colour") return "--colour keep-grey or --colour drop-colour";
  if (asked == "blank") return "--region N, --blank X,Y,W,H or --keep-text";
  if (asked == "time-step") return "--time-step N";
  if (asked == "raw") return "--raw DIMS:TYPE:SPACING[:OFFSET]";
  if (asked == "sequence") return "--planes";
  if (asked == "reconstruct") return "the command reconstruct";
  if (asked == "calibration") return "--calibration XML";
  if (asked == "frame") return "--image-to FRAME or --calibration XML";
  if (asked == "accept-small") return "--accept-small";
  if (asked == "rate") return "--rate HZ";
  if (asked == "time-offset") return "--time-offset S";
  if (asked == "motor") return "--motor MOTOR.json or --poses FILE, see resources/docs/science/acquisition.md";
  return {};
}

tl::unexpected<Error> withOption(Error error) {
  const std::string option = optionFor(askedFor(error));
  std::string sentence = error.sentence();
  if (!option.empty() && sentence.ends_with('.')) {
    sentence.pop_back();
    error.message = verbatim(sentence + ": " + option + ".");
  }
  return passOn(std::move(error));
}

}  // namespace ew::cli
