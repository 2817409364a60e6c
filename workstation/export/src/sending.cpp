#include <algorithm>
#include <set>
#include <utility>

#include "cancellable_layer.h"
#include "dicom_elements.h"
// after DCMTK's configuration
#include <dcmtk/dcmnet/diutil.h>
#include <dcmtk/dcmnet/scu.h>

#include "ew/core/contract.h"
#include "ew/export/outbox.h"

namespace ew {
namespace {
using namespace exporting;

constexpr const char* kFindClass = "1.2.840.10008.5.1.4.1.2.2.1";  // Study Root Query/Retrieve Information Model - FIND

constexpr const char* kPlainSyntaxes[] = {UID_LittleEndianExplicitTransferSyntax, UID_LittleEndianImplicitTransferSyntax};
constexpr std::size_t kMostContexts = 128;  // of one association (PS3.8)
constexpr int kMostAborted = 2;             // questions: an archive that ended the connection each time takes none

std::string classOf(const OutboxEntry& entry) { return aboutOf(entry, kObjectClass); }

/// What an object is written in; empty: it cannot be read.
std::string syntaxOf(const std::filesystem::path& copy) {
  DcmFileFormat file;
  OFString syntax;
  const OFCondition read = file.loadFile(copy.c_str(), EXS_Unknown, EGL_noChange, DCM_MaxReadLength, ERM_metaOnly);
  if (read.bad() || file.getMetaInfo()->findAndGetOFString(DCM_TransferSyntaxUID, syntax).bad()) return {};
  return syntax.c_str();
}

/// Whether an answer to C-FIND says that this question will not be answered (PS3.4, C.4.1.1.4, and PS3.7, C): all but success, pending,
/// cancelled and out of resources.
bool refusesQuestions(Uint16 status) {
  return status != 0 && (status & 0xFF00U) != 0xFF00U && status != 0xFE00U && (status & 0xFF00U) != 0xA700U;
}

bool isTitle(const std::string& title) {
  return !title.empty() && title.size() <= 16 &&
         std::all_of(title.begin(), title.end(), [](char c) { return c > 0x20 && c < 0x7F && c != '\\'; });
}

Result<void> check(const DicomArchive& archive) {
  for (const std::string& title : {archive.aeTitle, archive.ownAeTitle})
    if (!isTitle(title))
      return failure(ErrorCode::badField, say<"'%1' is no title of a DICOM application; it has 1 to 16 letters without blanks.">(title));
  if (archive.host.empty() || archive.port < 1 || archive.port > 65535)
    return failure(ErrorCode::badField, say<"The archive needs a host and a port from 1 to 65535.">());
  return {};
}

Message doesNotAnswer(const DicomArchive& archive, const std::string& why) {
  return say<"The archive %1 at %2 port %3 does not answer as it should (%4).">(archive.aeTitle, archive.host, archive.port, verbatim(why));
}
Message cannotBeReached(const DicomArchive& archive, const std::string& why) {
  return say<"The archive %1 at %2 port %3 cannot be reached (%4); check its host, its port and the network.">(
      archive.aeTitle, archive.host, archive.port, verbatim(why));
}
tl::unexpected<Error> stoppedAsAsked() {
  return failure(ErrorCode::cancelled, say<"Stopped as asked; what was not sent yet stays in the outbox.">());
}

struct Scu final : DcmSCU {
  using DcmSCU::useSecureConnection;
};

/// An association with an archive; whatever it waits for ends soon after the work was cancelled.
class Association {
 public:
  Association(const DicomArchive& archive, const Progress& progress)
      : archive_(archive), progress_(progress), timeout_s_(std::max(1.0, archive.timeout_s)), layer_(progress, timeout_s_) {
    const auto whole_s = static_cast<Uint32>(timeout_s_);
    scu_.setAETitle(archive.ownAeTitle.c_str());
    scu_.setPeerAETitle(archive.aeTitle.c_str());
    scu_.setPeerHostName(archive.host.c_str());
    scu_.setPeerPort(static_cast<Uint16>(archive.port));
    scu_.setACSETimeout(whole_s);
    scu_.setDIMSETimeout(whole_s);
    scu_.setDIMSEBlockingMode(DIMSE_NONBLOCKING);
    scu_.setConnectionTimeout(static_cast<Sint32>(whole_s));
  }

