// SPDX-License-Identifier: GPL-3.0-or-later
// What a peer made with the library receives, against what is known to be true.
#include "glisson/openigtlink/sender.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <QTest>
#include <cmath>

#include "glisson/core/error.h"
#include "glisson/geometry/rigid.h"
#include "glisson/patient/label_map.h"
#include "peer_process.h"

using namespace glisson;
using namespace glisson::openigtlink;

namespace {

constexpr double kEpoch = 1700000000.0;
constexpr Label kLesion = structure::kFirstLesion;

/// A surface whose vertices are a tetrahedron's nodes.
SentSurface faces(const TetMesh& mesh, Label structure) {
  SentSurface surface;
  surface.structure = structure;
  surface.triangles.resize(2, 3);
  surface.triangles << 0, 2, 1, 0, 1, 3;
  surface.binding = bind_points(mesh, mesh.vertices);
  return surface;
}

std::shared_ptr<const SentModel> small_model() {
  auto patient = std::make_shared<PatientModel>();
  patient->mesh.vertices.resize(4, 3);
  patient->mesh.vertices << 0.01, 0.02, 0.03, 0.11, 0.02, 0.03, 0.01, 0.12, 0.03, 0.01, 0.02, 0.13;
  patient->mesh.tetrahedra.resize(1, 4);
  patient->mesh.tetrahedra << 0, 1, 2, 3;
  auto sent = std::make_shared<SentModel>();
  for (const Label label : {structure::kParenchyma, structure::kPortalVein, kLesion})
    sent->surfaces.push_back(faces(patient->mesh, label));
  sent->model = patient;
  return sent;
}

/// A quarter turn about the line of sight, 0.2 m away.
CameraFromCt known_pose() {
  CameraFromCt pose;
  pose.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  pose.translation << 0.05, -0.03, 0.2;
  return pose;
}

OverlayFrame frame_of(const SentModel& sent, int index, Validity validity = Validity::valid) {
  OverlayFrame frame;
  frame.index = index;
  frame.seconds = 0.25 * index;
  frame.validity = validity;
  frame.nodes_in_camera = known_pose().apply(sent.model->mesh.vertices);
  LesionVerdict verdict;
  verdict.lesion = kLesion;
  verdict.level = Level::valid;
  frame.lesions = {verdict};
  return frame;
}

SenderOptions options() {
  SenderOptions options;
  options.address.port = 0;  // the system chooses
  options.epoch = kEpoch;
  options.silence = 60.0;
  return options;
}

QString port_text(const Sender& sender) { return QString::number(sender.address().port); }
PeerProcess listener(const Sender& sender) { return PeerProcess({"listen", port_text(sender)}); }

/// Numbers from the given word on.
std::vector<double> numbers(const Words& words, int from) {
  std::vector<double> values;
  for (qsizetype i = from; i < words.size(); ++i) values.push_back(words[i].toDouble());
  return values;
}

bool is_level(const Words& words, const QString& level, const QString& reason) {
  return words.value(0) == "STRING" && words.value(3) == "level=" + level &&
         words.value(4) == "reason=" + reason;
}

/// Points and cells of a POLYDATA message.
std::pair<int, int> extent(const Words& words) { return {words.value(3).toInt(), words.value(4).toInt()}; }

Words wait_for_points(PeerProcess& peer, const QString& name, int points) {
  return peer.wait_for([&](const Words& words) {
    return words.value(0) == "POLYDATA" && words.value(1) == name && extent(words).first == points;
  });
}

}  // namespace

class SenderTest : public QObject {
  Q_OBJECT
 private slots:
  void PoseIsOfTheCameraInRasMillimetres();
  void SurfacesAreInTheCamerasFrameInMillimetres();
  void LevelSaysItsReasonAndTheFramesTime();
  void WithdrawnFrameTakesSurfacesAway();
  void DegradedFrameKeepsTheOrganAlone();
  void LesionThatIsNotValidIsNotSent();
  void NodesOfAnotherModelAreWithdrawn();
  void SilenceWithdraws();
  void FrameToldAgainIsNoYounger_data();
  void FrameToldAgainIsNoYounger();
  void EndWithdraws();
  void LatePeerIsToldTheNewest();
  void SurfacesComeAtTheirRate();
  void SurfacesOfACorrectedFrameComeAtOnce();
  void PeerThatReadsNothingIsGivenUpAndHoldsNobody();
  void PeerThatBabblesHarmsNobody();
  void OnlyTheGivenAddressAnswers();
  void TakenPortIsRefused();
  void NonsenseOptionsAreRefused();
};

