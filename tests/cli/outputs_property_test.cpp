// A random command of the whole command line runs in a folder of random files that are named like its inputs and outputs, and is stopped,
// failed or killed at a random moment: no file that is not its own is touched, and unless it ends well the folder is as it was.
// EW_OUTPUTS_RUNS runs of each kind (10,000 alone take minutes), EW_OUTPUTS_SEED begins with another one: run n of seed s is run 0 of s +
// n.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <map>
#include <ostream>
#include <random>
#include <set>
#include <streambuf>

#include "cli/cli_world.h"
#include "ew/cli/run_bench.h"
#include "ew/cli/run_command.h"
#include "ew/core/output_set.h"
#include "ew/io/image_file.h"
#include "ew/io/volume_file.h"

namespace ew::test::outputs_property_test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : random_(seed) {}
  int upTo(int count) { return static_cast<int>(random_() % static_cast<std::uint64_t>(count)); }
  bool once(int in) { return upTo(in) == 0; }
  const std::string& of(const Words& words) { return words[static_cast<std::size_t>(upTo(static_cast<int>(words.size())))]; }

 private:
  std::mt19937_64 random_;
};

/// Everything below a folder by its relative path: "folder", "-> target" or "file: bytes". What programs left aside is named alone.
std::map<std::string, std::string> contentsOf(const fs::path& folder) {
  std::map<std::string, std::string> found;
  for (auto at = fs::recursive_directory_iterator(folder); at != fs::recursive_directory_iterator(); ++at) {
    const std::string name = fs::relative(at->path(), folder).string();
    if (at->is_symlink())
      found[name] = "-> " + fs::read_symlink(at->path()).string();
    else if (!at->is_directory())
      found[name] = "file: " + readText(at->path().string());
    else
      found[name] = "folder";
    if (at->is_directory() && at->path().filename().string().starts_with(".ew-")) at.disable_recursion_pending();
  }
  return found;
}

/// Does something once so many letters were written to it, then nothing more.
class Trip final : public std::streambuf {
 public:
  Trip(int letters, std::function<void()> what) : left_(letters), what_(std::move(what)) {}

 protected:
  int_type overflow(int_type c) override {
    count(1);
    return traits_type::not_eof(c);
  }
  std::streamsize xsputn(const char*, std::streamsize n) override {
    count(n);
    return n;
  }

 private:
  void count(std::streamsize n) {
    if (left_ < 0) return;
    left_ -= n;
    if (left_ < 0 && what_) what_();
  }
  std::streamsize left_;
  std::function<void()> what_;
};

/// The names that everything of a run has; few, so that they meet.
const Words kStems = {"X", "volume", "report", "a-b", ".hidden", "coverage", "long" + std::string(240, 'g')};
const Words kEndings = {".mhd", ".raw", ".mha", ".json", ".png", ".txt", ".igs.mha", ".xml", ".stl", ""};

/// A folder with a command's inputs, foreign files, and the command that goes with them.
class Scenario {
 public:
  Scenario(const fs::path& home, Dice& dice) : home_(home), dice_(dice) {
    const std::vector<void (Scenario::*)()> commands = {
        &Scenario::importRaw,   &Scenario::importVolume, &Scenario::importImages, &Scenario::reconstruct,
        &Scenario::reconstruct, &Scenario::registers,    &Scenario::registers,    &Scenario::slices,
        &Scenario::scans,       &Scenario::phantom,      &Scenario::phantom,      &Scenario::caseCommand,
        &Scenario::caseCommand, &Scenario::plugins,      &Scenario::stitches,     &Scenario::stitches};
    (this->*commands[static_cast<std::size_t>(dice_.upTo(static_cast<int>(commands.size())))])();
    if (dice_.once(40)) bench();
    if (dice_.once(2)) option("--report", outputName({".json", ".json", ".raw", ".mhd", ""}));
    if (dice_.once(30)) words.push_back("--no-such-option");
    for (const auto& [name, content] : contentsOf(home_)) read.insert(name);
    addForeignFiles();
  }

  Words words;
  /// What the command may read: never touched, also when it is named as an output.
  std::set<std::string> read;
  /// May be made or replaced by a command that ends well.
  std::set<std::string> named;
  /// Folders in which what was finished is kept whatever comes: "out/steps".
  std::set<std::string> kept;

