#pragma once

#include <QFrame>
#include <QPointer>
#include <QTimer>
#include <functional>
#include <vector>

class QLabel;
class QPushButton;

namespace ew::ui {

enum class TourPlace { explore, start, author };

/// A few words beside the things of the window, one after another: where to begin, not how everything works. It covers nothing but the
/// ground it stands on, every key and click beside it goes where it would go without it, and it can be left at any moment.
class Tour final : public QFrame {
  Q_OBJECT

 public:
  using Place = TourPlace;
  struct Step {
    QString name;  ///< of the thing, for people
    QString text;  ///< what it is for
    Place place = Place::explore;
    std::function<QWidget*()> thing;   ///< null: not there now, and the step is left out
    std::function<void()> bring = {};  ///< brings it in front of what takes turns with it
  };
  /// @param goTo shows a place; false: it cannot be shown now. Called only when the user asks for a step there
  Tour(std::vector<Step> steps, std::function<bool(Place)> goTo, QWidget* window);

  /// Begins with what is in sight.
  void begin();
  void next();
  void back();
  void leave();
  [[nodiscard]] int step() const { return now_; }  ///< index of the step that is shown; -1: none

 Q_SIGNALS:
  void left();  ///< it is over

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void makeRows();
  static bool takesKey(QEvent* event);
  void show(int step);
  [[nodiscard]] QWidget* thingOf(int step) const;  ///< when it is seen
  [[nodiscard]] bool tryStep(int step);            ///< goes there, when its place and its thing can be shown
  [[nodiscard]] int neighbour(int way) const;      ///< the next step that can be tried; -1: none
  void follow();                                   ///< what the user did: another page, another size
  void place();
  [[nodiscard]] QRect bestPlace(const QRect& thing, const QSize& size, QPoint& points) const;

  std::vector<Step> steps_;
  std::function<bool(Place)> goTo_;
  QLabel* name_ = nullptr;
  QLabel* text_ = nullptr;
  QLabel* count_ = nullptr;
  QPushButton* back_ = nullptr;
  QPushButton* next_ = nullptr;
  QLayout* line_ = nullptr;     ///< of the buttons
  QWidget* ring_ = nullptr;     ///< around the thing
  QWidget* pointer_ = nullptr;  ///< from the bubble to it
  QPointer<QWidget> before_;    ///< had the focus, and gets it back
  QTimer watch_;
  std::vector<int> way_;  ///< steps seen, in their order; the last one is shown
  int now_ = -1;
};

}  // namespace ew::ui
