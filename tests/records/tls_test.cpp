#include <gtest/gtest.h>

#include "library/temporary_folder.h"
#include "records/record_world.h"
#include "records/tls_server.h"

namespace ew::test::records_tls_test {
namespace {

class RecordsTls : public testing::Test {
 protected:
  SendStatementsResult sendTo(const TlsServer& server, const std::string& certificates) {
    auto outbox = StatementOutbox::open(folder_ / "o");
    EXPECT_TRUE(outbox);
    fill(*outbox, 2);
    RecordStore store;
    store.endpoint = server.endpoint();
    store.authorization = *basicAuthorization("mona", "secret");
    store.certificates = certificates;
    SendStatementsOptions options;
    options.wait = [](double) { return true; };
    const auto sent = sendStatements(*outbox, store, options);
    EXPECT_TRUE(sent) << sent.error();
    return sent ? *sent : SendStatementsResult{};
  }
  const TemporaryFolder folder_;
};

TEST_F(RecordsTls, AServerThatNobodyVouchesForGetsNothing) {
  const TlsServer server("IP:127.0.0.1");
  const auto sent = sendTo(server, "");
  EXPECT_EQ(sent.left, 2u);
  EXPECT_EQ(sent.rounds, 1) << "it is not tried again by itself";
  EXPECT_NE(sent.problem.english().find("cannot prove who it is"), std::string::npos) << sent.problem;
  EXPECT_EQ(server.questions(), 0);
}

TEST_F(RecordsTls, ACertificateThatIsTrustedByNameIsEnough) {
  const TlsServer server("IP:127.0.0.1");
  server.writeCertificate(folder_ / "school.pem");
  EXPECT_EQ(sendTo(server, (folder_ / "school.pem").string()).sent, 2u);
  EXPECT_EQ(server.questions(), 1);
}

TEST_F(RecordsTls, ACertificateForAnotherNameIsNot) {
  const TlsServer server("DNS:records.example");
  server.writeCertificate(folder_ / "school.pem");
  const auto sent = sendTo(server, (folder_ / "school.pem").string());
  EXPECT_EQ(sent.left, 2u);
  EXPECT_NE(sent.problem.english().find("cannot prove who it is"), std::string::npos) << sent.problem;
  EXPECT_EQ(server.questions(), 0);
}

TEST_F(RecordsTls, AListOfAuthoritiesThatIsNotThereIsSaid) {
  const TlsServer server("IP:127.0.0.1");
  const auto sent = sendTo(server, (folder_ / "missing.pem").string());
  EXPECT_EQ(sent.left, 2u);
  EXPECT_NE(sent.problem.english().find("Check the address and the certificates"), std::string::npos) << sent.problem;
}

}  // namespace
}  // namespace ew::test::records_tls_test
