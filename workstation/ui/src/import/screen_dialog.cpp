#include "import/screen_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMessageBox>
#include <QPointer>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

#include "ew/acquisition/screen_recording.h"
#include "ew/widgets/figures.h"
#include "ew/widgets/icons.h"
#include "ew/widgets/look.h"
#include "ew/widgets/qt_image.h"
#include "ew/widgets/question.h"
#include "ew/widgets/save_file.h"
#include "ew/widgets/small_result_question.h"
#include "ew/widgets/words.h"
#include "import/film_reader.h"
#include "import/import_fields.h"
#include "import/screen_distances.h"
#include "import/screen_view.h"
#include "import/screen_words.h"
#include "jobs/jobs.h"
#include "jobs/message_bar.h"
#include "measure/words/caliper_words.h"

namespace ew::ui {
namespace {

constexpr int kPlayTick_ms = 20;
constexpr int kPageFrames = 10;

QDoubleSpinBox* millimetres(const char* name, double most, const QString& tip) {
  auto* box = numberBox(name, 0.0, most, 1.0, 2, ScreenDialog::tr(" mm"));
  box->setSpecialValueText(ScreenDialog::tr("not said"));
  box->setKeyboardTracking(false);
  box->setToolTip(tip);
  return box;
}

std::optional<double> saidBy(const QDoubleSpinBox& box) { return box.value() > 0.0 ? std::optional(box.value()) : std::nullopt; }

}  // namespace

ScreenDialog::ScreenDialog(const QString& file, Jobs& jobs, MessageBar& messages, QWidget* parent)
    : FormDialog(QFileInfo(file).fileName(), file, parent), file_(file), jobs_(jobs), messages_(messages) {
  setObjectName(QStringLiteral("screenDialog"));
  setWindowTitle(tr("Film or recorded screen"));
  sentence().setObjectName(QStringLiteral("screenSentence"));
  addRows();
  progressTick_.setInterval(100);
  connect(&progressTick_, &QTimer::timeout, this, &ScreenDialog::showProgress);
  playTick_.setInterval(kPlayTick_ms);
  connect(&playTick_, &QTimer::timeout, this, &ScreenDialog::advance);
  look(std::nullopt);
}

ScreenDialog::~ScreenDialog() {
  // What is being written goes on, and the window says how it ended.
  if (job_ != 0 && !writing_) jobs_.cancel(job_);
  if (frameJob_ != 0) jobs_.cancel(frameJob_);
}

void ScreenDialog::addRows() {
  auto* form = new QFormLayout;
  form->setHorizontalSpacing(24);
  form->setVerticalSpacing(8);
  form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  addTurnRows(*form);
  shape_ = new QComboBox;
  shape_->setObjectName(QStringLiteral("screenShape"));
  shape_->addItem(tr("not found"), -1);
  shape_->addItem(tr("fan"), static_cast<int>(FanShape::convex));
  shape_->addItem(tr("straight sides"), static_cast<int>(FanShape::linear));
  shape_->setToolTip(tr("Shape of the scan's outline; another one begins anew and is then dragged into place"));
  form->addRow(tr("Outline"), shape_);
  connect(shape_, qOverload<int>(&QComboBox::activated), this, [this] {
    const int chosen = shape_->currentData().toInt();
    if (!edit_ || chosen < 0) return follow();
    const auto shape = static_cast<FanShape>(chosen);
    edit_->setOutline(edit_->outline() ? withShape(*edit_->outline(), shape)
                                       : outlineToBeginWith(shape, edit_->found().width_px, edit_->found().height_px));
    view_->setEdit(&*edit_);
    follow();
  });
  addScaleRows(*form);
  rows().addLayout(form);
  text_ = smallText("screenText");
  rows().addWidget(text_);
  again_ = new QPushButton(tr("Look again within this outline"));
  again_->setObjectName(QStringLiteral("screenAgain"));
  again_->setToolTip(tr("Looks for text and for the depth scale once more, with the outline as it was corrected"));
  back_ = new QPushButton(tr("Back to what was found"));
  back_->setObjectName(QStringLiteral("screenBack"));
  back_->setToolTip(tr("Takes back what was corrected of outline and boxes"));
  rows().addWidget(again_);
  rows().addWidget(back_);
  measure_ = new QPushButton(icon(QStringLiteral("caliper-distance")), tr("Measure distances"));
  measure_->setObjectName(QStringLiteral("screenMeasure"));
  measure_->setCheckable(true);
  measure_->setToolTip(tr("Click or drag from one end to the other, in any frame; Backspace takes the last one away"));
  rows().addWidget(measure_);
  distances_ = smallText("screenDistances");
  rows().addWidget(distances_);
  notes_ = smallText("screenNotes");
  setLook(notes_, Look::quiet);
  rows().addWidget(notes_);
  rows().addStretch(1);
  putBeside(viewWithFrames(), {1200, 640});

  close_ = new QPushButton(tr("Cancel"));
  close_->setObjectName(QStringLiteral("screenClose"));
  import_ = new QPushButton(tr("Import…"));
  import_->setObjectName(QStringLiteral("screenImport"));
  setLook(import_, Look::primary);
  import_->setToolTip(tr("Writes the cleaned recording; nothing else of it is stored"));
  for (auto* button : {again_, back_, measure_, close_, import_}) button->setAutoDefault(false);
  buttons().addWidget(close_);
  buttons().addWidget(import_);
  connect(close_, &QPushButton::clicked, this, &QDialog::reject);
  connect(import_, &QPushButton::clicked, this, &ScreenDialog::import);
  connect(again_, &QPushButton::clicked, this, [this] {
    if (edit_ && edit_->outline()) look(edit_->outline());
  });
  connect(back_, &QPushButton::clicked, this, [this] {
    if (!edit_) return;
    edit_->backToFound();
    view_->setEdit(&*edit_);
    follow();
  });
  connect(measure_, &QPushButton::toggled, this, [this](bool on) {
    view_->setMeasuring(on);
    measureAll();
    view_->setFocus();
  });
}

void ScreenDialog::addTurnRows(QFormLayout& form) {
  turn_ = new QComboBox;
  turn_->setObjectName(QStringLiteral("screenTurn"));
  for (int quarters = 0; quarters < 4; ++quarters)
    turn_->addItem(quarters == 0 ? tr("not turned") : tr("%1° clockwise").arg(90 * quarters), quarters);
  turn_->setToolTip(tr("Turns the images so that the probe's face lies on top; the recording is looked through anew"));
  mirror_ = new QCheckBox(tr("Mirrored"));
  mirror_->setObjectName(QStringLiteral("screenMirror"));
  mirror_->setToolTip(tr("Changes left and right of the images; the recording is looked through anew"));
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addWidget(turn_, 1);
  row->addWidget(mirror_);
  form.addRow(tr("Images"), row);
  connect(turn_, qOverload<int>(&QComboBox::activated), this, &ScreenDialog::turn);
  connect(mirror_, &QCheckBox::toggled, this, &ScreenDialog::turn);
}

void ScreenDialog::addScaleRows(QFormLayout& form) {
  depth_ = millimetres("screenDepth", 1000.0, tr("Depth of the scan as the screen states it, from its near to its far edge"));
  tick_ = millimetres("screenTick", 500.0, tr("Distance of neighbouring marks of the depth scale that was found"));
  scale_ = smallText("screenScale");
  form.addRow(tr("Depth of the scan"), depth_);
  form.addRow(tr("Distance of marks"), tick_);
  form.addRow(tr("Scale"), scale_);
  connect(depth_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this] {
    if (!edit_) return;
    edit_->setDepth_mm(saidBy(*depth_));
    follow();
  });
  connect(tick_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this] {
    if (!edit_) return;
    edit_->setTick_mm(saidBy(*tick_));
    follow();
  });
}

