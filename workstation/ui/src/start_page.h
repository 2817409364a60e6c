#pragma once

#include <QWidget>
#include <filesystem>
#include <vector>

#include "ew/library/case.h"

class QGridLayout;
class QLabel;
class QVBoxLayout;

namespace ew::ui {

/// The shipped cases as cards, *Open*, and what was open lately. Says what to do when there is nothing.
class StartPage final : public QWidget {
  Q_OBJECT

 public:
  explicit StartPage(QWidget* parent = nullptr);

  void showCases(const std::vector<Case>& cases, const QString& problem);
  void showRecent(const QStringList& files);
  /// Puts a picture of the case's volume on its card.
  void setThumbnail(const std::string& caseId, const QImage& picture);

 Q_SIGNALS:
  void caseChosen(const QString& folder);
  void fileChosen(const QString& file);
  void openRequested();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void arrange();
  QWidget* body_ = nullptr;
  QGridLayout* grid_ = nullptr;
  QVBoxLayout* recent_ = nullptr;
  QLabel* recentTitle_ = nullptr;
  QLabel* empty_ = nullptr;
  std::vector<QWidget*> cards_;
  int columns_ = 0;
};

/// A middle cut through a volume seen from the front, as a card shows it.
[[nodiscard]] QImage thumbnailOf(const Volume& volume, const QSize& size);

}  // namespace ew::ui
