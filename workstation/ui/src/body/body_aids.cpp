#include "body/body_aids.h"

#include <QPointer>

#include "body/host_overlays.h"
#include "body/view3d.h"
#include "jobs/jobs.h"
#include "scan/session.h"

namespace ew::ui {

BodyAidsView::BodyAidsView(HostOverlays& overlays, Session& session, View3D& view, Jobs& jobs, QObject* parent)
    : QObject(parent), overlays_(overlays), session_(session), view_(view), jobs_(jobs) {
  connect(&overlays_, &HostOverlays::aidsChanged, this, &BodyAidsView::follow);
  connect(&session_, &Session::subjectChanged, this, &BodyAidsView::follow);
}

void BodyAidsView::follow() {
  const sdk::BodyAids* aids = overlays_.aids();
  if (aids == nullptr) return view_.setAids(std::nullopt);
  if (!aids->organs.empty()) makeOrgans(aids->organs);
  const bool hasOrgans = !aids->organs.empty() && made_ && made_->organs;
  view_.setAids(View3D::Aids{aids->translucentSkin, aids->volumeBox, hasOrgans ? made_->organs : nullptr});
}

void BodyAidsView::makeOrgans(const std::vector<int>& wanted) {
  const auto& subject = session_.subject();
  if (!subject || !subject->labels) {
    made_.reset();
    return;
  }
  if (made_ && made_->labels == subject->labels && made_->placed == subject->placedLabels && made_->wanted == wanted) return;
  made_ = std::make_shared<Made>(Made{subject->labels, subject->placedLabels, wanted, nullptr});
  auto result = std::make_shared<std::shared_ptr<const bridge::OrganSurfaces>>();
  jobs_.start(
      tr("Showing organs"),
      [made = made_, result](Progress& progress) -> Result<void> {
        auto organs = bridge::OrganSurfaces::of(*made->labels, made->placed, made->wanted, progress);
        if (!organs) return passOn(organs.error());
        *result = std::move(*organs);
        return {};
      },
      [view = QPointer<BodyAidsView>(this), made = made_, result](const Result<void>& done) {
        if (!view || view->made_ != made) return;
        if (!done) return view->made_.reset();  // asked for again, it is made again
        made->organs = *result;
        view->follow();
      },
      Jobs::Kind::background);
}

}  // namespace ew::ui
