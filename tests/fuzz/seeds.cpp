// Writes a small starting corpus, one folder per reader, from the writers that the tests use.
#include <iostream>

#include "dicom_files.h"
#include "ew/io/image_file.h"
#include "ew/io/sequence.h"
#include "kretz_files.h"
#include "made_films.h"
#include "packed_images.h"
#ifdef EW_HAS_TRACKERS
#include "../trackers/igtl_messages.h"
#include "ew/trackers/igtl_bodies.h"
#endif

namespace {
using namespace ew::test;
namespace fs = std::filesystem;

void put(const fs::path& folder, const std::string& name, const std::string& bytes) {
  fs::create_directories(folder);
  std::ofstream(folder / name, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

void dicom(const fs::path& folder) {
  CineOf cine;
  cine.pixels = ramp(144);
  for (const char* syntax : {kImplicitLittle, kExplicitLittle, kExplicitBig, kDeflated}) {
    cine.syntax = syntax;
    put(folder, std::string("plain-") + syntax, cineFile(cine));
  }
  cine = {};
  cine.undefinedLengths = true;
  cine.regions = {{0, 0, 3, 5}, {4, 0, 7, 5}};
  cine.pixels = ramp(144);
  cine.burnedIn = "YES";
  put(folder, "regions", cineFile(cine));
  cine.samples = 3;
  cine.regions = {{}};
  for (const char* colours : {"RGB", "YBR_FULL", "YBR_FULL_422"}) {
    cine.photometric = colours;
    cine.pixels = ramp(432);
    put(folder, colours, cineFile(cine));
  }
  cine = {};
  cine.syntax = kRle;
  cine.frames = 1;
  cine.packed = {rleOf({ramp(48)})};
  put(folder, "rle", cineFile(cine));
  cine.columns = cine.rows = 16;
  for (const int samples : {1, 3}) {
    cine.samples = static_cast<std::uint16_t>(samples);
    cine.photometric = samples == 1 ? "MONOCHROME2" : "RGB";
    const std::string image = ramp(256u * static_cast<std::size_t>(samples));
    const std::string s = std::to_string(samples);
    cine.syntax = kJpegLossless;
    cine.packed = {packedBy<gdcm::JPEGCodec>(image, 16, 16, samples, 8)};
    put(folder, "jpeg-" + s, cineFile(cine));
    cine.syntax = kJpegLs;
    cine.packed = {packedBy<gdcm::JPEGLSCodec>(image, 16, 16, samples, 8)};
    put(folder, "jpegls-" + s, cineFile(cine));
    cine.syntax = kJpeg2000;
    cine.packed = {packedBy<gdcm::JPEG2000Codec>(image, 16, 16, samples, 8)};
    put(folder, "j2k-" + s, cineFile(cine));
  }
  cine = {};
  cine.photometric = "PALETTE COLOR";
  cine.pixels = ramp(144);
  DicomWriter tables;
  for (std::uint32_t c = 0; c < 3; ++c) tables.raw(0x00281101u + c, "US", bytesOf(std::vector<std::uint16_t>{4, 0, 16}));
  for (std::uint32_t c = 0; c < 3; ++c)
    tables.raw(0x00281221u + c, "OW", bytesOf(std::vector<std::uint16_t>{0, 1, 0x1000, 1, 2, 0x4000, 2, 1, 0, 0}));
  cine.extra = tables.bytes();
  put(folder, "palette", cineFile(cine));
}

void enhanced(const fs::path& folder) {
  EnhancedOf volume;
  volume.pixels = ramp(60);
  put(folder, "even", enhancedFile(volume));
  volume.positions[2] = {1, 2, 8};
  put(folder, "uneven", enhancedFile(volume));
  volume.times = {0, 0, 1};
  volume.types = {"TISSUE_INTENSITY", "FLOW_VELOCITY", "TISSUE_INTENSITY"};
  put(folder, "times", enhancedFile(volume));
}

std::string nifti(std::int16_t type, std::size_t bytes) {
  std::string head(352, '\0');
  const auto set = [&](std::size_t at, auto value) { std::memcpy(head.data() + at, &value, sizeof value); };
  set(0, std::int32_t{348});
  const std::array<std::int16_t, 5> dim{4, 3, 2, 2, 2};
  std::memcpy(head.data() + 40, dim.data(), sizeof dim);
  set(70, type);
  for (std::size_t n = 0; n < 5; ++n) set(76 + 4 * n, 0.5F);
  set(108, 352.0F);
  set(112, 1.0F);
  head[123] = 2;
  set(254, std::int16_t{1});
  for (std::size_t n = 0; n < 3; ++n) set(280 + 20 * n, 0.5F);
  std::memcpy(head.data() + 344, "n+1", 4);
  return head + ramp(24 * bytes);
}

void volumes(const fs::path& folder) {
  const std::string meta =
      "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nTransformMatrix = 0 1 0 1 0 0 0 0 1\n"
      "Offset = 1 2 3\nElementSpacing = 0.5 0.5 1\nDimSize = 4 3 2\nElementType = ";
  put(folder / "meta", "plain", meta + "MET_UCHAR\nElementDataFile = LOCAL\n" + ramp(24));
  put(folder / "meta", "short", meta + "MET_SHORT\nElementDataFile = LOCAL\n" + ramp(48));
  put(folder / "meta", "colour", meta + "MET_UCHAR\nElementNumberOfChannels = 3\nElementDataFile = LOCAL\n" + ramp(72));
  const std::string packed = deflated(ramp(24));
  put(folder / "meta", "packed",
      meta + "MET_UCHAR\nCompressedData = True\nCompressedDataSize = " + std::to_string(packed.size()) + "\nElementDataFile = LOCAL\n" +
          packed);
  const std::string nrrd =
      "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 4 3 2\nspace: left-posterior-superior\n"
      "space directions: (1,0,0) (0,2,0) (0,0,3)\nspace origin: (1,2,3)\nendian: little\nencoding: ";
  put(folder / "recording", "two",
      "ObjectType = Image\nNDims = 3\nDimSize = 0 0 2\nKinds = domain domain list\nElementType = MET_OTHER\nEchoWeaveRecording = 1\n"
      "EchoWeaveSubject = {\"case\":\"a\",\"title\":\"A\"}\nEchoWeaveImageSize = 320 240\n"
      "Seq_Frame0000_ProbeToWorldTransform = 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\nSeq_Frame0000_ProbeToWorldTransformStatus = OK\n"
      "Seq_Frame0000_Timestamp = 1\nSeq_Frame0000_ImageNumber = 1\nSeq_Frame0000_SkinGaps = 0 1.5 3\n"
      "Seq_Frame0000_Events = "
      "[{\"time_s\":1,\"probe_id\":\"p\",\"probe\":{\"format\":1,\"name\":\"P\",\"kind\":\"linear\",\"width_mm\":40,\"lines\":64,"
      "\"carrier_hz\":5e6,\"elevational_thickness_mm\":2,\"min_depth_mm\":20,\"max_depth_mm\":80,\"default_depth_mm\":60}},"
      "{\"time_s\":1,\"settings\":{\"gain\":1.2},\"pan_mm\":[1,2]},{\"time_s\":1,\"scene\":{\"focus\":true}},{\"time_s\":1,\"frozen\":"
      "false},"
      "{\"time_s\":1,\"note\":\"mark\",\"what\":null}]\n"
      "Seq_Frame0001_ProbeToWorldTransform = 1 0 0 5 0 1 0 0 0 0 1 0 0 0 0 1\nSeq_Frame0001_ProbeToWorldTransformStatus = OK\n"
      "Seq_Frame0001_Timestamp = 1.5\nSeq_Frame0001_ImageNumber = 2\nSeq_Frame0001_Events000 = [{\"time_s\":1.2,\nSeq_Frame0001_Events001 "
      "= "
      "\"frozen\":true}]\nElementDataFile = LOCAL\n");
  put(folder / "nrrd", "raw", nrrd + "raw\n\n" + ramp(24));
  put(folder / "nrrd", "gzip", nrrd + "gzip\n\n" + deflated(ramp(24), true));
  put(folder / "nrrd", "text", nrrd + "ascii\n\n1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24\n");
  put(folder / "nrrd", "units",
      "NRRD0005\ntype: uchar\ndimension: 3\nsizes: 4 3 2\nspacings: 0.1 0.2 nan\nunits: \"cm\" \"um\" \"\"\naxis mins: 1 2 nan\n"
      "axis maxs: 2 3 4\ncenters: cell node none\nthicknesses: 1 1 1\nold min: 0\nencoding: raw\n\n" +
          ramp(24));
  put(folder / "nrrd", "woven",
      "NRRD0005\ntype: uchar\ndimension: 4\nsizes: 3 2 2 2\nkinds: list domain domain domain\nspace: RAS\n"
      "space directions: none (1,0,0) (0,1,0) (0,0,1)\nspace units: \"m\" \"mm\" \"furlong\"\nencoding: raw\n\n" +
          ramp(24));
  put(folder / "nifti", "u8", nifti(2, 1));
  put(folder / "nifti", "f32", nifti(16, 4));
  put(folder / "nifti", "packed", deflated(nifti(4, 2), true));
}

void sequences(const fs::path& folder) {
  ew::Sequence sequence;
  sequence.width = 4;
  sequence.height = 3;
  sequence.orientation = "MF";
  sequence.imageType = "BRIGHTNESS";
  for (int n = 0; n < 2; ++n) {
    ew::SequenceFrame frame;
    frame.time_s = 0.1 * n;
    frame.transforms = {{"Image", "Probe", glm::dmat4(1.0), ew::PoseStatus::ok},
                        {"Probe", "Reference", glm::dmat4(1.0), ew::PoseStatus::ok}};
    sequence.frames.push_back(frame);
  }
  const std::string pixels = ramp(24);
  sequence.pixels.assign(pixels.begin(), pixels.end());
  fs::create_directories(folder / "plus");
  static_cast<void>(ew::writeSequence(sequence, folder / "plus" / "s.igs.mha"));
  put(folder / "plus", "nrrd",
      "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 3 2 2\nkinds: domain domain list\nencoding: raw\nSeq_Frame0000_Status:=OK\n"
      "Seq_Frame0001_ImageToReferenceTransform:=1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\n\n" +
          ramp(12));
  put(folder / "device_set", "a.xml",
      "<PlusConfiguration><CoordinateDefinitions><Transform From=\"Image\" To=\"Probe\" Matrix=\"1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\"/>"
      "</CoordinateDefinitions><DataCollection><Device><VolumeReconstruction OutputSpacing=\"0.5 0.5 0.5\" ClipRectangleOrigin=\"1 2\" "
      "ClipRectangleSize=\"3 4\" FanAnglesDeg=\"-30 30\" Interpolation=\"LINEAR\"/></Device></DataCollection></PlusConfiguration>");
  put(folder / "device_set", "unset.xml",
      "<PlusConfiguration><VolumeReconstruction ReferenceCoordinateFrame=\"Phantom\" OutputSpacing=\"0 0 0\" OutputOrigin=\"0 0 0\" "
      "OutputExtent=\" \" ClipRectangleOrigin=\"-1 -1\" ClipRectangleSize=\"nan nan\" FanAngles=\"0 0\" FanOrigin=\"20 -10\" "
      "FanDepth=\"25\" SkipInterval=\"2\" Wobble=\"1\"/></PlusConfiguration>");
}

void others(const fs::path& folder) {
  KretzOf kretz;
  kretz.samples = 6;
  kretz.beams = 5;
  kretz.planes = 4;
  kretz.step_mm = 3.0;
  kretz.fill([](double, double, double) { return 100.0; });
  put(folder / "kretz", "beams", kretzFile(kretz));
  kretz.several = kretz.data + kretz.data;
  kretz.data.clear();
  put(folder / "kretz", "several", kretzFile(kretz));
  kretz.several.clear();
  kretz.data = ramp(120);
  kretz.cartesian = true;
  put(folder / "kretz", "cartesian", kretzFile(kretz));
  put(folder / "raw", "u8", "4x3x2:u8:0.5\n" + ramp(24));
  put(folder / "raw", "i16", "4x3x2:i16be:0.5,0.5,1.2:3\n" + ramp(60));
  put(folder / "raw", "f64", "1x1x2:f64:1e-3:0\n" + ramp(16));
  put(folder / "picture", "jpeg", packedBy<gdcm::JPEGCodec>(ramp(256), 16, 16, 1, 8));
  put(folder / "picture", "pgm", "P5\n# note\n4 3\n255\n" + ramp(12));
  const ew::GreyImage image(8, 8, 77);
  static_cast<void>(ew::writeImage(viewOf(image), 1.0, folder / "picture" / "a.png"));
}

void stitching(const fs::path& folder) {
  put(folder / "stitch_project", "first.json",
      R"({"volumes": [{"file": "a.mha"}, {"file": "b.mha", "to_world": "b.txt"}], "spacing_mm": 1})");
  put(folder / "stitch_project", "all.json",
      R"({"format": 2, "volumes": [{"name": "a", "file": "a.igs.mha", "calibration": "a.xml", "spacing_mm": 0.8, "placement": "hand",)"
      R"( "to_world": [1,0,0,4, 0,1,0,0, 0,0,1,0, 0,0,0,1]}, {"name": "b", "file": "b.mha", "coverage": "c.mha", "confidence": "d.mha"}],)"
      R"( "pairs": [{"fixed": "b", "moving": "a", "method": "landmarks", "decision": "accepted", "max_turn_deg": 40, "effort": "fast",)"
      R"( "landmarks": [{"name": "fork", "fixed_mm": [1,2,3], "moving_mm": [4,5,6]}, {"fixed_mm": [2,2,3], "moving_mm": [5,5,6]},)"
      R"( {"fixed_mm": [1,9,3], "moving_mm": [4,8,6]}]}], "settings": {"tracker_error_mm": 3, "elastic": false, "fall_off_mm": 20},)"
      R"( "result": {"spacing_mm": 0, "axes": "world"}, "seam": {"method": "graph cut", "strokes": [{"view": "a", "at_mm": [1,2,3], "radius_mm": 4}]}})");
  put(folder / "stitch_project", "recovery.json",
      R"({"file": "/p.json", "project": {"format": 2, "volumes": [{"name": "a", "file": "/a.mha"}]}})");
  put(folder / "step_inputs", "inputs.json",
      R"({"#made_by": "EchoWeave", "content": "00", "files": {"/a.mha": {"content": "00", "stamp": [1, 2, 3, 4]}}})");
  put(folder / "step_inputs", "uses.txt", "# EchoWeave: which finished run used what last\n3 volume/" + std::string(32, 'a') + "\n");
  put(folder / "step_inputs", "entry.json",
      R"({"key": "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa", "files": [{"name": "x", "bytes": 3, "content": "00"}], "data": {"results": [)"
      R"({"name": "volume.mha", "bytes": 1, "content": "00", "changed_ns": 1}]}, "content": "00"})");
  put(folder / "step_inputs", "provenance.json",
      R"({"made_by": "EchoWeave 0, stitch", "key": "00", "files": [{"name": "volume.mha", "bytes": 1, "content": "00"}]})");
}

std::string textOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

const std::string kBall = R"({"format": 1, "name": "ball", "body": {"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [60, 60, 60]}}})";
const std::string kPatient =
    R"({"format": 1, "name": "base", "mannequin": "ball.json", "box": {"lowest_mm": [-20, -20, -20], "highest_mm": [20, 20, 20]},)"
    R"("parameters": {"size_mm": {"default": 5, "lowest": 1, "highest": 9, "unit": "mm"},)"
    R"("half_mm": {"default": "=size_mm / 2", "lowest": 0, "highest": 9, "unit": "mm"}},)"
    R"("tissues": [{"name": "even", "echo_level": 100, "speckle": 1},)"
    R"({"name": "dark", "echo_level": 0, "speckle": 0, "texture": {"level": 3, "scale_mm": [1, 2, 3]}}],)"
    R"("background": "even", "frames": [{"name": "tilted", "origin_mm": [1, 2, 3], "turned_deg": [10, 20, 30]}],)"
    R"("shapes": [{"name": "pipe", "tube": {"points": [[0, 0, -9, 2], [1, 1, 9, "=half_mm"]]}}, {"name": "round", "mirrored": true,)"
    R"("capsule": {"from_mm": [3, 0, 0], "to_mm": [9, 0, 0], "from_radius_mm": 2, "to_radius_mm": 3}}, {"name": "all", "union":)"
    R"([{"of": "pipe"}, {"of": "round", "blend_mm": 2}, {"shell": {"of": "round", "from_depth_mm": 0, "to_depth_mm": 1}}]}],)"
    R"("organs": [{"name": "egg", "tissue": "dark", "border": {"echo_level": 200, "width_mm": 1, "shine": "front"}, "shape":)"
    R"({"frame": "tilted", "ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": ["=size_mm", "=min(size_mm, 4) * 1", 5]}}},)"
    R"({"name": "lump", "tissue": "dark", "shape": {"difference": [{"of": "all"},)"
    R"({"half_space": {"point_mm": [0, 0, 0], "outward": [0, 0, 1]}}]}}],)"
    R"("motion": {"breathing": {"displacement_mm": [0, 0, -3], "held_depth_mm": 5, "free_depth_mm": 30, "held_by": ["egg"]},)"
    R"("pulse": {"vessels": [{"of": "pipe", "diameter_growth_mm": 0.3}], "chambers": [{"of": "egg", "inward_mm": 0.3}]}},)"
    R"("measurements": [{"name": "size", "kind": "extent", "of": "egg", "direction": [1, 0, 0]},)"
    R"({"name": "wide", "kind": "diameter", "of": "pipe", "place": "largest"}],)"
    R"("planes": [{"name": "across", "near_mm": [0, -60, 0], "towards_mm": [0, 0, 0], "shows": ["egg"]}]})";
