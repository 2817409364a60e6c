#include "ew/assessment/metric.h"

#include <algorithm>

#include "ew/core/find_entry.h"

namespace ew {
namespace {

using Kinds = std::vector<std::string_view>;

/// Steps that leave a scan.
const Kinds& scanned() {
  static const Kinds kinds = {"plane", "sweep", "measure", "point", "settings", "free"};
  return kinds;
}
const Kinds& planes() {
  static const Kinds kinds = {"plane", "measure"};
  return kinds;
}

Message survey() {
  return say<
      "Of 153 figures of one simulator 48 told novices from consultants; what this one says of skill has to be shown for each task.">();
}
Message ours() { return say<"Ours; no published standard states it.">(); }

std::vector<Metric> motionMetrics() {
  const Message dexterity =
      say<"Common in studies of dexterity; integrated from polynomials through the poses, so that noise does not lengthen it.">();
  return {
      {"time", 1, "s", Better::less, scanned(), say<"Time">(),
       say<"From the first contact with the skin to handing in, pauses left out.">(), say<"Time on task.">(),
       say<"Told novices from experts in brain and spine tasks; says nothing where a step asks for a time.">()},
      {"path_length", 1, "mm", Better::less, scanned(), say<"Path length">(), say<"Way of the middle of the probe's face.">(), dexterity,
       say<"Told novices from experts in one of three tasks of one study.">()},
      {"angular_path", 1, "deg", Better::less, scanned(), say<"Angular path">(), say<"Sum of all turns of the probe about any axis.">(),
       dexterity, survey()},
      {"spectral_arc_length", 1, "", Better::more, scanned(), say<"Smoothness of the speed">(),
       say<"How evenly the probe goes faster and slower: a number without unit, below 0; the nearer to 0, the smoother. Spectral arc "
           "length: the length of the curve of the speed's normalised spectrum up to 10 Hz, negative.">(),
       say<"Balasubramanian et al., J NeuroEng Rehabil 12:112, 2015, eq. 9.">(), survey()},
      {"log_dimensionless_jerk", 1, "", Better::more, scanned(), say<"Smoothness of the movements">(),
       say<"How little the probe jerks from one rest to the next: a number without unit, usually below 0; the higher, the smoother. Log "
           "dimensionless jerk: the jerk of each movement, made independent of its length and time.">(),
       say<"Balasubramanian et al., J NeuroEng Rehabil 12:112, 2015, eq. 3.">(),
       say<"Jerk told novices from experts in brain and spine tasks.">()},
      {"working_volume", 1, "ml", Better::less, scanned(), say<"Working volume">(),
       say<"Volume of the convex hull of the places of the face, by its outermost points in 1024 directions.">(),
       say<"Hulls of positions are common in studies of dexterity.">(), say<"Told novices from experts in brain and heart tasks.">()},
      {"idle_share", 1, "%", Better::less, scanned(), say<"Idle share">(),
       say<"Part of the time in which the probe moves slower than 2 mm/s and turns slower than 2 degrees/s.">(), ours(), survey()},
      {"contact_loss", 1, "%", Better::less, scanned(), say<"Lost contact">(),
       say<"Part of the time after the first contact in which less than half of the face touches (gel fills 3 mm).">(), ours(), survey()},
      {"pressure", 1, "mm", Better::less, scanned(), say<"Pressure">(),
       say<"How deep the face is pressed into the skin at its deepest point, as a mean over the time of contact. No force is measured.">(),
       ours(), say<"A mouse presses as firmly as the program says; only a tracked probe tells how firmly a hand presses.">()},
  };
}

std::vector<Metric> targetMetrics() {
  const Message planeSource = say<"As evaluations of plane finding state it (Di Vece et al., arXiv 2301.08317, 2023).">();
  const Message taskItself = say<"It is the task itself, by the target that the case's author set.">();
  return {
      {"coverage",
       1,
       "%",
       Better::more,
       {"sweep", "free"},
       say<"Coverage">(),
       say<"Part of the voxels of the structures asked for that images passed through below a touching part of the face; shadows are not "
           "looked at.">(),
       ours(),
       taskItself},
      {"plane_angle", 1, "deg", Better::less, planes(), say<"Plane: angle">(),
       say<"Between the normals of the last image and of the target plane.">(), planeSource, taskItself},
      {"plane_roll", 1, "deg", Better::less, planes(), say<"Plane: roll">(),
       say<"Rotation within the plane that is left after the shortest turn of normal to normal.">(), planeSource, survey()},
      {"plane_distance", 1, "mm", Better::less, planes(), say<"Plane: distance">(),
       say<"Of the target's point of interest from the plane of the last image.">(), planeSource, taskItself},
      {"plane_in_picture", 1, "mm", Better::less, planes(), say<"Plane: shift in the image">(),
       say<"How far the point of interest lies from where the target's image has it, seen along the normal.">(), ours(), survey()},
      {"landmark_distance",
       1,
       "mm",
       Better::less,
       {"point"},
       say<"Landmark">(),
       say<"Of the click from the point, or from the nearest voxel of the structure.">(),
       say<"Trainees' landmarks against the author's.">(),
       taskItself},
      {"measurement_error",
       1,
       "%",
       Better::less,
       {"measure"},
       say<"Measurement">(),
       say<"Difference from the expected value, of that value.">(),
       say<"Percent error against the author's reference.">(),
       taskItself},
      {"caliper_distance",
       1,
       "mm",
       Better::less,
       {"measure"},
       say<"Calipers">(),
       say<"Of the calipers from where they belong, in the better order; the farther of the two.">(),
       ours(),
       survey()},
      {"answer_error",
       1,
       "%",
       Better::less,
       {"answer"},
       say<"Answer">(),
       say<"What is missing to all right options and no wrong one; of a number 0 within its tolerance, else 100.">(),
       ours(),
       taskItself},
      {"hints",
       1,
       "",
       Better::less,
       {"plane", "sweep", "measure", "point", "settings", "answer", "free"},
       say<"Hints">(),
       say<"That were asked for.">(),
       ours(),
       survey()},
  };
}

std::vector<Metric> expertMetrics() {
  const Message settings = say<"Item 3 of OSAUS, image optimisation, as figures; ours.">();
  return {
      {"gain_difference", 1, "dB", Better::less, planes(), say<"Gain beside the expert's">(), say<"Of the last image, without its sign.">(),
       settings, survey()},
      {"depth_difference", 1, "mm", Better::less, planes(), say<"Depth beside the expert's">(),
       say<"Of the last image, without its sign.">(), settings, survey()},
      {"focus_difference", 1, "mm", Better::less, planes(), say<"Focus beside the expert's">(),
       say<"Of the last image, without its sign.">(), settings, survey()},
      {"expert_distance",
       1,
       "mm",
       Better::less,
       {"plane", "sweep", "measure", "point", "free"},
       say<"Distance from the expert's scan">(),
       say<"Mean distance of the poses of both scans, aligned by dynamic time warping; a turn counts with a lever of 60 mm.">(),
       say<"Dynamic time warping: Sakoe and Chiba 1978; the lever is ours.">(),
       say<"No published threshold was found.">()},
      {"plane_overlap",
       1,
       "%",
       Better::more,
       {"plane", "sweep", "measure", "point", "free"},
       say<"Planes the expert visited">(),
       say<"Part of the expert's planes that the trainee visited as well, within 10 mm and 15 degrees.">(),
       ours(),
       survey()},
  };
}

}  // namespace

const std::vector<Metric>& metrics() {
  static const std::vector<Metric> all = [] {
    std::vector<Metric> made = motionMetrics();
    for (auto part : {targetMetrics(), expertMetrics()})
      for (Metric& each : part) made.push_back(std::move(each));
    return made;
  }();
  return all;
}

const Metric* metricOf(std::string_view id) {
  const auto& all = metrics();
  return entryWith(all, &Metric::id, id);
}

bool isFor(const Metric& metric, std::string_view stepKind) {
  return std::find(metric.stepKinds.begin(), metric.stepKinds.end(), stepKind) != metric.stepKinds.end();
}

std::optional<double> valueOf(const std::vector<MetricValue>& values, std::string_view id) {
  const auto found = std::find_if(values.begin(), values.end(), [&](const MetricValue& one) { return one.id == id; });
  return found == values.end() ? std::nullopt : std::optional(found->value);
}

}  // namespace ew
