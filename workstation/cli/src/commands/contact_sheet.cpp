#include "commands/contact_sheet.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "ew/imaging/caption.h"
#include "ew/imaging/effect_info.h"
#include "ew/scanning/scanner.h"

namespace ew::cli {
namespace {

constexpr int kColumns = 6;
constexpr int kName_px = 18;     // below each tile
constexpr int kWarning_px = 30;  // below all

struct Tile {
  std::string name;
  RgbImage image;
};

/// One tile's setting: the console, the scene, and what happens before the image is taken.
struct Setting {
  Probe probe;
  Pose pose;
  Knobs knobs;
  Scene scene;
  bool withLabels = true;
  std::vector<float> gaps_mm = {};
  BodyState body = {};
  int frames = 1;         ///< the last one is shown
  double slide_mm = 0.0;  ///< along the face, from the first frame to the last
  double secondsPerFrame = 0.0;
  bool showsStrip = false;
};

/// The pose moved along the probe's own x.
Pose slid(const Pose& pose, double x_mm) {
  Pose moved = pose;
  moved.probeToWorld.matrix[3] += x_mm * pose.probeToWorld.matrix[0];
  return moved;
}

/// The pose turned about the probe's own z through the middle of its face.
Pose rocked(const Pose& pose, double angle_deg) {
  Pose turned = pose;
  turned.probeToWorld.matrix = pose.probeToWorld.matrix * glm::rotate(glm::dmat4(1.0), glm::radians(angle_deg), glm::dvec3(0, 0, 1));
  return turned;
}

RgbImage imageOf(const SheetSource& source, const Setting& setting, const glm::ivec2& size_px) {
  Scanner scanner;
  ScanSubject subject = source.subject;
  if (!setting.withLabels) subject.labels = nullptr;
  scanner.show(std::move(subject));
  ScanState state{.probe = setting.probe,
                  .knobs = setting.knobs,
                  .pan = {},
                  .scene = setting.scene,
                  .pose = {},
                  .gaps_mm = setting.gaps_mm,
                  .body = setting.body};
  DisplayImage shown;
  for (int n = 0; n < setting.frames; ++n) {
    state.pose = slid(setting.pose, setting.frames > 1 ? setting.slide_mm * (static_cast<double>(n) / (setting.frames - 1) - 1.0) : 0.0);
    state.number = static_cast<std::uint64_t>(n);
    state.time_s = n * setting.secondsPerFrame;
    shown = scanner.make(state, size_px.x, size_px.y);
  }
  if (setting.showsStrip) shown = {scanner.strip()};
  return composed(shown);
}

/// In the small letters that captions have.
std::string lowerCase(std::string text) {
  for (char& letter : text) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return text;
}

RgbImage arranged(const std::vector<Tile>& tiles, const glm::ivec2& tile_px) {
  const int rows = (static_cast<int>(tiles.size()) + kColumns - 1) / kColumns;
  RgbImage sheet(kColumns * tile_px.x, rows * (tile_px.y + kName_px) + kWarning_px);
  for (std::size_t n = 0; n < tiles.size(); ++n) {
    const int left = static_cast<int>(n % kColumns) * tile_px.x, top = static_cast<int>(n / kColumns) * (tile_px.y + kName_px);
    const RgbImage& image = tiles[n].image;
    for (int y = 0; y < image.height; ++y) std::copy_n(viewOf(image).row(y), image.width, viewOf(sheet).row(top + y) + left);
    const ImageView<Rgb> below{viewOf(sheet).row(top + tile_px.y) + left, tile_px.x, kName_px, sheet.width};
    burnCaption(below, tiles[n].name);
  }
  return sheet;
}

/// Two tiles: without something and with it.
struct Pair {
  std::string off, on;                         ///< their names
  std::function<void(Setting&)> both, change;  ///< `both` for the first, then `change` for the second
};

/// Collects tiles of settings that differ from a plain one.
class Sheet {
 public:
  Sheet(const SheetSource& source, const glm::ivec2& tile_px) : source_(source), tile_px_(tile_px) {
    plain_.probe = source.probe;
    plain_.pose = source.pose;
    plain_.scene.recordedDynamicRange_db = source.subject.scene.recordedDynamicRange_db;
    plain_.scene.tissues = source.subject.scene.tissues;
  }

  void add(const std::string& name, const Setting& setting) { tiles_.push_back({lowerCase(name), imageOf(source_, setting, tile_px_)}); }
  void add(const Pair& pair) {
    Setting setting = plain_;
    if (pair.both) pair.both(setting);
    add(pair.off, setting);
    pair.change(setting);
    add(pair.on, setting);
  }
  void add(const std::vector<Pair>& pairs) {
    for (const Pair& pair : pairs) add(pair);
  }
  [[nodiscard]] const Setting& plain() const { return plain_; }
  [[nodiscard]] RgbImage image() const { return arranged(tiles_, tile_px_); }

