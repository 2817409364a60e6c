#pragma once

#include <QWidget>
#include <string>
#include <vector>

#include "editor/lesson_document.h"
#include "ew/library/case_words.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QListWidget;
class QPlainTextEdit;
class QPushButton;

namespace ew::lessons {

/// What trainees read, in another language: a list of the texts of the case and its lessons, and what stands in place of the chosen one.
/// Translations lie in words/LANGUAGE.json of the case and are written there at once, each by itself.
class WordsPage final : public QWidget {
  Q_OBJECT

 public:
  explicit WordsPage(LessonDocument& document, QWidget* parent = nullptr);
  void showTexts();  ///< anew, when the page comes to the front or texts have changed

 Q_SIGNALS:
  void backAsked();
  void failed(const QString& problem);

 private:
  void showChosen();
  void keep();
  [[nodiscard]] std::string language() const;

  LessonDocument& document_;
  CaseWords words_;
  std::vector<std::string> texts_;  ///< as they are listed
  QComboBox* language_ = nullptr;
  QCheckBox* onlyMissing_ = nullptr;
  QLabel* count_ = nullptr;
  QListWidget* list_ = nullptr;
  QLabel* original_ = nullptr;
  QPlainTextEdit* translation_ = nullptr;
  QPushButton* keep_ = nullptr;
};

/// Texts of the case and its lessons that have no words in a language.
[[nodiscard]] std::vector<std::string> textsWithout(const std::vector<std::string>& texts, const CaseWords& words);

}  // namespace ew::lessons
