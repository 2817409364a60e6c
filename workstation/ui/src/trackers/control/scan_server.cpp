#include "trackers/control/scan_server.h"

#include <QDateTime>
#include <utility>

#include "scan/session.h"

namespace ew::ui {
namespace {

constexpr int kLook_ms = 100;
constexpr int kRest_ms = 300;  ///< so often a resting pose is sent; a client gives up after half a second

/// Of a moment of the scan's clock, as other computers count.
double since1970_s(const Session& session, double time_s) {
  return 1e-3 * static_cast<double>(QDateTime::currentMSecsSinceEpoch()) - (session.frames().now_s() - time_s);
}

}  // namespace

ScanServer::ScanServer(Session& session, QObject* parent) : QObject(parent), session_(session) {
  connect(&session_, &Session::imageChanged, this, &ScanServer::sendImage);
  connect(&session_.probeControl(), &ProbeControl::poseMissed, this, &ScanServer::sendMissed);
  look_.setInterval(kLook_ms);
  connect(&look_, &QTimer::timeout, this, &ScanServer::look);
}

Result<int> ScanServer::start(const IgtlServerOptions& options) {
  stop();  // it may hold the port that is asked for
  auto server = std::make_unique<IgtlServer>(options);
  auto port = server->start();
  if (!port) return port;
  server_ = std::move(server);
  clients_ = 0;
  sinceSent_.start();
  look_.start();
  sendImage();
  return port;
}

void ScanServer::stop() {
  look_.stop();
  server_.reset();
}

void ScanServer::look() {
  const int clients = status().clients;
  if (clients > clients_) sendImage();
  if (std::exchange(clients_, clients) != clients) Q_EMIT clientsChanged();
  if (sinceSent_.elapsed() >= kRest_ms) sendPose();
}

/// Where the probe of the image is, now as before.
void ScanServer::sendPose() {
  if (!server_ || session_.probeControl().isLost() || session_.fanImage().isEmpty()) return;
  IgtlFrame frame;
  frame.pose = session_.shownState().pose;
  frame.time_s = since1970_s(session_, session_.frames().now_s());
  server_->send(frame);
  sinceSent_.start();
}

void ScanServer::sendImage() {
  if (!server_ || session_.probeControl().isLost() || session_.fanImage().isEmpty()) return;
  const ScanState& shown = session_.shownState();
  IgtlFrame frame;
  frame.pose = shown.pose;
  frame.image = session_.fanImage().grey;
  frame.imageToWorld = shown.pose.probeToWorld * session_.fanGeometry().imageToProbe();
  // A recording has the clock of its own day.
  frame.time_s = since1970_s(session_, session_.isPlaying() ? session_.frames().now_s() : shown.time_s);
  server_->send(frame);
  sinceSent_.start();
}

void ScanServer::sendMissed() {
  if (!server_) return;
  IgtlFrame frame;
  frame.pose = session_.probeControl().missedState().pose;
  frame.time_s = since1970_s(session_, session_.probeControl().missedState().time_s);
  server_->send(frame);
}

}  // namespace ew::ui
