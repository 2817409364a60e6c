#include "start/case_catalogue.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "ew/widgets/words.h"

namespace ew::ui {
namespace {

constexpr int kPageRows = 32;

/// Lessons passed of all; empty while none was begun.
std::optional<double> progressOf(const CaseRow& row, const LearningProgress& standings) {
  if (row.lessons.empty() || standings.empty()) return std::nullopt;
  int passed = 0;
  bool isBegun = false;
  for (const LessonRow& lesson : row.lessons) {
    const LessonStanding standing = standings.of(row.id, lesson.id);
    isBegun = isBegun || standing.last.has_value();
    passed += standing.isPassed(static_cast<std::size_t>(std::max(0, lesson.steps))) ? 1 : 0;
  }
  if (!isBegun) return std::nullopt;
  return static_cast<double>(passed) / static_cast<double>(row.lessons.size());
}

}  // namespace

void CaseCatalogue::setIndex(LibraryIndex* index) {
  beginResetModel();
  index_ = index;
  found_.clear();
  sections_.clear();
  pages_.clear();
  endResetModel();
}

std::optional<Error> CaseCatalogue::find(const CaseQuery& query) {
  if (index_ == nullptr) return {};
  auto found = index_->find(query);
  if (!found) return found.error();
  const bool isOther = *found != found_;
  if (isOther) beginResetModel();
  query_ = query;
  pages_.clear();
  if (!isOther) {
    if (!found_.empty()) Q_EMIT dataChanged(index(0), index(static_cast<int>(found_.size()) - 1));
    return {};
  }
  found_ = std::move(*found);
  sections_.clear();
  for (std::size_t n = 0; n < found_.size(); ++n) {
    if (sections_.empty() || sections_.back().kind != found_[n].kind) sections_.push_back({found_[n].kind, static_cast<int>(n), 0});
    ++sections_.back().count;
  }
  endResetModel();
  return {};
}

int CaseCatalogue::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : static_cast<int>(found_.size()); }

const CaseRow* CaseCatalogue::row(int row) const {
  if (index_ == nullptr || row < 0 || row >= rowCount()) return nullptr;
  const int page = row / kPageRows;
  auto kept = pages_.find(page);
  if (kept == pages_.end()) {
    const int first = page * kPageRows, end = std::min(rowCount(), first + kPageRows);
    std::vector<std::int64_t> numbers;
    for (int n = first; n < end; ++n) numbers.push_back(numberOf(n));
    std::vector<std::optional<CaseRow>> rows(numbers.size());
    if (auto read = index_->rows(numbers, query_.forTrainees))
      for (CaseRow& each : *read) {
        each.progress = progressOf(each, *standings_);
        rows[static_cast<std::size_t>(std::find(numbers.begin(), numbers.end(), each.number) - numbers.begin())] = std::move(each);
      }
    kept = pages_.insert(page, rows);
  }
  const auto& found = (*kept)[static_cast<std::size_t>(row % kPageRows)];
  return found ? &*found : nullptr;
}

int CaseCatalogue::rowOf(std::int64_t number) const {
  const auto found = std::find_if(found_.begin(), found_.end(), [number](const CaseFound& each) { return each.number == number; });
  return found == found_.end() ? -1 : static_cast<int>(found - found_.begin());
}

QVariant CaseCatalogue::data(const QModelIndex& index, int role) const {
  const CaseRow* shown = row(index.row());
  if (shown == nullptr) return {};
  if (role == Qt::DisplayRole) return words(shown->title);
  if (role != Qt::AccessibleTextRole) return {};
  QStringList parts{
      words(shown->title),   words(shown->region), shown->level ? levelWords(*shown->level) : QString(), lessonWords(shown->lessons.size()),
      progressWords(*shown), state(*shown).text};
  parts.removeAll(QString());
  return parts.join(QStringLiteral(", "));
}

const QImage* CaseCatalogue::image(const CaseRow& row) const { return images_.object(wordsOf(row.folder)); }

void CaseCatalogue::setImage(const QString& folder, const QImage& image) {
  images_.insert(folder, new QImage(image), std::max(1, static_cast<int>(image.sizeInBytes() >> 10)));
  Q_EMIT looksChanged();
}

void CaseCatalogue::setState(const QString& folder, const State& state) {
  states_.insert(folder, state);
  Q_EMIT looksChanged();
}

void CaseCatalogue::setStandings(std::shared_ptr<const LearningProgress> standings) {
  standings_ = std::move(standings);
  pages_.clear();
  Q_EMIT looksChanged();
}

QString levelWords(int level) {
  switch (level) {
    case 1:
      return CaseCatalogue::tr("First steps");
    case 2:
      return CaseCatalogue::tr("Basic");
    case 3:
      return CaseCatalogue::tr("Intermediate");
    case 4:
      return CaseCatalogue::tr("Advanced");
    case 5:
      return CaseCatalogue::tr("Examination");
    default:
      return {};
  }
}

QString kindWords(LibraryKind kind) {
  switch (kind) {
    case LibraryKind::shipped:
      return CaseCatalogue::tr("Shipped with EchoWeave");
    case LibraryKind::own:
      return CaseCatalogue::tr("Your own");
    case LibraryKind::published:
      return CaseCatalogue::tr("Published");
  }
  return {};
}

QString lessonWords(std::size_t count) {
  if (count == 0) return {};
  return count == 1 ? CaseCatalogue::tr("1 lesson") : CaseCatalogue::tr("%1 lessons").arg(count);
}

QString progressWords(const CaseRow& row) {
  if (!row.progress) return {};
  const auto passed = static_cast<int>(std::lround(*row.progress * static_cast<double>(row.lessons.size())));
  return CaseCatalogue::tr("%1 of %2 lessons passed").arg(passed).arg(row.lessons.size());
}

}  // namespace ew::ui
