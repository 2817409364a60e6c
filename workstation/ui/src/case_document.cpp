#include "case_document.h"

#include <QCoreApplication>
#include <QUndoCommand>

#include "words.h"

namespace ew::ui {
namespace {

/// QUndoStack merges neighbours of the same id and asks the command whether it agrees; the id only says that both replace a case.
constexpr int kReplaceCaseId = 1;

}  // namespace

class ReplaceCase final : public QUndoCommand {
 public:
  ReplaceCase(CaseDocument& document, Case before, Case after, const QString& what, std::string mergeKey)
      : QUndoCommand(what), document_(document), before_(std::move(before)), after_(std::move(after)), mergeKey_(std::move(mergeKey)) {}

  void undo() override { document_.replace(before_); }
  void redo() override { document_.replace(after_); }
  [[nodiscard]] int id() const override { return mergeKey_.empty() ? -1 : kReplaceCaseId; }
  bool mergeWith(const QUndoCommand* next) override {
    const auto* other = static_cast<const ReplaceCase*>(next);
    if (other->mergeKey_ != mergeKey_) return false;
    after_ = other->after_;
    setText(other->text());
    return true;
  }

 private:
  CaseDocument& document_;
  Case before_, after_;
  std::string mergeKey_;
};

CaseDocument::CaseDocument(QObject* parent) : QObject(parent) {
  connect(&history_, &QUndoStack::cleanChanged, this, &CaseDocument::changed);
}

void CaseDocument::open(Case opened) {
  current_ = std::move(opened);
  history_.clear();
  history_.setClean();
  Q_EMIT changed();
}

void CaseDocument::close() {
  current_.reset();
  history_.clear();
  Q_EMIT changed();
}

nlohmann::json CaseDocument::manifest() const { return current_ ? manifestOf(*current_) : nlohmann::json(); }

Result<void> CaseDocument::edit(const nlohmann::json& manifest, const std::string& what, const std::string& mergeKey) {
  if (!current_) return failure(ErrorCode::badUsage, "No case is open; open one first.");
  auto next = caseFromManifest(manifest, current_->folder);
  if (!next) return passOn(next.error());
  next->folder = current_->folder;
  if (*next == *current_) return {};
  history_.push(new ReplaceCase(*this, *current_, std::move(*next), words(what), mergeKey));
  return {};
}

Result<void> CaseDocument::save(const std::filesystem::path& folder) {
  if (!current_) return failure(ErrorCode::badUsage, "No case is open; open one first.");
  const std::filesystem::path target = folder.empty() ? current_->folder : folder;
  auto saved = saveCase(*current_, target);
  if (!saved) return saved;
  if (target != current_->folder) {
    // Undo steps remember the folder they were made in; after a save under another name they would lead back to the old one.
    Case moved = *current_;
    moved.folder = target;
    open(std::move(moved));
    return {};
  }
  history_.setClean();
  Q_EMIT changed();
  return {};
}

void CaseDocument::replace(const Case& next) {
  current_ = next;
  Q_EMIT changed();
}

}  // namespace ew::ui
