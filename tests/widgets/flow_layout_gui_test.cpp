// Where widgets of known sizes come to lie.

#include <QVBoxLayout>
#include <QtTest>

#include "ew/widgets/flow_layout.h"

using ew::FlowLayout;

class FlowLayoutTest final : public QObject {
  Q_OBJECT

 private:
  /// 100, 60 and 80 px wide; the middle one is lower.
  struct Bar {
    QWidget window;
    FlowLayout* flow = new FlowLayout(4);
    QWidget* parts[3] = {new QWidget, new QWidget, new QWidget};
    explicit Bar(bool stretches = false) {
      const QSize sizes[] = {{100, 20}, {60, 10}, {80, 20}};
      for (int n = 0; n < 3; ++n) {
        parts[n]->setFixedSize(sizes[n]);
        if (stretches && n == 2) flow->addStretch();
        flow->addWidget(parts[n]);
      }
      window.setLayout(flow);
    }
    [[nodiscard]] QPoint at(int n) const { return parts[n]->pos(); }
    void show(int width_px) {
      window.resize(width_px, flow->heightForWidth(width_px));
      window.show();
      QVERIFY(QTest::qWaitForWindowExposed(&window));
      flow->setGeometry(QRect(0, 0, width_px, window.height()));
    }
  };

 private Q_SLOTS:
  void whatFitsIsOneLineWithItsMiddlesOnOneHeight() {
    Bar bar;
    QCOMPARE(bar.flow->heightForWidth(248), 20);
    bar.show(248);
    QCOMPARE(bar.at(0), QPoint(0, 0));
    QCOMPARE(bar.at(1), QPoint(104, 5));
    QCOMPARE(bar.at(2), QPoint(168, 0));
  }

  void whatDoesNotFitGoesOnInTheNextLine() {
    Bar bar;
    QCOMPARE(bar.flow->heightForWidth(247), 44);
    bar.show(247);
    QCOMPARE(bar.at(1), QPoint(104, 5));
    QCOMPARE(bar.at(2), QPoint(0, 24));
    QCOMPARE(bar.flow->heightForWidth(100), 20 + 4 + 10 + 4 + 20);
    QCOMPARE(bar.flow->minimumSize(), QSize(100, 20));
  }

  void whatIsHiddenTakesNoRoom() {
    Bar bar;
    bar.parts[0]->hide();
    bar.show(300);
    QCOMPARE(bar.at(1), QPoint(0, 5));
    QCOMPARE(bar.at(2), QPoint(64, 0));
  }

  void aStretchTakesWhatIsLeftOfItsLine() {
    Bar bar(true);
    bar.show(300);
    QCOMPARE(bar.at(1), QPoint(104, 5));
    QCOMPARE(bar.at(2), QPoint(220, 0));
    QCOMPARE(bar.flow->heightForWidth(248), 20);
  }

  void aFieldThatExpandsFillsItsLine() {
    Bar bar;
    bar.parts[1]->setMinimumSize(60, 10);
    bar.parts[1]->setMaximumSize(QWIDGETSIZE_MAX, 10);
    bar.parts[1]->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    bar.show(300);
    QCOMPARE(bar.parts[1]->geometry(), QRect(104, 5, 112, 10));
    QCOMPARE(bar.at(2), QPoint(220, 0));
  }

  void marginsCountAndRightToLeftIsMirrored() {
    Bar bar;
    bar.flow->setContentsMargins(8, 3, 8, 5);
    bar.window.setLayoutDirection(Qt::RightToLeft);
    QCOMPARE(bar.flow->heightForWidth(264), 28);
    bar.show(264);
    QCOMPARE(bar.at(0), QPoint(264 - 8 - 100, 3));
    QCOMPARE(bar.at(2), QPoint(8, 3));
    QCOMPARE(bar.flow->minimumSize(), QSize(116, 28));
  }
};

QTEST_MAIN(FlowLayoutTest)
#include "flow_layout_gui_test.moc"
