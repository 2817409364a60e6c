#pragma once

#include <QPointer>
#include <QWidget>
#include <vector>

#include "start/case_catalogue.h"
#include "start/learning.h"
#include "start/recent_files.h"

class QAction;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QStackedWidget;

namespace ew::ui {

class CaseFilters;
class CardView;
class CourseStrip;
class RecentStrip;

/// The library: cases as cards, found by words and filters, *Open*, and what was open recently. Says what to do when there is nothing.
class StartPage final : public QWidget {
  Q_OBJECT

 public:
  explicit StartPage(QWidget* parent = nullptr);

  /// @param index may be null; outlives the page's use of it
  void setIndex(LibraryIndex* index);
  /// Shows what the index says now; what is in sight stays in sight.
  void showFound();
  /// While the folders are read for the first time an empty list says so.
  void setReading(bool reading);
  /// Why there are no cases at all; empty: nothing is wrong.
  void setProblem(const QString& problem);
  void showRecent(const std::vector<RecentFile>& files);
  /// Authors read and search the cases' own titles and findings, and see what else may be opened here.
  void setForAuthors(bool forAuthors);
  /// @param name of what is open, which the page leads back to; empty: nothing is open
  void setOpenCase(const QString& name);
  /// Shows how far the person who learns has got: on the cards, in the course, and what was stopped in the middle.
  void showLearning(std::shared_ptr<const Learning::Known> known);
  /// Says on the case's card how its preparation stands; empty when it is ready. @param fraction 0..1; 0: no bar
  void setState(const QString& folder, const QString& state, double fraction);
  /// Puts an image of the case's volume on its card.
  void setThumbnail(const QString& folder, const QImage& image);
  void focusSearch();
  /// A button for what begins a case, as long as `action` is there: for authors in the head, for everybody where there is no case yet.
  void addBeginning(QAction* action);
  /// Puts the keys on the card of a case, whatever is searched for. @return false: the list does not have it
  bool choose(const QString& folder);

  [[nodiscard]] const CaseCatalogue& cases() const { return list_; }
  [[nodiscard]] QStringList foldersInSight() const;
  /// Folders of the cards when they are so few that nobody needs another way to one of them; else none.
  [[nodiscard]] QStringList foldersAtAGlance() const;

 Q_SIGNALS:
  void caseChosen(const QString& folder);
  /// The case is to be opened, and this lesson of it begun or gone on with.
  void lessonChosen(const QString& folder, const QString& lessonId);
  void fileChosen(const QString& file);
  void openRequested();
  void backRequested();
  void withdrawRequested(const QString& folder, const QString& title);
  void sightChanged();  ///< other cards are in sight
  void listed();        ///< the list is another one
  void problem(const ew::Error& error);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void makeHead();
  void makeList();
  void find();
  void showEmpty();
  void clearSearch();
  void showCourse();
  void showLessonsOf(int row, const QRect& card_global);
  void showMenuOf(int row, const QRect& card_global, const QPoint& at_global);
  [[nodiscard]] CaseQuery query() const;
  CaseCatalogue list_;
  QLineEdit* search_ = nullptr;
  CaseFilters* filters_ = nullptr;
  CourseStrip* course_ = nullptr;
  CardView* cards_ = nullptr;
  QStackedWidget* pages_ = nullptr;
  QLabel* empty_ = nullptr;
  QPushButton* emptyButton_ = nullptr;
  RecentStrip* recent_ = nullptr;
  QLabel* hint_ = nullptr;
  QPushButton* open_ = nullptr;
  QPushButton* back_ = nullptr;
  QHBoxLayout* head_ = nullptr;
  QHBoxLayout* emptyButtons_ = nullptr;
  std::vector<QPointer<QPushButton>> beginnings_;       ///< in the head
  std::vector<QPointer<QPushButton>> emptyBeginnings_;  ///< on the empty page
  LibraryIndex* index_ = nullptr;
  std::shared_ptr<const Learning::Known> known_ = std::make_shared<const Learning::Known>();
  QString problem_;
  bool reading_ = false;
  bool forAuthors_ = false;
};

}  // namespace ew::ui