const std::string kChild =
    R"({"format": 1, "name": "child", "extends": "base.json", "parameters": {"size_mm": 6}, "remove": {"organs": ["lump"]}, "organs":)"
    R"([{"name": "egg", "border": null}, {"name": "new", "before": "egg", "tissue": "even", "shape": {"grown": {"of": "round", "by_mm": -1}}}]})";
const std::string kSweep =
    R"({"format": 1, "name": "s", "probe": "linear-7.5", "kind": "freehand", "frames": 10,)"
    R"("machine": {"depth_mm": 45, "tgc": [{"depth_mm": 1, "gain_db": 2}]},)"
    R"("stations": [{"near_mm": [0, -60, 1], "lateral": [-1, 0, 0], "towards_mm": [0, 0, 1]}],)"
    R"("tracker": {"noise_mm": 0.1, "calibration_error": {"shift_mm": [1, 0, 0], "turn_deg": [0, 1, 0]}}, "pixel_mm": 0.5})";
const std::string kCase = R"({"format": 1, "id": "x", "title": "X", "patient": {"age_years": 40}, "probes": ["convex-3.5"],)"
                          R"("volume": {"recipe": "patient.json", "sweeps": ["sweep.json"], "reconstruct": {"spacing_mm": 1}},)"
                          R"("start_pose": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],)"
                          R"("targets": [{"kind": "structure", "name": "e", "organ": "egg"}], "scene": {}})";
