#pragma once

#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/records/record_store.h"
#include "ew/records/statement_outbox.h"

namespace ew {

// cmi5 (AICC/ADL, "Quartz", 2016): how a learning management system starts this program for one learner, and what it is told. Section
// numbers are those of the specification.

/// What a launch gives (8.1).
struct Cmi5Launch {          // NOLINT(bugprone-exception-escape): JSON is moved without an exception
  std::string endpoint;      ///< of the record store, ends with '/'
  std::string fetch;         ///< where the token is to be had, once
  nlohmann::json actor;      ///< an agent with an account
  std::string registration;  ///< UUID
  std::string activityId;    ///< of what was launched
};

struct Cmi5Options {
  bool allowsHttp = false;   ///< also to other machines
  std::string certificates;  ///< PEM file of the authorities that are trusted; empty: the system's
  double connect_s = 15.0;
  double timeout_s = 60.0;
};

/// Reads "echoweave-cmi5:?endpoint=...&fetch=...", "echoweave-cmi5://launch?..." and "https://any.where/?...". Anybody's page can open such
/// an address, so whoever acts upon it asks the learner first and names the machine (launchHost).
/// @error badField (what is missing or cannot be used)
[[nodiscard]] Result<Cmi5Launch> cmi5LaunchOf(std::string_view url, const Cmi5Options& options = {});
/// "records.example": the machine that results will go to.
[[nodiscard]] std::string launchHost(const Cmi5Launch& launch);

enum class Cmi5Mode { normal, browse, review };  ///< only in normal is it judged
enum class Cmi5MoveOn { notApplicable, passed, completed, completedAndPassed, completedOrPassed };

/// The document LMS.LaunchData (10).
struct Cmi5LaunchData {            // NOLINT(bugprone-exception-escape): JSON is moved without an exception
  nlohmann::json contextTemplate;  ///< goes into every statement; has the session's id
  Cmi5Mode mode = Cmi5Mode::normal;
  Cmi5MoveOn moveOn = Cmi5MoveOn::notApplicable;
  std::optional<double> masteryScore;  ///< 0 to 1: who has as much has passed
  std::string launchParameters;        ///< ours, from the course: "CASE/LESSON"
  std::string returnUrl;               ///< where the learner goes afterwards; empty: nowhere
  std::string languagePreference;      ///< of the learner (11), "de-DE,en"; empty: not known
};
/// @error badField (field name, value found, value expected)
[[nodiscard]] Result<Cmi5LaunchData> cmi5LaunchDataOf(const nlohmann::json& document);

/// A session from the launch to its end. Statements go through an outbox, so that a network that is away for a while loses none; it should
/// be one of this session's own, since the token is worth nothing afterwards. The rules of 9.3 are kept here: Initialized first, Terminated
/// last, one of each; Completed at most once; Passed or Failed at most once; none of these three unless the mode is normal.
class Cmi5Session {
 public:
  /// Gets the token (POST, once: a launch cannot be begun twice), the launch data and, if the server has them, the learner's preferences.
  /// @error notReadable (no token, or no launch data; says the server's words and that the launch has to be repeated), badField, cancelled
  [[nodiscard]] static Result<Cmi5Session> begin(Cmi5Launch launch, const Cmi5Options& options = {},
                                                 const Progress& progress = noProgress());

  [[nodiscard]] const Cmi5Launch& launch() const { return launch_; }
  [[nodiscard]] const Cmi5LaunchData& data() const { return data_; }
  /// With this session's token: what sendStatements needs.
  [[nodiscard]] const RecordStore& store() const { return store_; }

  using Moment = std::chrono::sys_time<std::chrono::milliseconds>;
  /// Statements, to be put into an outbox in this order. `now` does not run backwards. @error badUsage (against the order)
  [[nodiscard]] Result<nlohmann::json> initialized(Moment now);
  /// @param worked_s what the learner needed, when that is not the time since the session began (of a lesson that was worked on before)
  [[nodiscard]] Result<nlohmann::json> completed(Moment now, std::optional<double> worked_s = {});
  /// Passed or failed. @param score 0 to 1, or none @param success what we think; a mastery score of the launch decides instead, when there
  /// is a score (passedForSystem)
  [[nodiscard]] Result<nlohmann::json> judged(std::optional<double> score, bool success, Moment now, std::optional<double> worked_s = {});
  [[nodiscard]] Result<nlohmann::json> terminated(Moment now);

  [[nodiscard]] bool isOpen() const { return begunAt_.has_value() && !isTerminated_; }
  /// Whether what was said is enough for the system to move on (10.2.4).
  [[nodiscard]] bool movesOn() const;

 private:
  Cmi5Session() = default;  // NOLINT(bugprone-exception-escape): JSON is moved without an exception
  [[nodiscard]] nlohmann::json statement(const char* verb, Moment now) const;
  [[nodiscard]] Result<void> expectOpen(const Message& what) const;

  Cmi5Launch launch_;
  Cmi5LaunchData data_;
  RecordStore store_;
  std::optional<Moment> begunAt_;
  bool isTerminated_ = false;
  bool isCompleted_ = false;
  std::optional<bool> passed_;
};

}  // namespace ew