  DcmSCU& scu() { return scu_; }
  /// @return empty, or why it could not be made, a sentence
  [[nodiscard]] Message open() {
    if (const std::string why = whyNotReached(archive_.host, archive_.port, timeout_s_, progress_); !why.empty())
      return cannotBeReached(archive_, why);
    OFCondition status = scu_.initNetwork();
    if (status.good()) status = scu_.useSecureConnection(&layer_);  // plain TCP all the same: the layer decides
    if (status.good()) status = scu_.negotiateAssociation();
    return status.good() ? Message() : doesNotAnswer(archive_, status.text());
  }

 private:
  const DicomArchive& archive_;
  const Progress& progress_;
  double timeout_s_;
  CancellableLayer layer_;
  Scu scu_;
};

/// One connection.
class Round {
 public:
  /// @param abortedQuestions of all rounds: how often the archive ended the connection because it was asked
  Round(DicomOutbox& outbox, const DicomArchive& archive, SendResult& result, int& abortedQuestions, Progress& progress)
      : outbox_(outbox),
        archive_(archive),
        result_(result),
        abortedQuestions_(abortedQuestions),
        progress_(progress),
        association_(archive, progress) {}

  /// @error notWritable, cancelled; what went wrong on the network stands in the result
  Result<void> run() {
    result_.problem = {};
    if (!connect()) return brokenOff();
    for (OutboxEntry entry : std::vector<OutboxEntry>(outbox_.entries())) {
      if (entry.status != OutboxStatus::waiting) continue;
      if (progress_.cancelRequested()) return stopped();
      if (auto sent = send(entry); !sent) return sent;
      if (isBroken_) return brokenOff();
      progress_.report(say<"Sending to the archive">(), share());
    }
    for (OutboxEntry entry : std::vector<OutboxEntry>(outbox_.entries())) {
      if (entry.status != OutboxStatus::stored) continue;
      if (progress_.cancelRequested()) return stopped();
      if (auto asked = ask(entry); !asked) return asked;
      if (isBroken_) return brokenOff();
      progress_.report(say<"Asking the archive">(), share());
    }
    scu_.releaseAssociation();
    return {};
  }