const std::string kNext = "\n%%\n";  // see folder.h

/// Small recipes, cases and manifests that use every kind of field, and those that are shipped.
/// What is kept of an attempt, what a learning system says, what an outbox notes.
void records(const fs::path& folder) {
  put(folder / "attempt", "attempt",
      R"({"format": 1, "id": "20260105-090000-885f5f0e", "case": "c", "lesson": "l", "lesson_title": "L", "lesson_content": "0", "person": "a",)"
      R"( "started_at": "2026-01-05T09:00:00Z", "program": "0.1.0", "outcomes": [{"step": "s", "verdict": "passed", "score": 0.5, "seconds": 2,)"
      R"( "answer": {"chosen": [0]}, "figures": [{"name": "angle", "value": 4.2, "unit": "deg"}]}]})");
  put(folder / "attempt", "score",
      R"({"format": 1, "score": 0.5, "passed": false, "steps": [{"step": "s", "score": 0.5, "verdict": "passed"}]})");
  std::error_code error;
  for (const auto& form : fs::directory_iterator(fs::path(EW_SOURCE_DIR) / "resources" / "rating_forms", error))
    put(folder / "attempt", form.path().stem().string(), textOf(form.path()));
  put(folder / "lms", "launch",
      "echoweave-cmi5:?endpoint=https%3A%2F%2Flms.example%2Fxapi%2F&fetch=https%3A%2F%2Flms.example%2Ff&registration="
      "886313e1-3b8a-5372-9b90-0c9aee199e5d&activityId=https%3A%2F%2Flms.example%2F1&actor=%7B%22account%22%3A%7B%22homePage%22%3A%22"
      "https%3A%2F%2Flms.example%2F%22%2C%22name%22%3A%22a%22%7D%7D" +
          kNext +
          R"({"contextTemplate": {"contextActivities": {"grouping": []}, "extensions": {}}, "launchMode": "Normal", "moveOn": "Passed"})" +
          kNext + "Wed, 21 Oct 2026 07:28:00 GMT");
  put(folder / "lms", "refusal",
      "x" + kNext + R"({"error-code": "1", "error-text": "no secret here", "message": {"a": [1]}})" + kNext + "120");
  put(folder / "outbox_note", "note",
      R"({"format": 1, "class": "1.2", "instance": "1.2.3", "study": "1.3", "series": "1.4", "status": "waiting", "attempts": 2, "problem": ""})");
  put(folder / "outbox_note", "notes",
      "{}" + kNext + "{\"format\":1}\n" + R"({"id":"1.2.4","status":"stored","about":{"class":"1.2"}})" + "\n" + kNext + "no object");
}