QWidget* ScreenDialog::viewWithFrames() {
  auto* column = new QWidget;
  auto* below = new QVBoxLayout(column);
  below->setContentsMargins(0, 0, 0, 0);
  below->setSpacing(8);
  view_ = new ScreenView;
  below->addWidget(view_, 1);
  progress_ = new QProgressBar;
  progress_->setObjectName(QStringLiteral("screenProgress"));
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  progress_->setAccessibleName(tr("How far the recording was read"));
  below->addWidget(progress_);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  play_ = new QPushButton;
  play_->setObjectName(QStringLiteral("screenPlay"));
  setLook(play_, Look::compact);
  play_->setAutoDefault(false);
  frames_ = new QSlider(Qt::Horizontal);
  frames_->setObjectName(QStringLiteral("screenFrames"));
  frames_->setAccessibleName(tr("Frame"));
  frames_->setToolTip(tr("Frame that is shown (arrows: a frame, with Shift ten; Home and End)"));
  frames_->setPageStep(kPageFrames);
  time_ = new FigureLabel(tr("%1 of %2   %3 s").arg(88888).arg(88888).arg(figure(888.88, 2)));
  time_->setObjectName(QStringLiteral("screenTime"));
  setLook(time_, Look::small);
  time_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  time_->setToolTip(tr("Which frame is shown, and how long after the first"));
  cleaned_ = new QCheckBox(tr("Cleaned"));
  cleaned_->setObjectName(QStringLiteral("screenCleaned"));
  cleaned_->setToolTip(tr("Shows the frames as they will be stored"));
  row->addWidget(play_);
  row->addWidget(frames_, 1);
  row->addWidget(time_);
  row->addWidget(cleaned_);
  below->addLayout(row);
  auto* hint = new QLabel(
      tr("Drag the round handles to the edges of the scan, and the square one to move all of it. Click a box to keep what is below it, or "
         "drag a new box over text. H and Ctrl with arrows do for the mouse."));
  setLook(hint, Look::quiet);
  setLook(hint, Look::small);
  hint->setWordWrap(true);
  below->addWidget(hint);
  connect(view_, &ScreenView::edited, this, &ScreenDialog::follow);
  connect(view_, &ScreenView::measured, this, &ScreenDialog::measureAll);
  connect(view_, &ScreenView::stepAsked, this, &ScreenDialog::step);
  connect(view_, &ScreenView::endAsked, this, [this](bool last) {
    setPlaying(false);
    wantFrame(last ? frames_->maximum() : 0);
  });
  connect(view_, &ScreenView::playAsked, this, [this] { setPlaying(!playTick_.isActive()); });
  connect(view_, &ScreenView::pauseAsked, this, [this] { setPlaying(false); });
  connect(play_, &QPushButton::clicked, this, [this] { setPlaying(!playTick_.isActive()); });
  connect(frames_, &QSlider::valueChanged, this, [this](int frame) {
    setPlaying(false);
    wantFrame(frame);
  });
  connect(cleaned_, &QCheckBox::toggled, this, [this](bool on) {
    ++changes_;
    view_->setMarksShown(!on);
    fetch();
  });
  setPlaying(false);
  return column;
}

