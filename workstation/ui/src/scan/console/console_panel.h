#pragma once

#include <QWidget>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "scan/session.h"

class QBoxLayout;
class QCheckBox;
class QHBoxLayout;
class QLabel;
class QMenu;
class QPushButton;
class QSlider;
class QTabWidget;
class QVBoxLayout;

namespace ew {
struct EffectInfo;
struct EffectOption;
struct EffectStrength;
}  // namespace ew

namespace ew::ui {

class KeyTips;

/// The machine's front panel. Gain and depth are always under the thumb, and so are mode, orientation and freeze; between them lie four
/// pages: the image, Doppler, the effects of the scene, the probe. It shows and sets the session's knobs and scene; the DGC sliders
/// stand beside the image (dgc_column.h). What is off looks off; what a probe does not have is not there.
class ConsolePanel final : public QWidget {
  Q_OBJECT

 public:
  explicit ConsolePanel(Session& session, QWidget* parent = nullptr);

  /// What a key does to the control of that name: moves a slider by its page steps, presses a button or a switch, takes the next of a
  /// choice. A control that is off or not there does nothing.
  void step(const QString& control, int steps);
  void chooseQuality(Quality quality);
  void showNextPage();
  /// One more page, behind the others.
  void addPage(QWidget* page, const QString& title, const QString& tip);
  /// One more row of what is always there, below the pages.
  void addBelow(QWidget* row);
  void showPage(const QWidget* page);
  /// In a low window gain and depth take a line each, and all but freeze scrolls with the first page.
  void setShort(bool isShort);
  /// The button at the head of the first page unfolds it. It outlives the panel's use of it.
  void setPresetMenu(QMenu& menu);
  /// What the console was set to just now; it is named until something is moved.
  void showPreset(const QString& title);
  void refreshIcons();
  void showKeys(const KeyTips& tips);  ///< in the tips of the pages, which are no widgets of their own

  /// Names of the switch and of the slider that belong to an effect or to a part of one (effect_info.h).
  [[nodiscard]] static QString switchOf(const char* effectKey);
  [[nodiscard]] static QString strengthOf(const char* effectKey);

 Q_SIGNALS:
  void boxZoomAsked();
  void wideAsked();
  void costAsked();  ///< the Cost of accuracy panel is wanted

 private:
  struct SliderParts {
    QString name, objectName, widest, tip;
    int lowest = 0;
    int highest = 100;
    int page = 10;
    std::function<int()> get;
    std::function<void(int)> set;
    std::function<QString()> text;
    std::function<bool()> isOn = [] { return true; };     ///< off: grey
    std::function<bool()> isThere = [] { return true; };  ///< not there: hidden
    std::function<std::pair<int, int>()> range = {};
    std::function<int()> pageNow = {};  ///< where it changes with the range
    std::function<int()> neutral = {};  ///< where a double click puts it
  };
  struct Choice {
    QString text, objectName, tip;
    std::function<bool()> isThere = {};  ///< empty: always
    QString accessibleName = {};         ///< empty: the text says it
  };
  struct ChoiceParts {
    QString name, objectName;
    std::vector<Choice> choices;
    std::function<int()> get;
    std::function<void(int)> set;
    std::function<bool()> isOn = [] { return true; };
    std::function<bool()> isThere = [] { return true; };
    bool isInline = false;    ///< the name stands left of the buttons
    std::size_t perLine = 9;  ///< buttons side by side; further ones go below
  };
  /// Without a name the value is told by the tooltip alone.
  QSlider* addSlider(QBoxLayout* rows, SliderParts parts);
  void addSegments(QBoxLayout* rows, ChoiceParts parts);
  QCheckBox* addSwitch(QBoxLayout* rows, const QString& name, const QString& objectName, const QString& tip);
  /// Rows that stand open only when they are asked for; whether they are is remembered.
  QVBoxLayout* addFold(QBoxLayout* rows, const QString& title, const QString& objectName, const QString& tip);
  /// No more room than the longest page needs: what is left lies below everything.
  void fitPages();
  QWidget* makePage(const std::function<void(QVBoxLayout*)>& fill);
  void addGain(QBoxLayout* rows);
  void addPresets(QVBoxLayout* rows);
  void placeLines();
  void addImagePage(QVBoxLayout* rows);
  void addGreyMaps(QVBoxLayout* rows);
  void addCompounding(QVBoxLayout* rows);
  void addHarmonics(QVBoxLayout* rows);
  [[nodiscard]] bool formsAnew() const;
  void addGainLaws(QVBoxLayout* rows);
  void addZoomButtons(QVBoxLayout* rows);
  void addAdvanced(QVBoxLayout* rows);
  void addDopplerPage(QVBoxLayout* rows);
  void addColourPart(QVBoxLayout* rows);
  void addSpectrumPart(QVBoxLayout* rows);
  void addModes(QVBoxLayout* rows);
  void addEffectsPage(QVBoxLayout* rows);
  void addProbePage(QVBoxLayout* rows);
  void addTransducers(QVBoxLayout* rows);
  void addFrequencies(QVBoxLayout* rows);
  void addSteering(QVBoxLayout* rows);
  void addFacts(QVBoxLayout* rows);
  void addFact(QVBoxLayout* rows, const QString& name, const QString& widest, std::function<QString()> text);
  void addAlways(QVBoxLayout* rows);
  void addEffect(QVBoxLayout* rows, const EffectInfo& effect);
  void addStrength(QVBoxLayout* rows, const EffectInfo& effect, const EffectStrength& strength);
  void addOption(QVBoxLayout* rows, const EffectInfo& effect, const EffectOption& option);
  void setFoci(int count);
  void showAll();
  void change(const std::function<void(Knobs&)>& apply);
  void changeScene(const std::function<void(Scene&)>& apply);
  static QLabel* quietLabel(const QString& text);
  static int rounded(double value) { return static_cast<int>(std::lround(value)); }

  Session& session_;
  bool showing_ = false;
  std::vector<std::function<void()>> shows_;  ///< each brings one control to what the session says
  Scene remembered_;                          ///< an effect that is switched on again has the strength it had
  class DopplerPart;
  class ColourPart;
  class SpectrumPart;
  std::shared_ptr<DopplerPart> colourPart_, spectrumPart_;
  bool showsSpectrumPart_ = false;  ///< of the page of Doppler
  QTabWidget* pages_ = nullptr;
  std::vector<QString> pageTips_;
  std::vector<QPushButton*> folds_;
  QPushButton* flip_ = nullptr;
  QPushButton* turn_ = nullptr;
  QPushButton* freeze_ = nullptr;
  QPushButton* preset_ = nullptr;
  QString presetTitle_;
  std::optional<Knobs> presetKnobs_;  ///< as they were when it was taken
  /// A slider whose name and value stand above it, or at its sides.
  struct Line {
    QVBoxLayout* column;
    QHBoxLayout* line;
    QSlider* slider;
    QLabel* name;
  };
  std::vector<Line> lines_;     ///< all that have a name
  std::vector<Line> topLines_;  ///< gain and depth
  bool isShort_ = false;
  QVBoxLayout* firstPage_ = nullptr;
  QVBoxLayout* bottom_ = nullptr;
  QWidget* alwaysBox_ = nullptr;  ///< mode, orientation, number of images: below the pages, or at the end of the first one
  QVBoxLayout* always_ = nullptr;
};

}  // namespace ew::ui