  [[nodiscard]] bool isKept(const std::string& name) const {
    return std::any_of(kept.begin(), kept.end(), [&](const std::string& folder) {
      return name == folder || name.starts_with(folder + "/") || folder.starts_with(name + "/");
    });
  }

  [[nodiscard]] std::string text() const {
    std::string all;
    for (const auto& word : words) all += " '" + word + "'";
    return all;
  }

 private:
  [[nodiscard]] std::string at(const std::string& name) const { return (home_ / name).string(); }
  [[nodiscard]] std::string anyName(const Words& endings) { return dice_.of(kStems) + dice_.of(endings); }

  /// A name that nothing has yet, for an input.
  std::string inputName(const std::string& ending) {
    for (;;) {
      const std::string name = dice_.of(kStems) + (dice_.once(2) ? "" : std::to_string(dice_.upTo(5))) + ending;
      bool isFree = true;
      for (const auto& file : filesNamedBy(home_ / name)) isFree = isFree && !fs::exists(fs::symlink_status(file));
      if (isFree) return at(name);
    }
  }

  std::string outputName(const Words& endings) {
    const std::string name = anyName(endings);
    for (const auto& file : filesNamedBy(name)) named.insert(file.string());
    return at(name);
  }

  void option(const std::string& name, const std::string& value) {
    words.push_back(name);
    words.push_back(value);
  }
  void maybe(const std::string& name, const Words& endings, int in = 2) {
    if (dice_.once(in)) option(name, outputName(endings));
  }

  std::string volumeFile() {
    const std::string file = inputName(dice_.once(2) ? ".mha" : ".mhd");
    EXPECT_TRUE(writeVolume(rampVolume({8, 8, 8}), file));
    return file;
  }