void ScreenDialog::turn() {
  const Orientation asked{turn_->currentData().toInt(), mirror_->isChecked()};
  if (asked == turned_ || job_ != 0) return;
  turned_ = asked;
  tookBack_ = false;
  look(std::nullopt);
}

void ScreenDialog::showTurned(const Orientation& turned) {
  turned_ = turned;
  const QSignalBlocker quietTurn(turn_), quietMirror(mirror_);
  turn_->setCurrentIndex(turned.quarterTurns);
  mirror_->setChecked(turned.mirrored);
}

void ScreenDialog::look(const std::optional<FanOutline>& outline) {
  setPlaying(false);
  auto found = std::make_shared<std::shared_ptr<FilmReader>>();
  job_ = jobs_.start(
      tr("Reading %1").arg(QFileInfo(file_).fileName()),
      [found, outline, turned = turned_, file = pathOf(file_)](Progress& progress) -> Result<void> {
        auto opened = openScreen(file, outline, progress, {}, kScreenFrames, turned);
        if (!opened) return passOn(opened.error());
        *found = std::make_shared<FilmReader>(*std::move(opened));
        return {};
      },
      [here = QPointer<ScreenDialog>(this), found](const Result<void>& outcome) {
        ScreenDialog* const dialog = here.data();
        if (dialog == nullptr) return;
        dialog->job_ = 0;
        if (outcome) return dialog->take(*found);
        dialog->showTurned(dialog->edit_ ? dialog->edit_->correction().turned : Orientation{});
        dialog->setBusy(false);
        if (outcome.error().code != ErrorCode::cancelled) dialog->say(words(outcome.error().message), true);
      });
  setBusy(true);
  say(outline ? tr("Looking for text and the depth scale within the outline …") : tr("Reading the recording and looking for the scan …"),
      false);
}