void texts(const fs::path& folder) {
  put(folder / "recipe", "whole", kPatient);
  put(folder / "recipe", "child", kChild + kNext + kPatient + kNext + kBall);
  put(folder / "sweep_recipe", "small", kSweep);
  put(folder / "case_manifest", "recipe", kCase + kNext + kPatient + kNext + kSweep);
  put(folder / "case_manifest", "file", R"({"format": 1, "id": "x", "title": "X", "volume": {"file": "v.mha", "labels": "v.mha"}})");
  put(folder / "plugin_manifest", "small",
      R"({"format": 1, "name": "one", "title": "One", "version": "0.1.0", "abi": 1, "capabilities": ["panel"], "library": "libone.so"})");
  put(folder / "settings", "empty", "{}");
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(fs::path(EW_SOURCE_DIR) / "cases", error)) {
    if (!entry.is_directory()) continue;
    const std::string id = entry.path().filename().string(), text = textOf(entry.path() / "case.json");
    put(folder / "case_manifest", id, text + kNext + textOf(entry.path() / "patient.json"));
    const auto scene = text.find("\"scene\""), open = text.find('{', scene), close = text.find("\n  }", scene);
    if (scene != std::string::npos && open < close) put(folder / "settings", id, text.substr(open, close - open) + "}");
    for (const auto& sweep : fs::directory_iterator(entry.path() / "sweeps", error))
      put(folder / "sweep_recipe", id + "-" + sweep.path().stem().string(), textOf(sweep.path()));
  }
}