  void importRaw() {
    const std::string file = inputName(dice_.once(3) ? ".bin" : ".raw");
    writeText(file, std::string(512, 'v'));
    words = {"import", file, "-o", outputName({".mhd", ".mhd", ".mha"})};
    if (!dice_.once(3)) option("--raw", "8x8x8:u8:1");
  }
  void importVolume() { words = {"import", volumeFile(), "-o", outputName({".mhd", ".mha", ".igs.mha"})}; }
  void importImages() {
    const std::string folder = inputName("");
    fs::create_directory(folder);
    const GreyImage image(8, 8, 9);
    for (const char* name : {"1.png", "2.png", "3.png"}) EXPECT_TRUE(writeImage(viewOf(image), 1.0, fs::path(folder) / name));
    words = {"import", folder, "--spacing", "1", "-o", outputName({".mhd", ".mha"})};
  }
  void reconstruct() {
    const std::string file = inputName(".igs.mha");
    EXPECT_TRUE(writeSequence(parallelSweep(6, 5, 4), file));
    words = {"reconstruct", file, "--spacing", "1", "--threads", "1", "-o", outputName({".mhd", ".mha"})};
    maybe("--coverage", {".mha", ".mhd"});
    maybe("--provenance", {".mha", ".mhd"}, 4);
  }
  void registers() {
    const std::string pairs = inputName(".json");
    nlohmann::json landmarks;
    for (const auto& [name, p] : {std::pair{"a", glm::dvec3(1, 1, 1)}, std::pair{"b", glm::dvec3(6, 1, 1)},
                                  std::pair{"c", glm::dvec3(1, 6, 1)}, std::pair{"d", glm::dvec3(1, 2, 6)}})
      landmarks["landmarks"].push_back({{"name", name}, {"fixed_mm", {p.x, p.y, p.z}}, {"moving_mm", {p.x + 1, p.y, p.z}}});
    writeText(pairs, landmarks.dump());
    words = {"register",
             volumeFile(),
             volumeFile(),
             "--method",
             "landmarks",
             "--landmarks",
             pairs,
             "--threads",
             "1",
             "-o",
             outputName({".txt", "", ".raw"})};
    maybe("--field", {".mha"});
    maybe("--moved", {".mhd", ".mha"});
  }
  void slices() {
    std::string pose = kIdentityPose;
    if (dice_.once(2)) {
      pose = inputName(".txt");
      writeText(pose, kIdentityPose + "\n");
    }
    words = {"slice", volumeFile(), "--pose", pose, "--size", "8x8", "-o", outputName({".png", ".mha"})};
  }
  void scans() {
    words = {"scan", volumeFile(), "--probe", "linear-12", "--pose", kIdentityPose, "--size", "32x32", "-o", outputName({".mha"})};
  }
  std::string patientFile() {
    const std::string body = inputName(".json");
    writeText(body, R"({"format": 1, "name": "ball", "body": {"ellipsoid": {"centre_mm": [0, 0, 0], "radii_mm": [60, 60, 60]}}})");
    const std::string patient = inputName(".json");
    writeText(patient, R"({"format": 1, "name": "ball", "mannequin": ")" + fs::path(body).filename().string() + R"(",
      "box": {"lowest_mm": [-70, -70, -70], "highest_mm": [70, 70, 70]},
      "tissues": [{"name": "even", "echo_level": 110, "speckle": 1}, {"name": "dark", "echo_level": 20, "speckle": 0.2}],
      "background": "even",
      "organs": [{"name": "cyst", "tissue": "dark", "shape": {"ellipsoid": {"centre_mm": [0, -20, 0], "radii_mm": [12, 12, 12]}}}]})");
    return patient;
  }
  void phantom() {
    words = {"phantom", patientFile(), "--spacing", "20", "--threads", "1"};
    maybe("--volume", {".mhd", ".mha"});
    maybe("--labels", {".mhd", ".mha"});
    maybe("--truth", {".json"});
    if (dice_.once(3)) option("--surface", "cyst=" + outputName({".stl"}));
    option("--edge", "10");
  }
  void caseCommand() {
    const std::string folder = inputName("");
    fs::create_directories(fs::path(folder) / "volumes");
    EXPECT_TRUE(writeVolume(rampVolume({6, 5, 4}), fs::path(folder) / "volumes" / "v.mha"));
    nlohmann::json manifest = {
        {"format", 1},
        {"id", "case"},
        {"title", "Case"},
        {"volume", {{"file", "volumes/v.mha"}, {"file_to_world", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}}}};
    if (dice_.once(3)) manifest["title"] = 3;
    writeText((fs::path(folder) / "case.json").string(), manifest.dump());
    const std::string what = dice_.of({"list", "show", "validate", "prepare", "export", "verify"});
    words = {"case", what, what == "list" ? home_.string() : folder};
    if (what == "prepare" && dice_.once(2)) option("--keep-sweeps", at("kept"));
    if (what == "export") option("-o", outputName({".ewcase", ".ewcase", ".zip"}));
    if (dice_.once(3)) {
      const std::string report = fs::path(folder).filename().string() + dice_.of({"/case.json", "/volumes/v.mha", "/new.json"});
      named.insert(report);
      option("--report", at(report));
    }
  }
  void plugins() { words = {"plugins", "list"}; }
  void stitches() {
    const Words stitch{"stitch"};
    if (!cli::isHeadless(stitch)) return plugins();
    const std::string project = inputName(".json");
    nlohmann::json volumes = nlohmann::json::array();
    for (int n = 0; n < 2; ++n)
      volumes.push_back(
          {{"file", fs::path(volumeFile()).filename().string()}, {"to_world", {1, 0, 0, 4 * n, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}});
    writeText(project, nlohmann::json{{"volumes", volumes}}.dump());
    const std::string into = dice_.once(2) ? "." : "out";
    words = {"stitch", project, "-o", at(into), "--threads", "1"};
    if (into == "out" && dice_.once(2)) fs::create_directory(at(into));
    for (const char* name : {"volume.mha", "coverage.mha", "source.mha", "level.mha", "provenance.json"})
      named.insert((fs::path(into) / name).lexically_normal().string());
    kept.insert((fs::path(into) / "steps").lexically_normal().string());
  }
  void bench() {
    words = {"bench", "slicing", "--side", "8", "--size", "16", "--poses", "2", "--repetitions", "1", "--no-peers", "--html", at("page")};
    named = {"page/accuracy-and-time.html"};
    kept.clear();
  }

  void addForeignFiles() {
    const auto put = [&](const fs::path& name) {
      const fs::path file = home_ / name;
      std::error_code problem;
      if (fs::exists(fs::symlink_status(file, problem))) return;
      if (file.has_parent_path()) fs::create_directories(file.parent_path(), problem);
      if (problem || file.filename().string().size() > 255) return;
      if (dice_.once(20))
        fs::create_directory(file);
      else
        writeText(file.string(), "foreign " + std::to_string(dice_.upTo(1000)));
    };
    const int count = dice_.upTo(8);
    for (int n = 0; n < count; ++n) put(anyName(kEndings));
    for (const char* name : {"steps/week1/plan-draft.txt", "steps/photos/2026-01-01.jpg", "steps/.hidden", "steps/volume/notes-1.txt",
                             "out/steps/seam/my-notes.txt", "page/accuracy-and-time.html", "page/notes.html", "kept/mine.txt", "volume.mha",
                             "coverage.mha", "level.mha", "provenance.json", "project.json"})
      if (dice_.once(6)) put(name);
  }

  fs::path home_;
  Dice& dice_;
};

