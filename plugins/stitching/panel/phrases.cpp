#include "panel/phrases.h"

#include <QCoreApplication>
#include <QHash>
#include <QRegularExpression>
#include <optional>
#include <vector>

namespace ew::stitching {
namespace {

// clang-format off
constexpr const char* kPhrases[] = {
    // Steps of the work.
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Inspecting %1"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Reading %1"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Registering %1 and %2"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Deforming %1 and %2"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Registering"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Preparing images"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Preparing the images"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Searching poses"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Comparing images"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Comparing"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Looking for shadows"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Checking for residual motion"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Searching for large motion"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Writing out the displacements"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Warping the moving volume"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Inverting the deformation"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Placing subvolumes"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Looking at overlaps"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Combining deformations"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Unfolding"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Comparing views"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Looking for seams"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Cutting seams"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Measuring distances from the border"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Blending"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Copying"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Reading frames"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Reading voxels"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Writing voxels"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Writing vectors"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Pasting frames"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Estimating confidence"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Filling holes"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Filling holes along the sweep"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Reading frames at the voxels"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Comparing sweeps"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Converting scan lines"),
    // What stitching says.
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The stitch project has no volumes; add some."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The project has no volume yet; add one before it is saved."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The step %1 would need %2 MiB of memory, more than the %3 MiB allowed; use a coarser spacing_mm or fewer volumes at a time."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The reconstruction of '%1' is not there."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "'%1' is not a result that was written here before, and would be lost; move it away or choose another folder."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "'%1' is read by this project and would be written over by its result; choose another folder."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "\"%1\" was made by somebody else in the meantime and is left as it is; choose another name."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "'%1' lies among the intermediate results of '%2', which come and go; copy it to a place of its own or choose another folder."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The reconstruction of '%1' was damaged."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "'%1' cannot be written (%2); choose another folder."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "'%1' gave no volume; check what kind of file it is."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "'%1' in the stitch project is %2; it must be %3."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "not known here"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "missing"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "one of %1"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The stitch project has format %1, and this program reads formats up to %2; open it with a newer EchoWeave."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "'%1' holds %2; a transform is 16 numbers, row by row."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "something that is not a number"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "%1 numbers"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The transform in '%1' cannot be used. %2"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "'%1' in the stitch project cannot be used. %2"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "'%1' and '%2' could not be bent together. %3"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "'%1' and '%2' could not be registered. %3"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The stitch project nests deeper than %1 levels, which no file of this program does; check that it is the right file."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The stitch project is not valid JSON: it breaks at line %1, column %2; correct it there or restore an earlier copy."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The folder '%1' cannot be written (%2); choose one you may write to."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Another run is at work in '%1'; wait until it has ended, or choose another folder."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "\"%1\" cannot be read; check the medium it is on."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The file that keeps unsaved work ('%1') is damaged; it is left where it is and nothing was reopened."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "A volume needs a name; type one."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Another volume is called '%1' already; choose another name."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "There is one volume alone."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The recorded places were taken as they are."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "There is no volume to stitch; add at least one."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "At most %1 volumes can be stitched at once; stitch them in groups."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Stitching would need more memory than there is, and the limit is %1; choose a coarser spacing, or check whether one of the volumes is placed far away."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Stitching would need %1, and the limit is %2; choose a coarser spacing, or check whether one of the volumes is placed far away."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Joining would need %1 MiB, and the limit is %2 MiB; choose a coarser spacing or smaller blocks."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Volume '%1' cannot be stitched. %2"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The spacing of the result must be a positive number of mm, or 0 for the finest of the inputs."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The feather width must be 0 or a positive number of mm."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The weight of interpolated voxels must be above 0 and at most 1."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The options of the equalisation are out of range; use cells and knots above 0."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The blocks of a join must be at least 8 voxels wide."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The seams were found for another grid; find them again for this one."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The seams have levels of other volumes; find them again."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The seams name more volumes than there are; find them again."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Its grey correction has a number that cannot be used."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Its bend has a displacement too many, too few or without a number."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The cells of the seam must be wider than 0 mm."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The blend beside the seam must be 0 or a positive number of mm."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The blend of levels beside the seam must be 0 or a positive number of mm."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The weights of a seam must be 0 or positive."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "A stroke of the seam editor names a volume that is not there, or has no place or radius."),
    // What registration says.
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The %1 volume has %2 echo values for %3 voxels."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The coverage of the %1 volume has %2 values for %3 voxels."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The direction of the beam of the %1 volume is no direction."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The apex of the beams of the %1 volume is no place."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The confidence of the %1 volume has %2 values for %3 voxels."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The confidence of the %1 volume has values outside 0 to 1."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "No voxel of the %1 volume was measured; choose a volume that holds an echo."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The control grid has %1 displacements for %2 nodes; write it anew."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The deformation folds in %1 of its control grid and has no inverse; register again with a stiffer grid."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The moving volume holds another number of voxels than its grid says; write it anew."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The %1 volume has more than 2^30 voxels; resample it to a coarser spacing first."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The option %1 is %2; it must be %3."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The covariance of %1 %2; a covariance is symmetric and no variance is negative."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "There is no subvolume to place; add at least one."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The option %1 must be above 0."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "At least one iteration is needed."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The pose of %1 cannot be used: %2"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The centre of the tracker's covariance of %1 is not a number."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "%1 names a subvolume that does not exist; there are %2."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "%1 joins %2 with itself."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The transform of the pair %1 cannot be used: %2"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The pair %1 has a centre that is not a number or a trust outside 0..1."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The solver of poses failed (%1)."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The pick error of landmarks must be a length above 0 mm."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The landmark %1 has a coordinate that is not a number; correct or remove it."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "A volume is missing: name two."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "Regions and windows need a side above 0 mm."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The deformation has another number of vectors than its lattice has nodes."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The matching option %1 is %2; it must be %3."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The registration option %1 is %2; it must be %3."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The images at voxels of %1 mm are too large to register; ask for a coarser finest level."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "fixed"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "moving"),
    // What reading and writing say.
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "There is no file \"%1\"; check its name and folder."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "\"%1\" cannot be read (%2); check its permissions."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "\"%1\" cannot be opened; check its permissions."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "\"%1\" is not a regular file; choose a file."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "\"%1\" has an ending that is not read; give a .mha, .mhd, .nrrd, .nhdr, .nii or .nii.gz file."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "\"%1\" is not a MetaImage: a header line has no \"=\"; check what kind of file it is."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "\"%1\" is not a NRRD file; check what kind of file it is."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "\"%1\" is not a text header followed by samples; check what kind of file it is."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The header of \"%1\" ends before it says where the samples are (ElementDataFile); get the file again."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "\"%1\" is too short: its header promises %2 bytes of samples, the file has %3; get the file again."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "\"%1\" is too short: its header promises %2 compressed bytes, the file has %3; get the file again."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The compressed samples of \"%1\" are damaged; get the file again."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The compressed samples of \"%1\" break off after %2 unpacked bytes; get the file again."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "In \"%1\", %2 is \"%3\", but %4 is needed; correct the header or export the file again."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "\"%1\" keeps its samples in \"%2\", which is not there; put both files into one folder."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "\"%1\" holds no voxels (%2); choose a file with samples in it."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "\"%1\" has %2 values per sample, but one value or a colour is needed; export the echo levels alone."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "\"%1\" is a recorded sweep, not a volume; reconstruct it first."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "\"%1\" is a volume, not a recorded sweep; open it as a volume."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "\"%1\" cannot be written (%2); choose another place or free some room."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The sweep would become %1 x %2 x %3 voxels and need %4 MiB, more than the %5 MiB allowed; give a coarser spacing_mm."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The sweep has no frame with a usable pose; check the tracking of the recording."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "There is no way from the pixels (frame Image) to %1: nothing can be reached from Image; %2."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "There is no way from the pixels (frame Image) to %1: nothing can be reached from Image, and %2 stand apart; %3."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "There is no way from the pixels (frame Image) to %1: from Image only %2 can be reached; %3."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "There is no way from the pixels (frame Image) to %1: from Image only %2 can be reached, and %3 stand apart; %4."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "give the device set (.xml) with the calibration from Image to %1"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "the device set given has no transform from or to Image, give the one this sweep was recorded with"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "name one of those frames as the target, or give the device set (.xml) that leads on"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "the recording holds no tracked poses, so it cannot be placed: choose one recorded with a tracker"),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The volume has no voxels along axis %1; check the file's dimensions."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The voxel spacing along axis %1 is not a positive number; check the file's spacing."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The volume's origin is not finite; check the file's offset."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The volume has more voxels than can be handled; use a coarser spacing."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The direction of axis %1 is not of unit length; check the file's orientation matrix."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The directions of the volume's axes lie in one plane; check the file's orientation matrix."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The pose is not a rotation with a translation: %1. Give 16 numbers, row by row, with orthonormal axes and a last row of 0 0 0 1."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "There is not enough memory for this; close other programs or choose a coarser spacing."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "There is not enough memory for a volume of %1; use a coarser spacing."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "The work stopped unexpectedly (%1); nothing was changed, please report it with what you did."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "There is not enough memory for '%2' of the plugin '%1'; close other programs or choose a coarser spacing."),
    QT_TRANSLATE_NOOP("ew::stitching::Phrases", "'%2' of the plugin '%1' stopped unexpectedly (%3); please report it with what you did."),
};
// clang-format on