void SenderTest::PoseIsOfTheCameraInRasMillimetres() {
  Sender sender(options());
  PeerProcess peer = listener(sender);
  const auto model = small_model();
  sender.tell(model, frame_of(*model, 4));
  const Words words = peer.wait_for("TRANSFORM", "LeftCameraToCtRas");
  QCOMPARE(words.value(2).toDouble(), kEpoch + 1.0);
  const std::vector<double> matrix = numbers(words, 3);
  QCOMPARE(matrix.size(), std::size_t{16});
  // By hand: R^T = [0 1 0; -1 0 0; 0 0 1], -R^T t = (0.03, 0.05, -0.2); then x and y change their signs.
  const double expected[] = {0, -1, 0, -30, 1, 0, 0, -50, 0, 0, 1, -200, 0, 0, 0, 1};
  for (std::size_t i = 0; i < 16; ++i)
    QVERIFY2(std::abs(matrix[i] - expected[i]) < 1e-3, qPrintable(words.join(" ")));
}

void SenderTest::SurfacesAreInTheCamerasFrameInMillimetres() {
  Sender sender(options());
  PeerProcess peer = listener(sender);
  const auto model = small_model();
  OverlayFrame frame = frame_of(*model, 0);
  frame.nodes_in_camera.row(3) += Eigen::RowVector3d(0.004, 0.0, -0.002);  // deformed, too
  sender.tell(model, frame);
  const Words words = wait_for_points(peer, "parenchyma", 4);
  QCOMPARE(extent(words).second, 2);
  const std::vector<double> values = numbers(words, 5);
  QCOMPARE(values.size(), std::size_t{4 * 3 + 2 * 3});
  for (std::size_t i = 0; i < 12; ++i) {
    const double expected = 1e3 * frame.nodes_in_camera(static_cast<int>(i) / 3, static_cast<int>(i) % 3);
    QVERIFY2(std::abs(values[i] - expected) < 1e-3, qPrintable(words.join(" ")));
  }
  QCOMPARE(QVector<double>(values.begin() + 12, values.end()), (QVector<double>{0, 2, 1, 0, 1, 3}));
}

void SenderTest::LevelSaysItsReasonAndTheFramesTime() {
  Sender sender(options());
  PeerProcess peer = listener(sender);
  const auto model = small_model();
  OverlayFrame frame = frame_of(*model, 3, Validity::partly_covered);
  frame.doubtful = true;
  sender.tell(model, frame);
  const Words status = peer.wait_for(
      [](const Words& words) { return words.value(0) == "STATUS" && words.value(5) == "degraded"; });
  QCOMPARE(status.value(1), QString("GlissonLevel"));
  QCOMPARE(status.value(3), QString("13"));  // not ready: less than everything is never "OK"
  QCOMPARE(status.value(4), QString("1"));
  const Words text = peer.wait_for("STRING", "GlissonLevel");
  QCOMPARE(text.value(2).toDouble(), kEpoch + 0.75);
  QCOMPARE(text.mid(3).join(' '), QString("level=degraded reason=partly_covered frame=3 doubtful=yes"));
}

void SenderTest::WithdrawnFrameTakesSurfacesAway() {
  Sender sender(options());
  PeerProcess peer = listener(sender);
  const auto model = small_model();
  sender.tell(model, frame_of(*model, 0));
  QVERIFY(!wait_for_points(peer, "lesion_1", 4).isEmpty());
  // At once, not when surfaces are due again.
  OverlayFrame frame = frame_of(*model, 0, Validity::picture_stands);
  frame.seconds = 0.01;
  sender.tell(model, frame);
  bool pose_came = false;
  const Words level =
      peer.wait_for([](const Words& words) { return is_level(words, "withdrawn", "picture_stands"); });
  QVERIFY(!level.isEmpty());
  QSet<QString> cleared;
  peer.wait_for([&](const Words& words) {
    pose_came |= words.value(0) == "TRANSFORM";
    if (words.value(0) == "POLYDATA" && extent(words) == std::pair(0, 0)) cleared << words.value(1);
    return cleared.size() == 3;
  });
  QCOMPARE(cleared, (QSet<QString>{"parenchyma", "portal_vein", "lesion_1"}));
  QVERIFY(!pose_came);
}

void SenderTest::DegradedFrameKeepsTheOrganAlone() {
  Sender sender(options());
  PeerProcess peer = listener(sender);
  const auto model = small_model();
  sender.tell(model, frame_of(*model, 0, Validity::poor_picture));
  QVERIFY(!wait_for_points(peer, "parenchyma", 4).isEmpty());
  QVERIFY(!wait_for_points(peer, "lesion_1", 0).isEmpty());
  QVERIFY(!wait_for_points(peer, "portal_vein", 0).isEmpty());
}

