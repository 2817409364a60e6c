#pragma once

#include <QVBoxLayout>
#include <QWidget>
#include <cstddef>
#include <functional>
#include <vector>

#include "ew/widgets/theme.h"

namespace ew::case_authoring {

/// Entries of a list, one below the other, that are made anew when there are more or fewer.
class EntryRows : public QWidget {
 protected:
  /// @param gap_px between entries
  EntryRows(int gap_px, QWidget* parent) : QWidget(parent), gap_px_(gap_px), column_(new QVBoxLayout(this)) {
    column_->setContentsMargins(0, 0, 0, 0);
    column_->setSpacing(kGrid_px);
    column_->addWidget(entries_ = new QWidget);
  }
  /// Takes the entries away. @return where the new ones go
  QVBoxLayout& emptied() {
    // The button that asked for it may be among what is replaced.
    column_->removeWidget(entries_);
    entries_->hide();
    entries_->setParent(nullptr);
    entries_->deleteLater();
    entries_ = new QWidget;
    auto* rows = new QVBoxLayout(entries_);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(gap_px_);
    column_->insertWidget(0, entries_);
    return *rows;
  }
  [[nodiscard]] QVBoxLayout& column() { return *column_; }  ///< the entries stand first in it

 private:
  int gap_px_;
  QVBoxLayout* column_;
  QWidget* entries_ = nullptr;
};

/// A list of a case. What an entry has beside what is shown of it stays as it is.
template <class Entry>
class ListField : public EntryRows {
 public:
  void setValue(const std::vector<Entry>& list) {
    if (list == list_) return;
    list_ = list;
    remake();
  }
  std::function<void(const std::vector<Entry>& list)> onChanged;  ///< called when the user edits

 protected:
  using EntryRows::EntryRows;
  virtual void addRows(std::size_t number, QVBoxLayout& rows) = 0;

  [[nodiscard]] const std::vector<Entry>& list() const { return list_; }
  void remake() {
    QVBoxLayout& rows = emptied();
    for (std::size_t n = 0; n < list_.size(); ++n) addRows(n, rows);
  }
  void tell() {
    if (onChanged) onChanged(list_);
  }
  /// What is shown follows the user's hand already.
  template <class Change>
  void edit(std::size_t number, const Change& change) {
    if (number >= list_.size()) return;
    change(list_[number]);
    tell();
  }
  /// An edit after which all entries are shown anew.
  template <class Change>
  void replace(const Change& change) {
    change(list_);
    remake();
    tell();
  }
  void remove(std::size_t number) {
    replace([number](std::vector<Entry>& all) { all.erase(all.begin() + static_cast<std::ptrdiff_t>(number)); });
  }

 private:
  std::vector<Entry> list_;
};

}  // namespace ew::case_authoring