 private:
  Result<void> stopped() {
    scu_.abortAssociation();
    return stoppedAsAsked();
  }
  [[nodiscard]] Result<void> brokenOff() const {
    if (progress_.cancelRequested()) return stoppedAsAsked();
    return {};
  }
  [[nodiscard]] double share() const {
    const std::size_t all = outbox_.entries().size();
    return all == 0 ? 1.0
                    : static_cast<double>(outbox_.count(OutboxStatus::verified) + outbox_.count(OutboxStatus::accepted)) /
                          static_cast<double>(all);
  }
  void fails(Message why) {
    isBroken_ = true;
    result_.problem = std::move(why);
  }
  /// Offers the class of every object that is not done, so that an archive that takes no questions has something to agree to each time;
  /// each in the default transfer syntax too, which every archive has to take (PS3.5, 10.1).
  bool connect() {
    std::set<std::pair<std::string, std::string>> contexts;
    const auto offer = [&](const std::string& classUid, const std::string& syntax) {
      if (!contexts.emplace(classUid, syntax).second) return;
      OFList<OFString> syntaxes;
      syntaxes.push_back(syntax.c_str());
      scu_.addPresentationContext(classUid.c_str(), syntaxes);
    };
    for (const OutboxEntry& entry : outbox_.entries()) {
      if (entry.status != OutboxStatus::waiting && entry.status != OutboxStatus::stored) continue;
      if (contexts.size() + 5 > kMostContexts) break;  // the rest goes with the next connection
      if (const std::string own = syntaxOf(outbox_.copyOf(entry)); !own.empty()) offer(classOf(entry), own);
      for (const char* each : kPlainSyntaxes) offer(classOf(entry), each);
    }
    for (const char* each : kPlainSyntaxes) offer(kFindClass, each);
    Message why = association_.open();
    if (why.empty()) return true;
    fails(std::move(why));
    return false;
  }
  /// What the archive agreed to; 0: to none.
  T_ASC_PresentationContextID contextFor(const std::string& classUid, const std::string& syntax) {
    return syntax.empty() ? T_ASC_PresentationContextID{0} : scu_.findPresentationContextID(classUid.c_str(), syntax.c_str());
  }
  T_ASC_PresentationContextID plainContextFor(const std::string& classUid) {
    for (const char* each : kPlainSyntaxes)
      if (const auto context = contextFor(classUid, each); context != 0) return context;
    return 0;
  }
  Result<void> refuse(OutboxEntry& entry, const std::string& why) {
    entry.status = OutboxStatus::refused;
    entry.problem = why;
    ++result_.refused;
    return outbox_.keep(entry);
  }
  Result<void> send(OutboxEntry& entry) {
    const std::string own = syntaxOf(outbox_.copyOf(entry));
    auto context = contextFor(classOf(entry), own);
    const bool isPlain = std::find(std::begin(kPlainSyntaxes), std::end(kPlainSyntaxes), own) != std::end(kPlainSyntaxes);
    if (context == 0 && isPlain) context = plainContextFor(classOf(entry));
    ++entry.attempts;
    if (context == 0)
      return refuse(entry, plainContextFor(classOf(entry)) == 0 ? "the archive does not take objects of this kind"
                                                                : "the archive does not take images that are packed in this way");
    DcmFileFormat file;
    OFCondition status = file.loadFile(outbox_.copyOf(entry).c_str());
    if (status.bad()) return refuse(entry, "the copy in the outbox cannot be read: " + std::string(status.text()));
    Uint16 answer = 0xC000;
    status = scu_.sendSTORERequest(context, OFFilename(), file.getDataset(), answer);
    if (status.bad()) {
      fails(doesNotAnswer(archive_, status.text()));
      entry.problem = status.text();
      return outbox_.keep(entry);
    }
    if (answer == 0 || (answer & 0xF000U) == 0xB000U) {  // stored, perhaps with a warning (PS3.4, B.2.3)
      entry.status = OutboxStatus::stored;
      entry.problem.clear();
      return outbox_.keep(entry);
    }
    if ((answer & 0xFF00U) == 0xA700U) {  // out of resources: another time
      entry.problem = DU_cstoreStatusString(answer);
      result_.problem = say<"The archive %1 has no room now (%2).">(archive_.aeTitle, verbatim(entry.problem));
      return outbox_.keep(entry);
    }
    return refuse(entry, DU_cstoreStatusString(answer));
  }
  /// The archive takes no questions: its word is all there is.
  Result<void> accept(OutboxEntry& entry) {
    entry.status = OutboxStatus::accepted;
    entry.problem.clear();
    ++result_.accepted;
    return outbox_.keep(entry);
  }
  Result<void> ask(OutboxEntry& entry) {
    const auto context = plainContextFor(kFindClass);
    if (context == 0 || abortedQuestions_ >= kMostAborted) return accept(entry);
    DcmDataset query;
    Elements elements(query);
    elements.text(DCM_QueryRetrieveLevel, "IMAGE");
    elements.text(DCM_StudyInstanceUID, aboutOf(entry, kObjectStudy));
    elements.text(DCM_SeriesInstanceUID, aboutOf(entry, kObjectSeries));
    elements.text(DCM_SOPInstanceUID, entry.id);
    if (auto put = elements.check(); !put) return put;
    OFList<QRResponse*> responses;
    const OFCondition status = scu_.sendFINDRequest(context, &query, &responses);
    bool isThere = false, isWhole = false, isRefused = false;
    for (QRResponse* response : responses) {
      OFString found;
      if (response->m_dataset != nullptr && response->m_dataset->findAndGetOFString(DCM_SOPInstanceUID, found).good() &&
          found == entry.id.c_str())
        isThere = true;
      isWhole = isWhole || response->m_status == STATUS_Success;
      isRefused = isRefused || refusesQuestions(response->m_status);
      delete response;
    }
    if (isRefused) return accept(entry);
    if (status.bad()) {
      fails(doesNotAnswer(archive_, status.text()));
      // Some archives know no other way to refuse a question than to end the connection; one may have been going down.
      if (status == DUL_PEERABORTEDASSOCIATION || status == DUL_PEERREQUESTEDRELEASE) ++abortedQuestions_;
      return {};
    }
    if (isThere) {
      entry.status = OutboxStatus::verified;
      entry.problem.clear();
      ++result_.verified;
      return outbox_.keep(entry);
    }
    if (!isWhole) {
      result_.problem = say<"The archive %1 did not say whether it has every object.">(archive_.aeTitle);
      return {};
    }
    entry.status = OutboxStatus::waiting;
    entry.problem = "the archive did not find it afterwards";
    result_.problem = say<"The archive %1 did not find every object that it had stored.">(archive_.aeTitle);
    return outbox_.keep(entry);
  }

