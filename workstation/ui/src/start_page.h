#pragma once

#include <QWidget>
#include <filesystem>
#include <vector>

#include "ew/imaging/probe.h"
#include "ew/library/case.h"
#include "recent_files.h"

class QGridLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace ew::ui {

/// The shipped cases as cards, *Open*, and what was open recently. Says what to do when there is nothing.
class StartPage final : public QWidget {
  Q_OBJECT

 public:
  explicit StartPage(QWidget* parent = nullptr);

  void showCases(const std::vector<Case>& cases, const QString& problem);
  void showRecent(const std::vector<RecentFile>& files);
  /// Authors read the cases' own titles, and what else may be opened here.
  void setForAuthors(bool forAuthors);
  /// @param name of what is open, which the page leads back to; empty: nothing is open
  void setOpenCase(const QString& name);
  /// Says on the case's card how its preparation stands; empty when it is ready. @param fraction 0..1; 0: no bar
  void setState(const std::string& caseId, const QString& state, double fraction);
  /// Puts a picture of the case's volume on its card.
  void setThumbnail(const std::string& caseId, const QImage& picture);

 Q_SIGNALS:
  void caseChosen(const QString& folder);
  void fileChosen(const QString& file);
  void openRequested();
  void backRequested();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void arrange();
  QWidget* body_ = nullptr;
  QGridLayout* grid_ = nullptr;
  QVBoxLayout* recent_ = nullptr;
  QLabel* recentTitle_ = nullptr;
  QLabel* empty_ = nullptr;
  QLabel* hint_ = nullptr;
  QPushButton* back_ = nullptr;
  std::vector<QWidget*> cards_;
  bool forAuthors_ = false;
  int columns_ = 0;
};

}  // namespace ew::ui