void ScreenDialog::take(const std::shared_ptr<FilmReader>& opened) {
  opened_ = opened;
  view_->setEdit(nullptr);
  if (edit_)
    edit_->lookedAgain(opened->screen.found);
  else
    edit_.emplace(opened->screen.found);
  if (edit_->correction().turned != turned_) {
    tookBack_ = edit_->setTurned(turned_);
    drawings_.clear();
    shownFrame_ = -1;
  }
  const ScreenAnalysis& found = edit_->found();
  if (shownFrame_ < 0) view_->setImage(imageOf(viewOf(opened->screen.image)).copy(), {0, 0}, {found.width_px, found.height_px});
  view_->setEdit(&*edit_);
  const QSignalBlocker quiet(frames_);
  frames_->setRange(0, static_cast<int>(opened->screen.times_s.size()) - 1);
  tick_->setEnabled(found.ticks.has_value());
  setBusy(false);
  follow();
  fetch();
  view_->setFocus();
}

void ScreenDialog::showProgress() {
  for (const Jobs::Seen& seen : jobs_.seen())
    if (seen.id == job_) progress_->setValue(static_cast<int>(1000.0 * seen.fraction));
}

void ScreenDialog::setBusy(bool busy) {
  progress_->setVisible(busy);
  progress_->setValue(0);
  if (busy)
    progressTick_.start();
  else
    progressTick_.stop();
  const bool ready = !busy && edit_.has_value();
  for (QWidget* each : std::initializer_list<QWidget*>{turn_, mirror_, shape_, depth_, cleaned_, measure_, play_, frames_, view_})
    each->setEnabled(ready);
  tick_->setEnabled(ready && edit_->found().ticks);
  again_->setEnabled(ready && edit_->outline());
  back_->setEnabled(ready);
  import_->setEnabled(false);
  // What is being written does not stop because nobody watches.
  close_->setText(busy && !writing_ ? tr("Cancel") : tr("Close"));
  if (!busy && edit_) import_->setEnabled(edit_->geometry().has_value() && edit_->outline());
}

void ScreenDialog::follow() {
  if (!edit_) return;
  ++changes_;
  const auto geometry = edit_->geometry();
  {
    const QSignalBlocker quiet(shape_);
    const auto& outline = edit_->outline();
    shape_->setCurrentIndex(!outline ? 0 : outline->shape == FanShape::linear ? 2 : 1);
  }
  text_->setText(wordsOfBoxes(edit_->boxes()));
  scale_->setText(wordsOfScale(edit_->found().ticks, geometry));
  showNotes(geometry);
  const auto& said = edit_->correction();
  back_->setEnabled(job_ == 0 && (said.outline || !said.added.empty() || !said.removed.empty()));
  again_->setEnabled(job_ == 0 && said.outline.has_value());
  import_->setEnabled(job_ == 0 && geometry.has_value() && edit_->outline());
  if (!geometry)
    say(words(geometry.error().message), true);
  else if (!edit_->outline())
    say(tr("The outline of the scan was not found. Choose its shape and drag it into place, then look again within it."), false);
  else
    say(tr("Check the outline, the scale and the boxes of text. Everything outside the outline becomes black."), false);
  measureAll();
  if (cleaned_->isChecked()) fetch();
}

