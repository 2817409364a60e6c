#include "import/opener_scan.h"

#include <utility>

#include "body/hand_input.h"
#include "body/view3d.h"
#include "case/case_preparation.h"
#include "ew/core/quiet_work.h"
#include "ew/library/first_look.h"
#include "ew/scanning/contact.h"
#include "import/opener.h"
#include "jobs/message_bar.h"

// From what was opened to the scan: whose volume it is, where the probe begins, and what becomes of it when the case is edited.

namespace ew::ui {
namespace {

constexpr int kQuiet = 19;  ///< what nobody waits for gives way to everything else

/// The box of a case's volume, which lies in the world when it was read.
PlacingShape shapeInWorld(const Case& opened, const CaseContents& read) {
  SweepAxes axes;
  if (const auto own = sweepAxesOf(opened)) {
    const glm::dmat3 turned(read.fileToWorld.matrix);
    axes = {turned * own->depth, turned * own->lateral};
  }
  return placingShapeOf(read.voxels.grid(), axes);
}

}  // namespace

QString openingTopic() { return QStringLiteral("open"); }

glm::dvec3 centreOf(const Grid& grid) {
  const Bounds bounds = boundsOf(grid);
  return (bounds.lowest_mm + bounds.highest_mm) / 2.0;
}

Skin::Contact skinInFrontOf(const Skin& skin, const glm::dvec3& p_mm) {
  const auto hit = skin.hit({p_mm.x, -2000.0, p_mm.z}, {0.0, 1.0, 0.0});
  return hit ? *hit : skin.nearest(p_mm);
}

void Opener::showCaseVolume() {
  const auto& opened = document_.current();
  if (!opened || !contents_) return;
  if (!(contents_->sources == sourcesOf(*opened))) {
    refused_.reset();
    loadChanged(*opened);
    return;
  }
  if (mayScanCase(contents_->sources)) scanCase();
}

/// The volume is the patient: the same in another body, with other labels or another level, is nobody else.
Session::Patient Opener::patientOf(const Sources& next) const {
  if (!patient_) return Session::Patient::another;
  CaseVolume before = *patient_, now = next.volume;
  for (CaseVolume* volume : {&before, &now}) {
    volume->labels.clear();
    volume->level.clear();
  }
  return before == now ? Session::Patient::same : Session::Patient::another;
}

bool Opener::mayScanCase(const Sources& next) const {
  return patientOf(next) == Session::Patient::same || mayScan_(shownTitle(*document_.current()));
}

void Opener::stayWith(const Sources& refused) {
  refused_ = refused;
  showsCase_ = false;
  if (const std::string& file = contents_->sources.volume.file; patient_ && !file.empty())
    shownFrom_ = {document_.current()->folder / file};
  messages_.showNote(tr("The scan stays as it was; the case holds another volume now. View, Scan the case's volume takes it."),
                     openingTopic());
}

void Opener::scanCase() {
  const auto& opened = document_.current();
  const Session::Patient patient = patientOf(contents_->sources);
  patient_ = contents_->sources.volume;
  showsCase_ = true;
  startTaken_ = false;
  shownFrom_.clear();
  if (hasNoVolume(*opened)) return session_.clear(patient);
  session_.show(subjectOf(*opened, contents_->read), patient);
  if (opened->probes.empty()) lookAtWhole(shapeInWorld(*opened, contents_->read));
  // A case may ask for them without naming the level of its volume.
  if (Scene scene = session_.console().scene(); opened->scene.liveEchoes && !scene.liveEchoes) {
    scene.liveEchoes = opened->scene.liveEchoes;
    session_.console().setScene(scene);
  }
  takeStart();
  if (showsDraft()) Q_EMIT draftShown();
}

void Opener::refine() {
  const auto& opened = document_.current();
  if (!opened || !contents_ || !contents_->read.isDraft || refineJob_ != 0) return;
  auto read = std::make_shared<Contents>();
  read->sources = contents_->sources;
  refineJob_ = jobs_.start(
      tr("Reading the finer volume"),
      [read, opened = *opened](Progress& progress) -> Result<void> {
        const QuietWork quietly(kQuiet);
        auto made = readContents(opened, progress);
        if (!made) return passOn(made.error());
        read->read = std::move(*made);
        return {};
      },
      [this, read](const Result<void>& outcome) {
        refineJob_ = 0;
        if (!outcome) {
          if (outcome.error().code != ErrorCode::cancelled) messages_.showError(outcome.error(), openingTopic());
          return;
        }
        finer_ = std::move(*read);
        takeFiner();
      },
      Jobs::Kind::background);
}

void Opener::takeFiner() {
  const auto& opened = document_.current();
  const bool isWanted = finer_ && opened && contents_ && contents_->read.isDraft && contents_->sources == finer_->sources;
  if (isWanted && showsCase_ && !session_.canRefine()) return finerSoon_.start();
  finerSoon_.stop();
  const auto finer = std::exchange(finer_, std::nullopt);
  if (!isWanted) return;
  contents_->read = finer->read;
  if (!showsCase_) return;
  session_.refine(subjectOf(*opened, contents_->read));
  Q_EMIT refined();
}

void Opener::lookAtWhole(const PlacingShape& shape) {
  if (showsWhole(shape, session_.console().depth_mm())) return;
  const auto look = firstLookAt(shape, session_.console().probes());
  if (!look) return;
  session_.console().chooseProbe(look->probe);
  Knobs knobs = session_.console().knobs();
  knobs.depth_mm = look->depth_mm;
  session_.console().setKnobs(knobs);
}

void Opener::followEdits(const Case& edited) {
  if (!showsCase_ || !session_.subject()) return;
  session_.setTitle(titleForTrainees(edited));
  session_.setCaseScene(sceneWithTissues(edited.scene, contents_->read.tissues));
  session_.place(ownToWorldOf(edited, contents_->read));
}

void Opener::takeStart() {
  if (!session_.subject()) return;
  const std::shared_ptr<const Skin> skin = view_.skin();
  session_.probeControl().setSkin(skin);
  Hold hold;
  if (const auto& start = session_.subject()->startPose) {
    hold = holdFor(*start, *skin);
  } else {
    hold.contact = skinInFrontOf(*skin, centreOf(session_.subject()->placedGrid));
    hold.press_mm = usualPress_mm(session_.console().probe());
  }
  // Before the mannequin is there the skin is a rough ellipsoid: the start is taken again when it comes.
  startTaken_ = view_.scene().mannequin() != nullptr;
  hand_.setStartHold(hold);
  session_.probeControl().setHold(hold);
}

}  // namespace ew::ui
