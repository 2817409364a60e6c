#pragma once

#include <QPointer>
#include <string>

#include "window/frame/feature.h"

class QMenu;

namespace ew::ui {

class TrackerPage;
class TrackerWizard;
enum class TrackerCourse;

/// The tracker page and its wizards, and what the window says of the tracker in use.
class Tracking final : public Feature {
  Q_OBJECT

 public:
  using Feature::Feature;
  ~Tracking() override;

  void addAction(QMenu& scan);
  void connectParts() override;

 private:
  void showState();
  void showPage();
  void leadTo(const std::string& tracker, TrackerCourse course);

  QPointer<TrackerPage> page_;
  QPointer<TrackerWizard> wizard_;
};

}  // namespace ew::ui
