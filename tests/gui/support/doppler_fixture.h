#pragma once

#include <QLabel>
#include <QMouseEvent>
#include <glm/gtc/constants.hpp>

#include "ew/imaging/flow_sampler.h"
#include "gui/support/console_fixture.h"

namespace ew::ui::testing {

/// A window whose patient's tissue and blood are known, and a mouse in its scan.
class DopplerFixture : public ConsoleFixture {
 protected:
  [[nodiscard]] ScanView& scan() const { return window_->scanView(); }
  /// Scanned with a linear probe that steers. @param field in the world
  void showFlowingBlood(const FlowField& field = {}) const {
    Probe linear;
    linear.id = "test-linear";
    linear.name = "Test linear";
    linear.kind = ProbeKind::linear;
    linear.carriers_hz = {5e6, 7.5e6};
    linear.carrier_hz = 7.5e6;
    linear.width_mm = 40.0;
    linear.defaultDepth_mm = 50.0;
    linear.maxSteering_rad = glm::radians(25.0);
    linear.trapezoidHalfAngle_rad = glm::radians(10.0);
    ScanSubject subject = *session().subject();
    auto tissue = recordedTissueOf(subject.voxels, subject.scene, 1, noProgress());
    QVERIFY(tissue.has_value());
    subject.know(*tissue);
    subject.flow = std::make_shared<const FlowSampler>(field);
    std::vector<Probe> all = session().console().allProbes();
    all.push_back(linear);
    subject.probes = {linear.id, "convex-3.5"};
    session().console().setProbes(all);
    session().show(subject);
    QCOMPARE(session().console().probe().id, linear.id);
    session().makeImageNow();
  }
  void moveTo(const QPoint& at, Qt::MouseButtons held) const {
    QMouseEvent move(QEvent::MouseMove, at, scan().mapToGlobal(at), Qt::NoButton, held, Qt::NoModifier);
    QApplication::sendEvent(&scan(), &move);
  }
  void drag(const QPoint& from, const QPoint& to) const {
    QTest::mousePress(&scan(), Qt::LeftButton, Qt::NoModifier, from);
    moveTo((from + to) / 2, Qt::LeftButton);
    moveTo(to, Qt::LeftButton);
    QTest::mouseRelease(&scan(), Qt::LeftButton, Qt::NoModifier, to);
  }
  void checkNothingIsClipped() const {
    for (const QLabel* label : window_->console().findChildren<QLabel*>())
      if (label->isVisible() && !label->wordWrap())
        QVERIFY2(label->width() >= label->sizeHint().width() - 1, qPrintable(label->objectName() + label->text()));
    for (const QAbstractButton* button : window_->console().findChildren<QAbstractButton*>())
      if (button->isVisible() && !button->text().isEmpty())
        QVERIFY2(button->width() >= button->minimumSizeHint().width() - 1, qPrintable(button->text()));
  }
};

}  // namespace ew::ui::testing