void ScreenDialog::showNotes(const Result<ScreenGeometry>& geometry) {
  QStringList lines;
  const auto add = [&lines](const std::vector<Message>& notes) {
    for (const Message& note : notes) lines << words(note);
  };
  add(opened_->notes);
  add(edit_->found().notes);
  if (opened_->screen.brokenOff) lines << words(opened_->screen.brokenOff->message);
  if (geometry) add(geometry->notes);
  if (tookBack_) lines << tr("What was corrected of outline and boxes was taken back: the images lie differently now.");
  notes_->setText(lines.join(QLatin1Char('\n')));
  notes_->setVisible(!lines.isEmpty());
}

void ScreenDialog::wantFrame(int frame) {
  wantedFrame_ = std::clamp(frame, 0, frames_->maximum());
  const QSignalBlocker quiet(frames_);
  frames_->setValue(wantedFrame_);
  fetch();
}

void ScreenDialog::fetch() {
  if (!opened_ || frameJob_ != 0 || writing_) return;
  if (wantedFrame_ == shownFrame_ && shownChanges_ == changes_) return;
  std::optional<ScreenGeometry> geometry;
  if (cleaned_->isChecked())
    if (auto now = edit_->geometry(); now && now->outline) geometry = *std::move(now);
  auto shown = std::make_shared<FilmFrame>();
  shown->frame = wantedFrame_;
  shown->changes = changes_;
  frameJob_ = jobs_.start(
      tr("Reading a frame"), [shown, geometry, opened = opened_](Progress& progress) { return opened->read(*shown, geometry, progress); },
      [here = QPointer<ScreenDialog>(this), shown, opened = opened_](const Result<void>& outcome) {
        ScreenDialog* const dialog = here.data();
        if (dialog == nullptr) return;
        dialog->frameJob_ = 0;
        if (opened != dialog->opened_) return dialog->fetch();  // turned meanwhile
        if (outcome) return dialog->takeFrame(*shown);
        dialog->setPlaying(false);
        if (outcome.error().code != ErrorCode::cancelled) dialog->say(words(outcome.error().message), true);
      },
      Jobs::Kind::background);
}

void ScreenDialog::takeFrame(const FilmFrame& shown) {
  shownFrame_ = shown.frame;
  shownChanges_ = shown.changes;
  view_->setImage(shown.image, shown.at, {edit_->found().width_px, edit_->found().height_px});
  const auto& times_s = opened_->screen.times_s;
  time_->setText(tr("%1 of %2   %3 s")
                     .arg(shownFrame_ + 1)
                     .arg(times_s.size())
                     .arg(figure(times_s[static_cast<std::size_t>(shownFrame_)] - times_s.front(), 2)));
  measureAll();
  fetch();
}

void ScreenDialog::setPlaying(bool playing) {
  if (playing && (!opened_ || writing_ || frames_->maximum() < 1)) playing = false;
  if (playing && !playTick_.isActive()) {
    playTime_s_ = opened_->screen.times_s[static_cast<std::size_t>(wantedFrame_)];
    playTick_.start();
  } else if (!playing) {
    playTick_.stop();
  }
  const QString tip = playing ? tr("Stop (space)") : tr("Play in a loop (space)");
  play_->setIcon(icon(playing ? QStringLiteral("pause") : QStringLiteral("play")));
  play_->setToolTip(tip);
  play_->setAccessibleName(tip);
}

