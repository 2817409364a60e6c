// The scan for others: the OpenIGTLink server.
#include "ew/widgets/words.h"
#include "trackers/control/scan_server.h"
#include "trackers/control/tracker_control.h"

namespace ew::ui {

void Trackers::serve(bool serves, int port, bool toNetwork) {
  list_.serves = serves;
  list_.servePort = port;
  list_.servesNetwork = toNetwork;
  keepList();
  server_.reset();
  serverProblem_ = {};
  if (!serves) return;
  server_ = std::make_unique<ScanServer>(session_);
  connect(server_.get(), &ScanServer::clientsChanged, this, &Trackers::reported);  // without a tracker nothing else would say it
  IgtlServerOptions options;
  options.port = port;
  options.everyone = toNetwork;
  const auto started = server_->start(options);
  if (started) return;
  serverProblem_ = started.error().message;
  server_.reset();
}

QString Trackers::serverSentence() const {
  if (!serverProblem_.empty()) return words(serverProblem_);
  if (!server_) return tr("Nothing is sent.");
  const IgtlServerStatus status = server_->status();
  if (status.clients == 0) return tr("Waiting on port %1; nobody is connected yet.").arg(status.port);
  return tr("Sent on port %1; programs connected: %2.").arg(status.port).arg(status.clients);
}

}  // namespace ew::ui
