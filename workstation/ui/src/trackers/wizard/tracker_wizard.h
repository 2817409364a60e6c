#pragma once

#include <QDialog>
#include <QTimer>
#include <string>
#include <vector>

class QPushButton;
class QStackedWidget;

namespace ew::ui {

class TrackerStep;
class Trackers;

/// What is led through: everything of a camera with printed paper; the mannequin alone; the face of a tool and the mannequin.
enum class TrackerCourse { camera, align, faceAndAlign };

/// Leads somebody who has never seen a tracker to one that works, a step after the other. Each step keeps what it finds at once: whoever
/// leaves loses nothing and goes on where it was left.
class TrackerWizard final : public QDialog {
  Q_OBJECT

 public:
  TrackerWizard(Trackers& trackers, std::string tracker, TrackerCourse course, QWidget* parent);
  ~TrackerWizard() override;

  void showStep(int step);
  [[nodiscard]] int step() const;
  [[nodiscard]] int stepCount() const { return static_cast<int>(steps_.size()); }
  [[nodiscard]] TrackerStep& current() const;

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void addSteps(TrackerCourse course);
  void addColumn(QWidget& column);
  [[nodiscard]] int neighbour(int by) const;
  void goOn();
  void refresh();

  Trackers& trackers_;
  std::string tracker_;
  std::vector<TrackerStep*> steps_;
  std::vector<QPushButton*> names_;
  QStackedWidget* pages_ = nullptr;
  QPushButton *back_ = nullptr, *next_ = nullptr;
  QTimer poll_;
};

}  // namespace ew::ui