enum class End { left, stopped, full, met };

constexpr const char* kNameOf[] = {"left alone", "stopped", "on a full medium", "with a file that appears at an output's name"};

/// Runs a command in this process. @param onLetter what happens after so many letters of progress
int runWith(const Words& words, int letters, const std::function<void()>& onLetter, const std::atomic<bool>* cancel) {
  Trip err(letters, onLetter), out(-1, {});
  std::ostream errStream(&err), outStream(&out);
  const cli::Surroundings surroundings{outStream, errStream, false, cancel};
  return cli::isBench(words) ? cli::runBench(words, surroundings) : cli::runCommand(words, surroundings);
}

std::uint64_t numberFrom(const char* variable, std::uint64_t otherwise) {
  const char* text = std::getenv(variable);
  std::uint64_t number = otherwise;
  if (text) std::from_chars(text, text + std::string_view(text).size(), number);
  return number;
}

using Contents = std::map<std::string, std::string>;

/// What is wrong between the folder before and after; empty: nothing.
std::string differences(const Contents& before, const Contents& after, const std::function<bool(const std::string&)>& mayDiffer) {
  std::string found;
  for (const auto& [name, content] : before) {
    if (mayDiffer(name)) continue;
    const auto now = after.find(name);
    if (now == after.end())
      found += "\n  gone: " + name;
    else if (now->second != content)
      found += "\n  changed: " + name;
  }
  for (const auto& [name, content] : after)
    if (!before.contains(name) && !mayDiffer(name)) found += "\n  new: " + name;
  return found;
}

