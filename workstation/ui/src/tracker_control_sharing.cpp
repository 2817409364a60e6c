// The scan for others: the OpenIGTLink server.
#include "tracker_control.h"

namespace ew::ui {

void Trackers::serve(bool serves, int port) {
  list_.serves = serves;
  list_.servePort = port;
  keepList();
}

QString Trackers::serverSentence() const { return {}; }

}  // namespace ew::ui