const QRegularExpression& place() {
  static const QRegularExpression found(QStringLiteral("%([1-9])"));
  return found;
}

struct Pattern {
  const char* source = nullptr;
  QRegularExpression form;
  std::vector<int> order;  ///< which number each part that is kept has
};

struct Registered {
  QHash<QString, const char*> whole;  ///< without anything to keep
  std::vector<Pattern> patterns;
};

Registered registeredOnce() {
  Registered all;
  for (const char* source : kPhrases) {
    const QString text = QString::fromUtf8(source);
    QString form = QStringLiteral("^");
    Pattern pattern;
    int from = 0;
    for (auto at = place().globalMatch(text); at.hasNext();) {
      const auto match = at.next();
      form += QRegularExpression::escape(text.mid(from, match.capturedStart() - from)) + QStringLiteral("(.+?)");
      pattern.order.push_back(match.captured(1).toInt());
      from = match.capturedEnd();
    }
    if (pattern.order.empty()) {
      all.whole.insert(text, source);
      continue;
    }
    form += QRegularExpression::escape(text.mid(from)) + QLatin1Char('$');
    pattern.source = source;
    pattern.form = QRegularExpression(form, QRegularExpression::DotMatchesEverythingOption);
    pattern.form.optimize();
    all.patterns.push_back(std::move(pattern));
  }
  return all;
}