/// One random command that is killed; what is left beside the foreign files is only what was being written.
std::string killOne(std::uint64_t seed) {
  Dice dice(seed);
  const TemporaryFolder folder;
  const Scenario scenario(folder.path(), dice);
  const Contents before = contentsOf(folder.path());
  const int letters = dice.once(2) ? dice.upTo(400) : -1;
  const auto moment_us = static_cast<useconds_t>(std::pow(10.0, 2.0 + 0.001 * dice.upTo(2700)));
  const pid_t child = ::fork();
  if (child == 0) {
    runWith(
        scenario.words, letters, [] { ::kill(::getpid(), SIGKILL); }, nullptr);
    ::_exit(0);
  }
  if (letters < 0) {
    ::usleep(moment_us);
    ::kill(child, SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  const std::string wrong = differences(before, contentsOf(folder.path()), [&](const std::string& name) {
    if (scenario.read.contains(name)) return false;
    if (scenario.named.contains(name) || scenario.isKept(name)) return !before.contains(name) || scenario.named.contains(name);
    const fs::path path(name);
    if (path.filename().string().starts_with(".ew-")) return true;
    return name == "page" || name == "kept" || name == "out";  // folders that are made for outputs
  });
  return wrong.empty() ? wrong : "seed " + std::to_string(seed) + ", killed:" + scenario.text() + wrong;
}

/// One random command that fails, is stopped, or is left alone.
std::string endOne(std::uint64_t seed, std::map<std::string, int>& tally) {
  Dice dice(seed);
  const TemporaryFolder folder;
  const Scenario scenario(folder.path(), dice);
  const End end = static_cast<End>(dice.upTo(4));
  const int letters = dice.upTo(300);
  Contents before = contentsOf(folder.path());
  std::atomic<bool> cancel{false};
  std::string heldByIt;  // the folder that the foreign file keeps
  const auto appear = [&] {
    for (const auto& name : scenario.named) {
      const fs::path file = folder.path() / name;
      if (fs::exists(fs::symlink_status(file)) || !fs::is_directory(file.parent_path())) continue;
      writeText(file.string(), "somebody else's");
      before[name] = "file: somebody else's";
      heldByIt = fs::path(name).parent_path().string();
      return;
    }
  };
  rlimit unlimited{};
  ::getrlimit(RLIMIT_FSIZE, &unlimited);
  if (end == End::full) {
    const rlimit small{static_cast<rlim_t>(dice.upTo(1500)), unlimited.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  const auto atMoment = [&] {
    if (end == End::stopped) cancel = true;
    if (end == End::met) appear();
  };
  const int status = runWith(scenario.words, end == End::left || end == End::full ? -1 : letters, atMoment, &cancel);
  ::setrlimit(RLIMIT_FSIZE, &unlimited);
  const bool validated = scenario.words.size() > 1 && (scenario.words[1] == "validate" || scenario.words[1] == "verify") &&
                         status == cli::kFailed;  // its answer
  const bool well = status == cli::kDone || status == cli::kVerdict || validated;
  ++tally[scenario.words.front() + (status == cli::kDone ? ", done" : well ? ", no" : ", failed")];
  const Contents after = contentsOf(folder.path());
  const std::string wrong = differences(before, after, [&](const std::string& name) {
    if (scenario.read.contains(name)) return false;
    if (!before.contains(name) && (scenario.isKept(name) || name == heldByIt)) return true;
    if (!well || !(scenario.named.contains(name) || (name == "page" || name == "out"))) return false;
    return before.contains(name) ? before[name] != "file: somebody else's" : true;
  });
  return wrong.empty() ? wrong
                       : "seed " + std::to_string(seed) + ", " + kNameOf[static_cast<int>(end)] + ", status " + std::to_string(status) +
                             ":" + scenario.text() + wrong;
}

class OutputsProperty : public testing::Test {
 protected:
  OutputsProperty() { std::signal(SIGXFSZ, SIG_IGN); }
  const TemporaryFolder cache_;
  const EnvironmentValue cacheFolder_{"ECHOWEAVE_CACHE", cache_.path().string()};
  const std::uint64_t seed_ = numberFrom("EW_OUTPUTS_SEED", 1);
};

// First, while this process has no threads that a fork would lose.
TEST_F(OutputsProperty, AKilledCommandTouchesNoForeignFile) {
  const std::uint64_t runs = numberFrom("EW_OUTPUTS_RUNS", 40);
  for (std::uint64_t n = 0; n < runs; ++n) ASSERT_EQ(killOne(seed_ + n), "");
}

TEST_F(OutputsProperty, ACommandThatFailsOrIsStoppedLeavesTheFolderAsItWas) {
  const std::uint64_t runs = numberFrom("EW_OUTPUTS_RUNS", 150);
  std::map<std::string, int> tally;
  for (std::uint64_t n = 0; n < runs; ++n) ASSERT_EQ(endOne(seed_ + n, tally), "");
  std::string all;
  int done = 0;
  for (const auto& [what, times] : tally) {
    all += what + ": " + std::to_string(times) + "; ";
    if (what.ends_with(", done")) done += times;
  }
  RecordProperty("tally", all);
  if (runs > 1000) std::printf("%s\n", all.c_str());
  if (runs >= 100) {
    EXPECT_GT(done, static_cast<int>(runs / 10)) << "otherwise little is tested: " << all;
  }
}

TEST_F(OutputsProperty, AStitchedResultStaysAwayWhenItsReportMeetsAForeignFile) {
  if (!cli::isHeadless(Words{"stitch"})) GTEST_SKIP() << "built without the stitching plugin";
  const TemporaryFolder folder;
  ASSERT_TRUE(writeVolume(rampVolume({8, 8, 8}), folder / "v.mha"));
  writeText(folder / "project.json", R"({"volumes": [{"file": "v.mha"}]})");
  const Words words{"stitch", folder / "project.json", "-o", folder / "out", "--report", folder / "r.json"};
  const int met = runWith(
      words, 1, [&] { writeText(folder / "r.json", "somebody else's"); }, nullptr);
  EXPECT_EQ(met, cli::kFailed);
  EXPECT_EQ(contentsOf(folder.path())["r.json"], "file: somebody else's");
  EXPECT_FALSE(fs::exists(folder / "out/volume.mha"));
  EXPECT_FALSE(fs::exists(folder / "out/provenance.json"));
  fs::remove(folder / "r.json");
  EXPECT_EQ(runWith(words, -1, {}, nullptr), cli::kDone);
  EXPECT_TRUE(fs::exists(folder / "out/volume.mha"));
  EXPECT_TRUE(fs::exists(folder / "r.json"));
}

}  // namespace
}  // namespace ew::test::outputs_property_test
