#pragma once

#include <QAbstractListModel>
#include <QCache>
#include <QHash>
#include <QImage>
#include <memory>
#include <optional>
#include <vector>

#include "ew/library/index.h"
#include "ew/library/learning_progress.h"

namespace ew::ui {

/// What the index finds, as a list whose rows are read when they are looked at: a thousand cards cost what the visible ones cost.
class CaseCatalogue final : public QAbstractListModel {
  Q_OBJECT

 public:
  struct Section {
    LibraryKind kind = LibraryKind::own;
    int first = 0;
    int count = 0;
  };
  /// How the preparation of a case stands.
  struct State {
    QString text;
    double fraction = 0.0;  ///< 0: no bar
  };

  using QAbstractListModel::QAbstractListModel;

  /// @param index may be null: an empty list
  void setIndex(LibraryIndex* index);
  /// Finds, and says so when what is found is another list than before (modelReset); else its rows are read anew.
  /// @return what the index refused, if it did
  std::optional<Error> find(const CaseQuery& query);

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] const std::vector<Section>& sections() const { return sections_; }
  /// Null when it is gone from the index meanwhile.
  [[nodiscard]] const CaseRow* row(int row) const;
  [[nodiscard]] std::int64_t numberOf(int row) const { return found_[static_cast<std::size_t>(row)].number; }
  /// -1 when it is not in the list.
  [[nodiscard]] int rowOf(std::int64_t number) const;

  [[nodiscard]] const QImage* image(const CaseRow& row) const;
  [[nodiscard]] State state(const CaseRow& row) const { return states_.value(QString::fromStdString(row.folder.string())); }
  void setImage(const QString& folder, const QImage& image);
  void setState(const QString& folder, const State& state);
  /// How far the person who learns has got with the lessons of the cases; sets `progress` of the rows.
  void setStandings(std::shared_ptr<const LearningProgress> standings);
  [[nodiscard]] const LearningProgress& standings() const { return *standings_; }

 Q_SIGNALS:
  void looksChanged();  ///< an image or a state

 private:
  LibraryIndex* index_ = nullptr;
  CaseQuery query_;
  std::vector<CaseFound> found_;
  std::vector<Section> sections_;
  mutable QHash<int, std::vector<std::optional<CaseRow>>> pages_;
  mutable QCache<QString, QImage> images_{64 << 10};  // KiB
  QHash<QString, State> states_;
  std::shared_ptr<const LearningProgress> standings_ = std::make_shared<const LearningProgress>();
};

/// "First steps" to "Examination" for 1 to 5; empty for others.
[[nodiscard]] QString levelWords(int level);
/// "Shipped with EchoWeave", "Your own", "Published".
[[nodiscard]] QString kindWords(LibraryKind kind);
/// "2 lessons"; empty for none.
[[nodiscard]] QString lessonWords(std::size_t count);
/// "1 of 2 lessons passed"; empty where nobody has begun.
[[nodiscard]] QString progressWords(const CaseRow& row);

}  // namespace ew::ui
