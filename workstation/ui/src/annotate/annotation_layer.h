#pragma once

#include <QPointF>
#include <QWidget>
#include <functional>
#include <optional>

#include "annotate/image_annotations.h"
#include "keys/key_map.h"

class QCompleter;
class QKeyEvent;
class QLineEdit;
class QStringListModel;

namespace ew::ui {

class ScanView;

/// Texts and arrows over the scan. It lies on top of the image and takes no events of its own: it looks first at those of the scan view and
/// of the calipers, and uses what means an annotation. The mouse draws arrows, moves what is there (an arrow by its ends too), a double
/// click writes a text anew. A text is typed in a field in its place, where words of the list complete it: Tab or a click takes one, Enter
/// ends, Escape gives up, Ctrl+Home goes to the home position. Delete takes the chosen annotation away, Backspace its last word.
class AnnotationLayer final : public QWidget {
  Q_OBJECT

 public:
  AnnotationLayer(Session& session, ImageAnnotations& images, ScanView& scan);
  /// Whose events are looked at as well; lies over the scan view. @param isInUse while it is, a press there means what lies over
  void watch(QWidget* over, std::function<bool()> isInUse);
  void setKeys(const KeyMap& keys) { keys_ = &keys; }

  /// Begins a text at the pointer when that is over the image, else at the home position; with words of the list, or none yet.
  void write(const QString& words = {});
  /// The home position is where the text that is typed stands, or else the chosen one, or the pointer over the image.
  void setHomeHere();
  /// What is being typed is done.
  void finish();
  [[nodiscard]] bool isWriting() const;
  [[nodiscard]] QLineEdit& field() const { return *field_; }
  /// Where a point of the image's plane is painted.
  [[nodiscard]] QPointF placeOf(const glm::dvec2& at_mm) const;

 Q_SIGNALS:
  void writingBegan();  ///< whatever else was in the hand is to be put down

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void follow();
  void showOrHide();
  void writeAt(const QPointF& at, const QString& words, int number);
  void endWriting(bool keeps);
  void moveField(const QPointF& at);
  void fitField();
  [[nodiscard]] bool hasNothingTyped() const;
  void complete();
  void take(const QString& whole);  ///< of the words that are offered
  bool press(const QPointF& at);
  bool move(const QPointF& at);
  bool release(const QPointF& at);
  [[nodiscard]] bool isOwnKey(const QKeyEvent& event) const;
  bool key(const QKeyEvent& event);
  bool fieldKey(int key, Qt::KeyboardModifiers modifiers);
  void showCursor(const QPointF& at);
  [[nodiscard]] QPointF homePlace() const;
  [[nodiscard]] glm::dvec2 pointAt(const QPointF& at) const;
  [[nodiscard]] std::optional<annotation::AnnotationFound> foundAt(const QPointF& at) const;

  Session& session_;
  ImageAnnotations& images_;
  ScanView& scan_;
  const KeyMap* keys_ = &usualKeys();
  QLineEdit* field_ = nullptr;
  QCompleter* completer_ = nullptr;
  QStringListModel* completions_ = nullptr;
  QPointF fieldAt_;           ///< left end of what is typed, of the scan view
  bool isLeftEmpty_ = false;  ///< a click has just taken the focus from a text of which nothing is typed: it begins where that was
  int rewritten_ = 0;         ///< text that is written anew; 0: a new one
  struct Drag {
    int number = 0;  ///< 0: an arrow is drawn
    annotation::AnnotationPart part = annotation::AnnotationPart::whole;
    QPointF from, to;  ///< of the scan view
    bool hasMoved = false;
  };
  std::optional<Drag> drag_;
  bool hasCursor_ = false;
  std::function<bool()> isOverInUse_ = [] { return false; };
};

}  // namespace ew::ui
