#include "contact_sheet.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <string>

#include "ew/imaging/caption.h"
#include "ew/scanning/scanner.h"

namespace ew::cli {
namespace {

constexpr int kColumns = 6;
constexpr int kName_px = 18;     // below each tile
constexpr int kWarning_px = 30;  // below all

struct Tile {
  std::string name;
  RgbImage picture;
};

/// One tile's setting: the console, the scene, and what happens before the picture is taken.
struct Setting {
  Probe probe;
  Pose pose;
  Knobs knobs;
  Scene scene;
  bool withLabels = true;
  std::vector<float> gaps_mm = {};
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

RgbImage pictureOf(const SheetSource& source, const Setting& setting, const glm::ivec2& size_px) {
  Scanner scanner;
  ScanSubject subject = source.subject;
  if (!setting.withLabels) subject.labels = nullptr;
  scanner.show(std::move(subject));
  ScanState state{
      .probe = setting.probe, .knobs = setting.knobs, .pan = {}, .scene = setting.scene, .pose = {}, .gaps_mm = setting.gaps_mm};
  Picture shown;
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
    const RgbImage& picture = tiles[n].picture;
    for (int y = 0; y < picture.height; ++y) std::copy_n(viewOf(picture).row(y), picture.width, viewOf(sheet).row(top + y) + left);
    const ImageView<Rgb> below{viewOf(sheet).row(top + tile_px.y) + left, tile_px.x, kName_px, sheet.width};
    burnCaption(below, tiles[n].name);
  }
  return sheet;
}

}  // namespace

RgbImage contactSheet(const SheetSource& source, const glm::ivec2& tile_px) {
  std::vector<Tile> tiles;
  Setting plain{.probe = source.probe, .pose = source.pose, .knobs = {}, .scene = {}};
  plain.scene.recordedDynamicRange_db = source.subject.scene.recordedDynamicRange_db;
  plain.scene.tissues = source.subject.scene.tissues;
  const auto add = [&](std::string name, const Setting& setting) {
    tiles.push_back({lowerCase(std::move(name)), pictureOf(source, setting, tile_px)});
  };
  using Change = std::function<void(Setting&)>;
  const auto pair = [&](const std::string& off, const std::string& on, const Change& both, const Change& change) {
    Setting setting = plain;
    both(setting);
    add(off, setting);
    change(setting);
    add(on, setting);
  };
  const Change nothing = [](Setting&) {};
  const double depth_mm = source.probe.defaultDepth_mm;

  pair("plain", "gain and dgc", nothing, [](Setting& s) {
    s.knobs.gain = 1.2;
    s.knobs.dgc = {0.6, 0.8, 1.0, 1.1, 1.2, 1.3, 1.4, 1.5};
  });
  pair("range 60 db", "range 50 db, soft map", nothing, [](Setting& s) {
    s.knobs.dynamicRange_db = 50.0;
    s.knobs.greyMap = GreyMap::soft;
  });
  pair("no edges", "edge enhancement", nothing, [](Setting& s) { s.knobs.edgeEnhancement = 0.8; });
  pair("focus off", "focus near, 40 mm", nothing, [](Setting& s) {
    s.scene.focus.emplace();
    s.knobs.focus_mm = 40.0;
  });
  pair(
      "focus far, kernel", "focus far, row stretch",
      [&](Setting& s) {
        s.scene.focus.emplace();
        s.knobs.focus_mm = 0.75 * depth_mm;
      },
      [](Setting& s) { s.knobs.focusMethod = FocusMethod::rowStretch; });
  pair("thin slice", "slice thickness", nothing, [](Setting& s) { s.scene.sliceThickness.emplace(); });
  pair("no shadow", "shadow by tissue", nothing, [](Setting& s) { s.scene.attenuation.emplace(); });
  pair(
      "shadow by grey level", "shadow, probe rocked",
      [](Setting& s) {
        s.scene.attenuation.emplace();
        s.withLabels = false;
      },
      [](Setting& s) {
        s.withLabels = true;
        s.pose = rocked(s.pose, 20.0);
      });
  pair(
      "no reverberation", "reverberation, mirror", [&](Setting& s) { s.pose = source.interfacePose; },
      [](Setting& s) { s.scene.reverberation.emplace(); });
  pair(
      "no noise", "noise", [](Setting& s) { s.scene.attenuation.emplace(); }, [](Setting& s) { s.scene.noise.emplace(); });
  pair(
      "full contact", "a third in air", [](Setting& s) { s.scene.contact.emplace(); },
      [](Setting& s) {
        s.gaps_mm.assign(96, 0.0F);
        std::fill_n(s.gaps_mm.begin(), 32, 20.0F);
      });
  const Change moving = [](Setting& s) {
    s.frames = 12;
    s.slide_mm = 12.0;
  };
  pair("moving", "moving, persistence", moving, [](Setting& s) { s.knobs.persistence = 0.85; });
  pair(
      "upside down", "m-mode, sliding", [](Setting& s) { s.knobs.upsideDown = true; },
      [](Setting& s) {
        s.knobs.upsideDown = false;
        s.knobs.mode = DisplayMode::mMode;
        s.frames = 90;
        s.slide_mm = 24.0;
        s.secondsPerFrame = s.knobs.mSweep_s / 90.0;
        s.showsStrip = true;
      });
  pair("nothing on", "as the case asks", nothing, [&](Setting& s) { s.scene = source.subject.scene; });
  pair(
      "everything, weave", "everything, cubic",
      [&](Setting& s) {
        s.scene = sceneWithEverything();
        s.scene.recordedDynamicRange_db = source.subject.scene.recordedDynamicRange_db;
        s.scene.tissues = source.subject.scene.tissues;
        s.knobs.quality = Quality::weave;
      },
      [](Setting& s) { s.knobs.quality = Quality::cubic; });

  for (const Probe& probe : source.probes) {
    Setting setting = plain;
    setting.probe = probe;
    setting.scene = source.subject.scene;
    add(probe.id, setting);
    if (probe.maxSteering_rad > 0.0) {
      setting.knobs.steering_rad = probe.maxSteering_rad;
      add(probe.id + ", steered", setting);
      setting.knobs.steering_rad = 0.0;
    }
    if (probe.trapezoidHalfAngle_rad > 0.0) {
      setting.knobs.trapezoid = true;
      add(probe.id + ", trapezoid", setting);
    }
  }
  return arranged(tiles, tile_px);
}

}  // namespace ew::cli
