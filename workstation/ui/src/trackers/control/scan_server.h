#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <memory>

#include "ew/trackers/igtl_server.h"

namespace ew::ui {

class Session;

/// Shows the scan of a session to other programs over OpenIGTLink: each image and where the probe was. While a tracker
/// has lost the probe no image is sent, and that it is lost. A probe at rest makes no image: then its pose is sent all the same, more
/// than twice a second, for whoever hears nothing for longer believes that it is out of view; and whoever connects gets the image at
/// once.
class ScanServer final : public QObject {
  Q_OBJECT

 public:
  explicit ScanServer(Session& session, QObject* parent = nullptr);

  /// Begins, or begins again with other options. @return the port it listens on
  /// @error as IgtlServer::start; then nothing is sent
  [[nodiscard]] Result<int> start(const IgtlServerOptions& options);
  void stop();
  [[nodiscard]] bool isRunning() const { return server_ != nullptr; }
  /// All zero while it does not run.
  [[nodiscard]] IgtlServerStatus status() const { return server_ ? server_->status() : IgtlServerStatus{}; }

 Q_SIGNALS:
  void clientsChanged();  ///< how many programs are connected

 private:
  void look();
  void sendPose();
  void sendImage();
  void sendMissed();

  Session& session_;
  std::unique_ptr<IgtlServer> server_;
  QTimer look_;
  QElapsedTimer sinceSent_;
  int clients_ = 0;
};

}  // namespace ew::ui
