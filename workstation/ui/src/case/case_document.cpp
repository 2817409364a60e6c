#include "case/case_document.h"

#include <chrono>

#include "ew/library/published.h"

namespace ew::ui {
namespace {

constexpr std::chrono::seconds kRefreshEvery{30};

}  // namespace

CaseDocument::CaseDocument(QObject* parent) : QObject(parent) {
  refreshing_.setInterval(kRefreshEvery);
  connect(&refreshing_, &QTimer::timeout, this, &CaseDocument::refreshLease);
}

void CaseDocument::release() {
  refreshing_.stop();
  lease_.reset();
  lost_.reset();
}

Result<void> CaseDocument::reserve() {
  if (lost_) return passOn(*lost_);
  if (!current_ || lease_ || isShipped_ || isPublished_) return {};
  auto taken = FolderLease::take(current_->folder);
  if (taken) {
    lease_ = std::move(*taken);
    refreshing_.start();
    return {};
  }
  // Where nothing can be written nobody edits; such a case is looked at, changed and saved elsewhere.
  if (FolderLease::holderOf(current_->folder)) return passOn(taken.error());
  return {};
}

void CaseDocument::refreshLease() {
  if (!lease_) return;
  auto still = lease_->refresh();
  if (still) return;
  release();
  lost_ = std::move(still.error());
  Q_EMIT leaseLost(*lost_);
  Q_EMIT changed();
}

void CaseDocument::open(Case opened, std::optional<Fingerprint> asRead) {
  release();
  current_ = std::move(opened);
  asRead_ = asRead;
  isShipped_ = isShipped(current_->folder);
  isPublished_ = isPublished(current_->folder);
  begin(*current_);
  tell();
  Q_EMIT this->opened();
}

void CaseDocument::close() {
  const bool wasOpen = current_.has_value();
  release();
  current_.reset();
  begin({});
  tell();
  if (wasOpen) Q_EMIT closed();
}

Result<void> CaseDocument::restore(Case left, const std::string& what, const Fingerprint& asRead) {
  auto done = edit(std::move(left), what, {});
  if (done) asRead_ = asRead;
  return done;
}

Result<void> CaseDocument::edit(Case next, const std::string& what, const std::string& mergeKey) {
  if (!current_) return failure(ErrorCode::badUsage, say<"No case is open; open one first.">());
  next.folder = current_->folder;
  if (next == *current_) return {};
  if (auto problems = checkCase(next); !problems.empty()) return passOn(std::move(problems.front()));
  // What was edited before the folder was lost may be finished, to be saved elsewhere.
  if (!lost_)
    if (auto reserved = reserve(); !reserved) return reserved;
  current_ = next;
  if (const Case* before = history_.beforeMerging(mergeKey); before != nullptr && *before == next)
    history_.forgetStep();  // a drag that was given back is no step
  else
    history_.step(std::move(next), what, mergeKey);
  tell();
  return {};
}

void CaseDocument::undo() {
  if (!history_.undo()) return;
  current_ = history_.now();
  tell();
}

void CaseDocument::redo() {
  if (!history_.redo()) return;
  current_ = history_.now();
  tell();
}

void CaseDocument::forgetSteps() {
  begin(history_.now());
  tell();
}

bool CaseDocument::isChangedOnDisk() const {
  if (!current_ || !asRead_) return false;
  // A manifest that is gone or cannot be read holds nothing that saving would destroy; saving itself says what is wrong with the folder.
  const auto now = manifestFingerprint(current_->folder);
  return now && *now != *asRead_;
}

Result<void> CaseDocument::save(const std::filesystem::path& folder, const CaseOverwrite& decided, const std::string& idThere) {
  if (!current_) return failure(ErrorCode::badUsage, say<"No case is open; open one first.">());
  const std::filesystem::path target = folder.empty() ? current_->folder : folder;
  const bool isElsewhere = target != current_->folder;
  if (isElsewhere ? isPublished(target) : isPublished_)
    return failure(ErrorCode::notWritable,
                   say<"Published cases are not edited in place, for attempts of trainees refer to them; save '%1' as a case of your own.">(
                       current_->title),
                   {{"file", target.string()}});
  if (!decided.shipped && (isElsewhere ? isShipped(target) : isShipped_))
    return failure(ErrorCode::notWritable,
                   say<"'%1' belongs to the program, and the next version replaces it; save the case as a copy of your own.">(target),
                   {{"file", target.string()}});
  if (!isElsewhere) {
    refreshLease();
    if (auto reserved = reserve(); !reserved) return reserved;
  }
  if (!isElsewhere && !decided.changedOnDisk && isChangedOnDisk())
    return failure(ErrorCode::notWritable,
                   say<"The case in '%1' was saved by another program since it was opened here; save it with File, Save case, which asks "
                       "what to keep.">(target),
                   {{"file", target.string()}});
  Case saved = *current_;
  if (isElsewhere) saved.id = idThere.empty() ? idForFolder(target) : idThere;
  if (auto done = saveCase(saved, target); !done) return done;
  auto asRead = manifestFingerprint(target);
  if (isElsewhere) {
    // Undo steps remember the folder they were made in; after a save under another name they would lead back to the old one.
    saved.folder = target;
    open(std::move(saved), asRead ? std::optional(*asRead) : std::nullopt);
    return {};
  }
  if (asRead) asRead_ = *asRead;
  history_.endMerging();
  saved_ = history_.kept();
  Q_EMIT changed();
  return {};
}

void CaseDocument::begin(Case first) {
  history_ = History<Case>(std::move(first));
  saved_ = history_.kept();
}

void CaseDocument::tell() {
  Q_EMIT changed();
  Q_EMIT stepped();
}

}  // namespace ew::ui
