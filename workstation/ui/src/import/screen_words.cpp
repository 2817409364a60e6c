#include "import/screen_words.h"

#include <algorithm>

#include "ew/widgets/figures.h"
#include "import/screen_dialog.h"

namespace ew::ui {

QString wordsOfBoxes(const std::vector<TextBox>& boxes) {
  const auto count = static_cast<int>(std::count_if(boxes.begin(), boxes.end(), [](const TextBox& box) { return box.counts; }));
  const auto open = std::count_if(boxes.begin(), boxes.end(), [](const TextBox& box) { return box.isPossible && !box.counts; });
  QString text = count == 0 ? ScreenDialog::tr("No text over the scan is taken out.")
                            : ScreenDialog::tr("Boxes of text over the scan that are filled: %1").arg(count);
  if (open > 0)
    text += QLatin1Char(' ') + ScreenDialog::tr("Dashed boxes that may be text, or echoes: %1. Click those that are text.").arg(open);
  return text;
}

QString wordsOfScale(const std::optional<DepthTicks>& ticks, const Result<ScreenGeometry>& geometry) {
  QString text = ticks ? ScreenDialog::tr("%1 marks were found, %2 pixels apart.").arg(ticks->count).arg(figure(ticks->spacing_px, 2))
                       : ScreenDialog::tr("No marks were found.");
  text += QLatin1Char(' ');
  if (geometry && geometry->pixel_mm && geometry->outline)
    text += ScreenDialog::tr("A pixel is %1 mm, the scan %2 mm deep.")
                .arg(figure(*geometry->pixel_mm, 4), figure(*geometry->pixel_mm * geometry->outline->depth_px(), 1));
  else
    text +=
        ticks ? ScreenDialog::tr("Type how far apart they are, or the depth.") : ScreenDialog::tr("Type the depth that the screen states.");
  return text;
}

}  // namespace ew::ui