 private:
  const SheetSource& source_;
  glm::ivec2 tile_px_;
  Setting plain_{};
  std::vector<Tile> tiles_;
};

/// How an effect of the scene is shown: off and on; those that need something to act on get it.
Pair pairOf(const EffectInfo& effect, const SheetSource& source) {
  Pair pair{"no " + std::string(effect.shortName), effect.shortName, {}, [&effect](Setting& s) { effect.switchTo(s.scene, true); }};
  const std::string_view key = effect.key;
  if (key == "gain_and_dgc") {  // on already, and neutral
    pair.off = "plain";
    pair.change = [](Setting& s) {
      s.knobs.gain = 1.2;
      s.knobs.dgc = {0.6, 0.8, 1.0, 1.1, 1.2, 1.3, 1.4, 1.5};
    };
  } else if (key == "focus") {
    pair.off = "focus off";
    pair.on = "focus near, 40 mm";
    pair.both = [](Setting& s) { s.knobs.focus_mm = 40.0; };
  } else if (key == "attenuation") {
    pair.off = "no shadow";  // the whole name is wider than a small tile
    pair.on = "shadow by tissue";
  } else if (key == "reverberation") {
    pair.both = [&source](Setting& s) { s.pose = source.interfacePose; };
  } else if (key == "noise") {
    pair.both = [](Setting& s) { s.scene.attenuation.emplace(); };
  } else if (key == "motion") {  // breathed in, of what is formed live
    pair.both = [](Setting& s) {
      s.scene.liveEchoes.emplace();
      s.body.breath = 1.0;
    };
  } else if (key == "contact") {
    pair = {"full contact", "a third in air", pair.change, [](Setting& s) {
              s.gaps_mm.assign(96, 0.0F);
              std::fill_n(s.gaps_mm.begin(), 32, 20.0F);
            }};
  }
  return pair;
}

std::vector<Pair> pairsOfMethods(const SheetSource& source) {
  const double far_mm = 0.75 * source.probe.defaultDepth_mm;
  return {{"focus far, kernel", "focus far, row stretch",
           [far_mm](Setting& s) {
             s.scene.focus.emplace();
             s.knobs.focus_mm = far_mm;
           },
           [](Setting& s) { s.knobs.focusMethod = FocusMethod::rowStretch; }},
          {"shadow by grey level", "shadow, probe rocked",
           [](Setting& s) {
             s.scene.attenuation.emplace();
             s.withLabels = false;
           },
           [](Setting& s) {
             s.withLabels = true;
             s.pose = rocked(s.pose, 20.0);
           }}};
}

std::vector<Pair> pairsOfKnobs() {
  return {{"range 60 db",
           "range 50 db, soft map",
           {},
           [](Setting& s) {
             s.knobs.dynamicRange_db = 50.0;
             s.knobs.greyMap = GreyMap::soft;
           }},
          {"no edges", "edge enhancement", {}, [](Setting& s) { s.knobs.edgeEnhancement = 0.8; }},
          {"moving", "moving, persistence",
           [](Setting& s) {
             s.frames = 12;
             s.slide_mm = 12.0;
           },
           [](Setting& s) { s.knobs.persistence = 0.85; }},
          {"upside down", "m-mode, sliding", [](Setting& s) { s.knobs.upsideDown = true; },
           [](Setting& s) {
             s.knobs.upsideDown = false;
             s.knobs.mode = DisplayMode::mMode;
             s.frames = 90;
             s.slide_mm = 24.0;
             s.secondsPerFrame = s.knobs.mSweep_s / 90.0;
             s.showsStrip = true;
           }}};
}

std::vector<Pair> pairsOfWholeScenes(const SheetSource& source) {
  const Scene& asked = source.subject.scene;
  std::vector<Pair> pairs{{"nothing on", "as the case asks", {}, [asked](Setting& s) { s.scene = asked; }},
                          {"everything, weave", "everything, cubic",
                           [asked](Setting& s) {
                             s.scene = sceneWithEverything();
                             s.scene.recordedDynamicRange_db = asked.recordedDynamicRange_db;
                             s.scene.tissues = asked.tissues;
                             s.knobs.quality = Quality::weave;
                           },
                           [](Setting& s) { s.knobs.quality = Quality::cubic; }}};
  // Of echoes formed anew.
  if (source.subject.tissue && !source.subject.tissue->isRecorded)
    pairs.push_back({"three directions", "harmonics",
                     [asked](Setting& s) {
                       s.scene = asked;
                       s.scene.liveEchoes.emplace();
                       s.knobs.compoundAngles = 3;
                     },
                     [](Setting& s) {
                       s.knobs.compoundAngles = 1;
                       s.knobs.harmonic = true;
                     }});
  return pairs;
}

void addProbe(Sheet& sheet, const Probe& probe, const Scene& scene) {
  Setting setting = sheet.plain();
  setting.probe = probe;
  setting.scene = scene;
  sheet.add(probe.id, setting);
  if (probe.maxSteering_rad > 0.0) {
    setting.knobs.steering_rad = probe.maxSteering_rad;
    sheet.add(probe.id + ", steered", setting);
    setting.knobs.steering_rad = 0.0;
  }
  if (probe.trapezoidHalfAngle_rad > 0.0) {
    setting.knobs.trapezoid = true;
    sheet.add(probe.id + ", trapezoid", setting);
  }
}

}  // namespace

RgbImage contactSheet(const SheetSource& source, const glm::ivec2& tile_px) {
  Sheet sheet(source, tile_px);
  for (const EffectInfo& effect : sceneEffects()) sheet.add(pairOf(effect, source));
  sheet.add(pairsOfMethods(source));
  sheet.add(pairsOfKnobs());
  sheet.add(pairsOfWholeScenes(source));
  for (const Probe& probe : source.probes) addProbe(sheet, probe, source.subject.scene);
  return sheet.image();
}

}  // namespace ew::cli
