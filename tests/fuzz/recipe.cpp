#include "ew/phantom/label_grid.h"
#include "ew/phantom/patient.h"
#include "ew/phantom/truth.h"
#include "folder.h"

/// A virtual patient, then what it extends, then its mannequin.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace ew;
  const auto parts = fuzz::partsOf(bytes, size);
  const auto file = fuzz::put("patient.json", parts[0]);
  fuzz::put("base.json", parts.size() > 1 ? parts[1] : "{}");
  fuzz::put("ball.json", parts.size() > 2 ? parts[2] : R"({"format": 1, "name": "ball", "body": {"ellipsoid": {"centre_mm": [0, 0, 0],
                                               "radii_mm": [60, 60, 60]}}})");
  if (const auto print = fingerprintOfPatient(file); !print) fuzz::checkSentence(print.error());
  if (const auto tissues = readLabelTissues(file); !tissues) fuzz::checkSentence(tissues.error());
  if (const auto box = readPatientBox(file); !box) fuzz::checkSentence(box.error());
  fuzz::SoMuch reading(2000);
  const auto patient = readPatient(file, {}, {}, reading);
  if (!patient) {
    fuzz::checkSentence(patient.error());
    return 0;
  }
  const Bounds box = boxOf(**patient);
  for (const double share : {0.0, 0.3, 0.5, 1.0}) {
    const int label = labelAt(**patient, box.lowest_mm + share * (box.highest_mm - box.lowest_mm));
    fuzz::mustHold(label >= 0 && label <= static_cast<int>(organsOf(**patient).size()));
  }
  fuzz::SoMuch measuring(200), labelling(200);
  if (const auto measured = measurementsOf(**patient, {}, measuring); !measured) fuzz::checkSentence(measured.error());
  Grid grid;
  grid.dims = glm::ivec3(8);
  grid.spacing_mm = (box.highest_mm - box.lowest_mm) / 7.0;
  grid.origin_mm = box.lowest_mm;
  if (const auto labels = labelsOn(**patient, grid, 1, labelling, 1u << 20); !labels) fuzz::checkSentence(labels.error());
  return 0;
}
