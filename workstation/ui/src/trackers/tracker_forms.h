#pragma once

#include <QWidget>
#include <functional>
#include <string>

#include "ew/trackers/tracker_settings.h"

class QFormLayout;

namespace ew::ui {

class Trackers;

/// Asks for a recording of a tracker. @return empty: none is wanted
[[nodiscard]] QString askRecordingFile(QWidget* parent);

/// What can be set of one tracker; made anew for another one. Every change holds at once.
class TrackerForm final : public QWidget {
  Q_OBJECT

 public:
  TrackerForm(Trackers& trackers, std::string tracker, QWidget* parent = nullptr);
  [[nodiscard]] const std::string& tracker() const { return tracker_; }

 private:
  void addNetwork(QFormLayout& form, const IgtlSettings& settings);
  void addCamera(QFormLayout& form, const CameraSource& source);
  void addRecording(QFormLayout& form, const SequenceSettings& settings);
  void addController(QFormLayout& form, const HandControllerSettings& settings);
  void addFollowing(QFormLayout& form, const TrackedProbeOptions& options);
  template <class Source>
  void changeSource(const std::function<void(Source&)>& apply);

  Trackers& trackers_;
  std::string tracker_;
};

}  // namespace ew::ui