void SenderTest::LesionThatIsNotValidIsNotSent() {
  Sender sender(options());
  PeerProcess peer = listener(sender);
  const auto model = small_model();
  OverlayFrame frame = frame_of(*model, 0);
  frame.lesions[0].level = Level::degraded;
  sender.tell(model, frame);
  QVERIFY(!wait_for_points(peer, "portal_vein", 4).isEmpty());
  QCOMPARE(extent(peer.wait_for("POLYDATA", "lesion_1")), std::pair(0, 0));
}

void SenderTest::NodesOfAnotherModelAreWithdrawn() {
  Sender sender(options());
  PeerProcess peer = listener(sender);
  const auto model = small_model();
  OverlayFrame frame = frame_of(*model, 0);
  frame.nodes_in_camera(0, 0) = std::nan("");
  sender.tell(model, frame);
  QVERIFY(!peer.wait_for([](const Words& words) { return is_level(words, "withdrawn", "mechanics_failed"); })
               .isEmpty());
  frame = frame_of(*model, 1);
  frame.nodes_in_camera.conservativeResize(3, 3);
  sender.tell(model, frame);
  QVERIFY(!peer.wait_for([](const Words& words) { return is_level(words, "withdrawn", "mechanics_failed"); })
               .isEmpty());
}

void SenderTest::SilenceWithdraws() {
  SenderOptions given = options();
  given.silence = 0.2;
  Sender sender(given);
  PeerProcess peer = listener(sender);
  const auto model = small_model();
  sender.tell(model, frame_of(*model, 7));
  QVERIFY(!wait_for_points(peer, "parenchyma", 4).isEmpty());
  QVERIFY(!peer.wait_for([](const Words& words) { return is_level(words, "withdrawn", "stale"); }).isEmpty());
  QVERIFY(!wait_for_points(peer, "parenchyma", 0).isEmpty());
}

void SenderTest::FrameToldAgainIsNoYounger_data() {
  QTest::addColumn<bool>("corrected");
  QTest::addColumn<bool>("withdrawn");
  QTest::newRow("the case has changed") << false << false;
  QTest::newRow("corrected by hand") << true << false;
  QTest::newRow("withdrawn in between") << false << true;
}

void SenderTest::FrameToldAgainIsNoYounger() {
  QFETCH(bool, corrected);
  QFETCH(bool, withdrawn);
  SenderOptions given = options();
  given.silence = 0.2;
  Sender sender(given);
  PeerProcess peer = listener(sender);
  const auto model = small_model();
  OverlayFrame frame = frame_of(*model, 7);
  sender.tell(model, frame);
  QVERIFY(!peer.wait_for([](const Words& words) { return is_level(words, "withdrawn", "stale"); }).isEmpty());
  if (withdrawn) {
    sender.withdraw(Validity::not_started);
    QVERIFY(
        !peer.wait_for([](const Words& words) { return words.value(4) == "reason=not_started"; }).isEmpty());
  }
  if (corrected) frame.nodes_in_camera.col(0).array() += 0.007;
  sender.tell(model, frame);
  const Words again = peer.wait_for("STRING", "GlissonLevel");
  QVERIFY2(is_level(again, "withdrawn", "stale"), qPrintable(again.join(' ')));
  sender.tell(model, frame_of(*model, 8));
  const Words next = peer.wait_for("STRING", "GlissonLevel");
  QVERIFY2(is_level(next, "valid", "valid"), qPrintable(next.join(' ')));
}

void SenderTest::EndWithdraws() {
  auto sender = std::make_unique<Sender>(options());
  PeerProcess peer = listener(*sender);
  const auto model = small_model();
  sender->tell(model, frame_of(*model, 0));
  QVERIFY(!wait_for_points(peer, "parenchyma", 4).isEmpty());
  sender.reset();
  const QList<Words> lines = peer.all();
  QVERIFY(std::any_of(lines.begin(), lines.end(),
                      [](const Words& words) { return is_level(words, "withdrawn", "not_started"); }));
  QCOMPARE(extent(lines.back()), std::pair(0, 0));
  QCOMPARE(peer.process().exitCode(), 0);
}

void SenderTest::LatePeerIsToldTheNewest() {
  Sender sender(options());
  const auto model = small_model();
  for (int i = 0; i <= 20; ++i) sender.tell(model, frame_of(*model, i));
  PeerProcess peer = listener(sender);
  QVERIFY(!peer.wait_for([](const Words& words) { return words.value(5) == "frame=20"; }).isEmpty());
  QVERIFY(!wait_for_points(peer, "parenchyma", 4).isEmpty());
}