const Registered& registered() {
  static const Registered all = registeredOnce();
  return all;
}

QString translated(const char* source) { return QCoreApplication::translate("ew::stitching::Phrases", source); }

std::optional<QString> lookedUp(const QString& english, int depth) {
  if (const auto at = registered().whole.constFind(english); at != registered().whole.constEnd()) return translated(at.value());
  constexpr int kDeepest = 3;  // a sentence about a file in a sentence about a volume
  if (depth >= kDeepest) return std::nullopt;
  for (const Pattern& pattern : registered().patterns) {
    const auto match = pattern.form.match(english);
    if (!match.hasMatch()) continue;
    QString kept[10];
    for (std::size_t n = 0; n < pattern.order.size(); ++n) {
      const QString part = match.captured(static_cast<int>(n) + 1);
      kept[pattern.order[n]] = lookedUp(part, depth + 1).value_or(part);
    }
    // Not by QString::arg, which would look into what was put in.
    const QString text = translated(pattern.source);
    QString said;
    int from = 0;
    for (auto at = place().globalMatch(text); at.hasNext();) {
      const auto number = at.next();
      said += text.mid(from, number.capturedStart() - from) + kept[number.captured(1).toInt()];
      from = number.capturedEnd();
    }
    return said + text.mid(from);
  }
  return std::nullopt;
}

}  // namespace

QString phraseOf(const std::string& english) {
  const QString text = QString::fromStdString(english);
  return lookedUp(text, 0).value_or(text);
}

bool isPhrase(const std::string& english) { return lookedUp(QString::fromStdString(english), 0).has_value(); }

void ProgressInWords::report(std::string_view what, double fraction) {
  std::string words;
  {
    const std::lock_guard lock(mutex_);  // steps are told from many threads, thousands of times in a row
    if (what != english_) {
      english_ = what;
      words_ = phraseOf(english_).toStdString();
    }
    words = words_;
  }
  whole_.report(words, fraction);
}

QStringList phrases() {
  QStringList all;
  for (const char* source : kPhrases) all << QString::fromUtf8(source);
  return all;
}

}  // namespace ew::stitching
