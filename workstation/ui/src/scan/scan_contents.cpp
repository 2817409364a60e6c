#include "scan/scan_contents.h"

namespace ew::ui {

void ScanContents::takeWideSettings() {
  wide->state = frozen ? *frozen : live;
  wide->state.knobs.zoom = wide->shown.detail.zoom;
  wide->state.pan = wide->shown.detail.pan;
}

}  // namespace ew::ui