  DicomOutbox& outbox_;
  const DicomArchive& archive_;
  SendResult& result_;
  int& abortedQuestions_;
  Progress& progress_;
  Association association_;
  DcmSCU& scu_ = association_.scu();
  bool isBroken_ = false;
};

}  // namespace

Result<SendResult> sendOutbox(DicomOutbox& outbox, const DicomArchive& archive, const RetryOptions& options, Progress& progress) {
  EW_EXPECTS(options.mostRounds >= 1 && options.firstWait_s >= 0.0);
  if (auto good = check(archive); !good) return passOn(good.error());
  quietDcmtk();
  SendResult result;
  const auto left = [&] { return outbox.count(OutboxStatus::waiting) + outbox.count(OutboxStatus::stored); };
  int abortedQuestions = 0;
  int failed = 0;
  while (left() > 0) {
    const std::size_t before = left();
    ++result.rounds;
    if (auto ran = Round(outbox, archive, result, abortedQuestions, progress).run(); !ran) return passOn(ran.error());
    if (left() == 0 || result.rounds >= options.mostRounds) break;
    failed = left() < before ? 1 : failed + 1;  // it got on
    if (!options.waitFor(options.waitAfter_s(failed), progress)) break;
  }
  const auto unreadable = outbox.unreadable();
  result.left = left() + unreadable.size();
  for (const Error& each : unreadable)
    result.problem = result.problem.empty() ? each.message : joined({std::move(result.problem), each.message});
  return result;
}

Result<void> askArchive(const DicomArchive& archive, const Progress& progress) {
  if (auto good = check(archive); !good) return good;
  quietDcmtk();
  Association association(archive, progress);
  DcmSCU& scu = association.scu();
  OFList<OFString> syntaxes;
  syntaxes.push_back(UID_LittleEndianExplicitTransferSyntax);
  syntaxes.push_back(UID_LittleEndianImplicitTransferSyntax);
  scu.addPresentationContext(UID_VerificationSOPClass, syntaxes);
  Message why = association.open();
  if (why.empty())
    if (const OFCondition status = scu.sendECHORequest(0); status.bad()) why = doesNotAnswer(archive, status.text());
  if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Stopped as asked.">());
  if (!why.empty()) return failure(ErrorCode::notReadable, std::move(why));
  scu.releaseAssociation();
  return {};
}

}  // namespace ew