void SenderTest::SurfacesComeAtTheirRate() {
  SenderOptions given = options();
  given.surfaces_per_second = 2.0;  // every second frame
  Sender sender(given);
  PeerProcess peer = listener(sender);
  const auto model = small_model();
  int surfaces = 0;
  for (int i = 0; i <= 8; ++i) {
    sender.tell(model, frame_of(*model, i));
    const QString frame = QStringLiteral("frame=%1").arg(i);
    QVERIFY(!peer.wait_for([&](const Words& words) {
                   surfaces += words.value(0) == "POLYDATA" && words.value(1) == "parenchyma" &&
                               extent(words).first == 4;
                   return words.value(5) == frame;
                 })
                 .isEmpty());
  }
  QCOMPARE(surfaces, 4);  // of frames 0, 2, 4, 6; those of 8 are still to come
}

void SenderTest::SurfacesOfACorrectedFrameComeAtOnce() {
  // The frame is told as it was followed, and then as a hand has put it: the frames' time stands still.
  SenderOptions given = options();
  given.surfaces_per_second = 0.1;
  Sender sender(given);
  PeerProcess peer = listener(sender);
  const auto model = small_model();
  OverlayFrame frame = frame_of(*model, 0);
  sender.tell(model, frame);
  QVERIFY(!wait_for_points(peer, "parenchyma", 4).isEmpty());
  frame.nodes_in_camera.col(0).array() += 0.007;
  sender.tell(model, frame);
  const double expected = 1e3 * frame.nodes_in_camera(0, 0);
  QVERIFY(!peer.wait_for([&](const Words& words) {
                 return words.value(0) == "POLYDATA" && words.value(1) == "parenchyma" &&
                        std::abs(words.value(5).toDouble() - expected) < 1e-3;
               })
               .isEmpty());
}

void SenderTest::PeerThatReadsNothingIsGivenUpAndHoldsNobody() {
  SenderOptions given = options();
  given.patience = 0.3;
  Sender sender(given);
  PeerProcess idle({"idle", port_text(sender)});
  QVERIFY(!idle.wait_for([](const Words& words) { return words.value(0) == "connected"; }).isEmpty());
  PeerProcess peer = listener(sender);
  auto model = std::make_shared<SentModel>(*small_model());
  constexpr int kMany = 60000;  // more than the system keeps on its way for one that does not read
  Points points(kMany, 3);
  for (int i = 0; i < kMany; ++i) points.row(i) = model->model->mesh.vertices.row(i % 4);
  model->surfaces[0].binding = bind_points(model->model->mesh, points);
  int frame = 0;
  for (; sender.state().given_up == 0 && frame < 5000; ++frame) {
    sender.tell(model, frame_of(*model, frame));
    QTest::qWait(10);
  }
  QCOMPARE(sender.state().given_up, 1);
  sender.tell(model, frame_of(*model, frame));
  const QString last = QStringLiteral("frame=%1").arg(frame);
  QVERIFY(!peer.wait_for([&](const Words& words) { return words.value(5) == last; }).isEmpty());
}

void SenderTest::PeerThatBabblesHarmsNobody() {
  Sender sender(options());
  PeerProcess babbler({"babble", port_text(sender)});
  QVERIFY(!babbler.wait_for([](const Words& words) { return words.value(0) == "said"; }).isEmpty());
  PeerProcess peer = listener(sender);
  const auto model = small_model();
  sender.tell(model, frame_of(*model, 1));
  QVERIFY(!wait_for_points(peer, "parenchyma", 4).isEmpty());
}

void SenderTest::OnlyTheGivenAddressAnswers() {
  Sender sender(options());
  QCOMPARE(QString::fromStdString(sender.address().host), QString("127.0.0.1"));
  const auto answers = [&](const char* host) {
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(sender.address().port));
    inet_pton(AF_INET, host, &address.sin_addr);
    const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
    const bool connected =
        ::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    ::close(socket);
    return connected;
  };
  QVERIFY(answers("127.0.0.1"));
  QVERIFY(!answers("127.0.0.2"));  // this computer, too: a server at every address would answer
}

void SenderTest::TakenPortIsRefused() {
  Sender sender(options());
  SenderOptions same;
  same.address = sender.address();
  try {
    Sender second(same);
    QFAIL("two servers at one port");
  } catch (const InputError& error) {
    QVERIFY(QString(error.what()).contains("another program"));
    QVERIFY(QString(error.what()).contains(port_text(sender)));
  }
}

void SenderTest::NonsenseOptionsAreRefused() {
  for (double SenderOptions::*field :
       {&SenderOptions::surfaces_per_second, &SenderOptions::silence, &SenderOptions::patience}) {
    SenderOptions given = options();
    given.*field = 0.0;
    QVERIFY_THROWS_EXCEPTION(InputError, Sender{given});
  }
  Sender sender(options());
  QVERIFY_THROWS_EXCEPTION(PreconditionError, sender.withdraw(Validity::valid));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, sender.tell(nullptr, {}));
}

QTEST_GUILESS_MAIN(SenderTest)
#include "sender_test.moc"
