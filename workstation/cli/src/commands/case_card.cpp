#include "commands/case_card.h"

#include <algorithm>

#include "ew/imaging/display_image.h"
#include "ew/library/case_card.h"
#include "ew/scanning/display_image_file.h"
#include "ew/scanning/first_image.h"
#include "run/volume_input.h"

namespace ew::cli {
namespace {

struct CardArguments {
  std::string chosen;
  std::string output;
};

/// The image above the strip in which the words are burnt.
RgbImage aboveStrip(const RgbImage& image) {
  RgbImage card(image.width, image.height + kCardStripHeight_px);
  std::copy(image.pixels.begin(), image.pixels.end(), card.pixels.begin());
  return card;
}

Result<int> makeCard(const CardArguments& arguments, Run& run) {
  const auto found = findCase(arguments.chosen);
  if (!found) return passOn(found.error());
  if (auto kept = run.protect(found->folder / "case.json"); !kept) return passOn(kept.error());
  const std::filesystem::path file = arguments.output.empty() ? found->folder / kCardName : std::filesystem::path(arguments.output);
  if (auto announced = run.output(file, ".png"); !announced) return passOn(announced.error());
  const auto there = beginningsThere();
  if (!there) return passOn(there.error());
  auto contents = readCaseContents(run, *found);
  if (!contents) return passOn(contents.error());
  ScanSubject subject = subjectOf(*found, *contents);
  if (auto formed = formEchoes(run, subject, found->scene); !formed) return passOn(formed.error());
  Scanner scanner;
  const auto image = firstImage(scanner, subject, *there, kCardImageWidth_px, kCardImageHeight_px);
  if (!image)
    return failure(ErrorCode::badUsage,
                   say<"The case allows none of the probes there are, so it has no first image; correct \"probes\" in its case.json.">());
  if (auto written = writeDisplayImage(aboveStrip(composed(*image)), 1.0, run.outputs.staged(file)); !written)
    return passOn(written.error());
  run.say("Wrote the card's image of " + found->title + ".");
  return kDone;
}

}  // namespace

void addCaseCard(CLI::App& group, Selection& selection) {
  auto arguments = std::make_shared<CardArguments>();
  auto& app = addCommand(group, selection, "card", "Make the image that a case's card shows where the case is not prepared yet",
                         {"case card my-cases/knee", "case card liver-cyst -o card.png"},
                         [arguments](Run& run) { return makeCard(*arguments, run); });
  app.add_option("CASE", arguments->chosen, "A case folder, its case.json, or the id of a case; it is prepared first where it has to be")
      ->required()
      ->type_name("");
  app.add_option("-o,--output", arguments->output, "Elsewhere than card.png in the case's folder, which is handed on with the case")
      ->type_name("OUT.png");
}

}  // namespace ew::cli
