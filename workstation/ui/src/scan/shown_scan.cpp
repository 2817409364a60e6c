#include "scan/shown_scan.h"

namespace ew::ui {

void ShownScan::takeWideSettings() {
  wide->state = frozen ? *frozen : live;
  wide->state.knobs.zoom = wide->shown.detail.zoom;
  wide->state.pan = wide->shown.detail.pan;
}

}  // namespace ew::ui