void ScreenDialog::advance() {
  // A frame that is still being read is waited for, and the time it takes is not made up for.
  if (frameJob_ != 0) return;
  const auto& times_s = opened_->screen.times_s;
  playTime_s_ += 1e-3 * kPlayTick_ms;
  const auto next = std::upper_bound(times_s.begin(), times_s.end(), playTime_s_);
  if (next == times_s.end() && wantedFrame_ == frames_->maximum()) {
    playTime_s_ = times_s.front();
    return wantFrame(0);
  }
  wantFrame(std::max(0, static_cast<int>(next - times_s.begin()) - 1));
}

void ScreenDialog::step(int frames) {
  setPlaying(false);
  wantFrame(wantedFrame_ + frames);
}

void ScreenDialog::keyPressEvent(QKeyEvent* event) {
  // Enter in a field takes what was typed; it must not end the dialog.
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) return;
  if (event->key() == Qt::Key_Space) return setPlaying(!playTick_.isActive());
  FormDialog::keyPressEvent(event);
}

measurement::CaliperDrawing& ScreenDialog::drawing() {
  auto& drawing = drawings_.try_emplace(shownFrame_, shownFrame_).first->second;
  if (!drawing.tool()) drawing.take(measurement::CaliperKind::distance);
  return drawing;
}

void ScreenDialog::measureAll() {
  if (!edit_ || shownFrame_ < 0) return;
  const auto found = drawings_.find(shownFrame_);
  measurement::CaliperDrawing* const drawn = measure_->isChecked() ? &drawing() : found == drawings_.end() ? nullptr : &found->second;
  view_->setDrawing(measure_->isChecked() ? drawn : nullptr);
  ScreenDistances now;
  if (drawn != nullptr) {
    const auto geometry = edit_->geometry();
    now = distancesOf(*drawn, geometry ? geometry->pixel_mm : std::nullopt, view_->scale());
  }
  if (measure_->isChecked() && now.lines.isEmpty()) now.lines << CaliperWords::hintOf(measurement::CaliperKind::distance);
  view_->setLabels(std::move(now.labels));
  distances_->setText(now.lines.join(QLatin1Char('\n')));
}

bool ScreenDialog::isUnsaved() const { return edit_ && !(edit_->correction() == ScreenCorrection()) && !(edit_->correction() == written_); }

bool ScreenDialog::mayLeaveWriting() {
  QMessageBox question(this);
  question.setObjectName(QStringLiteral("writingScreenQuestion"));
  question.setIcon(QMessageBox::NoIcon);
  question.setText(tr("The cleaned recording of '%1' is still being written.").arg(QFileInfo(file_).fileName()));
  question.setInformativeText(tr("If you close the dialog now and writing fails, what you corrected is lost."));
  auto* close = question.addButton(tr("Close anyway"), QMessageBox::DestructiveRole);
  close->setObjectName(QStringLiteral("closeWhileWriting"));
  question.setDefaultButton(question.addButton(QMessageBox::Cancel));
  question.exec();
  return question.clickedButton() == close && (writing_ || !isUnsaved());  // it may have failed meanwhile
}

bool ScreenDialog::mayLeave(bool waits) {
  if (!isUnsaved()) return true;
  if (writing_ && edit_->correction() == *writing_) return waits || mayLeaveWriting();
  const auto answer = askBeforeLeaving(
      this,
      {"unsavedScreenQuestion", tr("What you corrected in '%1' is not written to a recording.").arg(QFileInfo(file_).fileName()), {}});
  if (answer == QMessageBox::Discard) return true;
  return answer == QMessageBox::Save && import() && waits;
}

void ScreenDialog::reject() {
  if (mayLeave(false)) FormDialog::reject();
}