/// Small films in each container that is known by its first bytes, and one inside DICOM.
void films(const fs::path& folder) {
  fs::create_directories(folder);
  FilmOf film;
  film.width = film.height = 16;
  film.aspect = {4, 3};
  writeFilm(folder / "matroska", film);
  film.codec = AV_CODEC_ID_PNG;
  film.container = "mov";
  film.matrix = {0, 1, -1, 0};
  writeFilm(folder / "mov", film);
  film.codec = AV_CODEC_ID_MPEG2VIDEO;
  film.matrix.reset();
  for (const char* container : {"avi", "mpeg2video", "mpeg", "mpegts"}) {
    film.container = container;
    writeFilm(folder / container, film);
  }
  CineOf cine;
  cine.syntax = "1.2.840.10008.1.2.4.100";
  cine.columns = cine.rows = 16;
  cine.packed = {bytesOfFile(folder / "mpeg2video")};
  // A TIFF of one grey page: sixteen tags, the orientation and an odd shape of its pixels among them.
  const auto little = [](std::uint32_t value, int bytes) {
    std::string text;
    for (int n = 0; n < bytes; ++n) text += static_cast<char>(value >> (8 * n) & 0xFFu);
    return text;
  };
  std::string tiff = "II" + little(42, 2) + little(8, 4) + little(10, 2);
  const auto entry = [&](std::uint32_t tag, std::uint32_t value) {
    tiff += little(tag, 2) + little(4, 2) + little(1, 4) + little(value, 4);
  };
  const std::uint32_t pixelsAt = 8 + 2 + 10 * 12 + 4;
  for (const auto& [tag, value] :
       {std::pair(256u, 8u), std::pair(257u, 6u), std::pair(258u, 8u), std::pair(259u, 1u), std::pair(262u, 1u), std::pair(273u, pixelsAt),
        std::pair(274u, 6u), std::pair(277u, 1u), std::pair(278u, 6u), std::pair(279u, 48u)})
    entry(tag, value);
  put(folder, "tiff", tiff + little(0, 4) + ramp(48));
  put(folder, "dicom", cineFile(cine));
}

