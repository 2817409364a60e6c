#pragma once

#include <QDialog>

class QHBoxLayout;
class QLabel;
class QVBoxLayout;

namespace ew {

/// A dialog of questions: a heading and a sentence, rows that scroll where the screen has no room for them, something large beside them
/// (or nothing), and buttons that are always in sight. It grows with its rows as far as the screen allows; nothing overlaps or is cut.
class FormDialog : public QDialog {
  Q_OBJECT

 public:
  /// @param heading what it is about; `tip` says it in full
  FormDialog(const QString& heading, const QString& tip, QWidget* parent);

 protected:
  [[nodiscard]] QLabel& sentence() { return *sentence_; }  ///< below the heading; hidden while it is empty
  /// Sets the sentence, in the colour of danger or as plain text.
  void say(const QString& sentence, bool isProblem);
  [[nodiscard]] QVBoxLayout& rows() { return *rows_; }
  [[nodiscard]] QHBoxLayout& buttons() { return *buttons_; }  ///< a stretch, then what is added
  /// Takes the width and height that the rows leave. @param wanted of the dialog with it
  void putBeside(QWidget* large, const QSize& wanted);
  /// Makes room for what the rows need now. Grows only: nothing jumps while a person reads.
  void grow();

  void showEvent(QShowEvent* event) override;

 private:
  class RowsArea;
  QVBoxLayout* outer_ = nullptr;
  QHBoxLayout* middle_ = nullptr;
  RowsArea* area_ = nullptr;
  QLabel* sentence_ = nullptr;
  QVBoxLayout* rows_ = nullptr;
  QHBoxLayout* buttons_ = nullptr;
  QSize wanted_;
  bool wasShown_ = false;
};

}  // namespace ew