bool ScreenDialog::import() {
  if (!edit_ || !opened_) return false;
  if (job_ != 0) {
    say(tr("Nothing was saved, because the recording is still being worked on. Save again when that has ended."), true);
    return false;
  }
  setPlaying(false);
  const auto geometry = edit_->geometry();
  if (!geometry) {
    say(words(geometry.error().message), true);
    return false;
  }
  CleaningOptions cleaning;
  cleaning.acceptsSmall = edit_->correction().outline.has_value();  // who draws it has looked
  if (geometry->outline && !cleaning.acceptsSmall)
    if (const Message small = questionAbout(keptOf(opened_->screen, *geometry, cleaning), pathOf(file_)); !small.empty()) {
      if (!askAcceptsSmall(this, words(small))) return false;
      cleaning.acceptsSmall = true;
    }
  const QFileInfo info(file_);
  const QString target =
      askSaveFile(this, {tr("Save the cleaned recording"),
                         info.path() + QLatin1Char('/') + tr("%1 cleaned").arg(info.baseName()) + QStringLiteral(".igs.mha"),
                         tr("Sequences (*.igs.mha)"),
                         {QStringLiteral(".igs.mha")},
                         [](const QString& file) {
                           return QStringList{file, wordsOf(screenFileBeside(pathOf(file)))};
                         },
                         {},
                         {pathOf(file_)}});
  if (target.isEmpty()) return false;
  auto cleaned = std::make_shared<ScreenCleaning>();
  writing_ = edit_->correction();
  // Once it runs it ends whether the dialog is there or not: it takes all it needs along.
  job_ = jobs_.start(
      tr("Writing %1").arg(QFileInfo(target).fileName()),
      [opened = opened_, geometry = *geometry, cleaning, correction = edit_->correction(), found = edit_->found(), cleaned,
       file = pathOf(target)](Progress& progress) -> Result<void> {
        const std::lock_guard<std::mutex> alone(opened->mutex);
        const auto beside = screenFileBeside(file);
        return saveTogether({file, beside}, [&](const OutputSet& outputs) -> Result<void> {
          auto written = writeCleaned(opened->screen, geometry, cleaning, outputs.staged(file), progress);
          if (!written) return passOn(written.error());
          *cleaned = *std::move(written);
          return writeScreen(found, correction, outputs.staged(beside));
        });
      },
      [here = QPointer<ScreenDialog>(this), messages = QPointer<MessageBar>(&messages_), cleaned, target](const Result<void>& outcome) {
        const std::vector<Message> removed = outcome ? sentencesOf(cleaned->removed) : std::vector<Message>();
        const QString topic = QStringLiteral("save ") + target;
        if (messages && outcome) messages->showNote(tr("The cleaned recording was written to %1.").arg(target), topic);
        if (ScreenDialog* const dialog = here.data(); dialog != nullptr) return dialog->endImport(target, outcome, removed);
        if (messages && !outcome && outcome.error().code != ErrorCode::cancelled) messages->showError(outcome.error(), topic);
      },
      Jobs::Kind::saving);
  setBusy(true);
  say(tr("Writing the cleaned recording to %1 …").arg(target), false);
  return true;
}

void ScreenDialog::endImport(const QString& target, const Result<void>& outcome, const std::vector<Message>& removed) {
  job_ = 0;
  const auto correction = std::exchange(writing_, std::nullopt);
  if (outcome && correction) written_ = *correction;
  setBusy(false);
  follow();
  fetch();
  if (!outcome) {
    if (outcome.error().code == ErrorCode::cancelled)
      say(tr("Writing was stopped; nothing was stored."), false);
    else
      say(words(outcome.error().message), true);
    return;
  }
  QStringList lines{tr("The cleaned recording was written to %1. Nothing else of it was stored.").arg(target)};
  for (const Message& sentence : removed) lines << words(sentence);
  say(lines.front(), false);
  sentence().setToolTip(lines.join(QLatin1Char('\n')));
  Q_EMIT written(target);
}

}  // namespace ew::ui