#ifdef EW_HAS_TRACKERS
/// Each kind of body as igtl.cpp takes it: the first byte names the kind (odd: a header is made for it), the second how it is cut up; and
/// streams as a server sends them.
void igtl(const fs::path& folder) {
  using namespace ew;
  const glm::dmat4 pose(0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 10.0, -20.0, 30.0, 1.0);
  IgtlPose probe, needle;
  probe.tool = "ProbeToTracker";
  probe.toolToTracker.matrix = pose;
  needle.tool = "NeedleToTracker";
  needle.state = TrackingState::invalid;
  const GreyImage image(6, 4, 90);
  std::string numbers;  // a place and a quaternion, as big-endian floats: POSITION, QTRANS, and with a name QTDATA
  for (const float value : {1.0F, 2.0F, 3.0F, 0.0F, 0.0F, 0.0F, 1.0F}) {
    auto four = std::bit_cast<std::array<char, 4>>(value);
    std::reverse(four.begin(), four.end());
    numbers.append(four.begin(), four.end());
  }
  std::string name = "ProbeToTracker";
  name.resize(20, '\0');
  const auto bytesOf = [](const std::vector<std::uint8_t>& content) { return std::string(content.begin(), content.end()); };
  const std::pair<const char*, std::string> bodies[] = {{"TRANSFORM", bytesOf(igtlTransformContent(pose))},
                                                        {"TDATA", bytesOf(test::igtlTrackingContent({probe, needle}))},
                                                        {"QTDATA", name + std::string("\1\0", 2) + numbers},
                                                        {"POSITION", numbers},
                                                        {"STATUS", bytesOf(igtlStatusContent({5, 7, "busy", "wait a little"}))},
                                                        {"IMAGE", bytesOf(igtlImageContent(viewOf(image), pose))},
                                                        {"QTRANS", numbers}};
  std::string stream;
  for (std::size_t n = 0; n < std::size(bodies); ++n) {
    const auto& [type, content] = bodies[n];
    put(folder, type, std::string{static_cast<char>(4 * n + 1), '\37'} + content);
    put(folder, std::string(type) + "-2", std::string{static_cast<char>(4 * n + 3), '\37'} + content);
    IgtlMessage message;
    message.type = type;
    message.device = "Device";
    message.content.assign(content.begin(), content.end());
    stream += bytesOf(igtlBytes(message));
  }
  put(folder, "stream", std::string("\0\37", 2) + stream);
}
#endif

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: fuzz_seeds FOLDER\n";
    return 2;
  }
  const fs::path folder = argv[1];
  dicom(folder / "dicom");
  enhanced(folder / "enhanced");
  volumes(folder);
  sequences(folder);
  others(folder);
  stitching(folder);
  texts(folder);
  records(folder);
  films(folder / "film");
#ifdef EW_HAS_TRACKERS
  igtl(folder / "igtl");
#endif
  return 0;
}
