// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/stat.h>

#include <QTest>
#include <nlohmann/json.hpp>

#include "complaint.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/json_file.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/import_labels.h"
#include "glisson/engine/commands/import_surfaces.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/video.h"
#include "glisson/engine/script.h"
#include "glisson/geometry/mesh_io.h"
#include "shapes.h"

using namespace glisson;
using namespace glisson::engine;
namespace fs = std::filesystem;

/// A case opens what lies in its own folder, and nothing else.
class CaseReachTest : public QObject {
  Q_OBJECT
 private slots:
  void init() { folder_ = std::make_unique<TemporaryFolder>(); }
  void SurfacesOutsideAreNotRead_data();
  void SurfacesOutsideAreNotRead();
  void LinksOutAreNotFollowed();
  void LinksWithinAre();
  void PipesAreNotWaitedFor();
  void NetworkSourcesAreNotOpened_data();
  void NetworkSourcesAreNotOpened();
  void CamerasOfThisComputerAre();
  void SavingLeavesANetworkSourceOut();
  void CirclesOfLinksAreToldAsSuch();

 private:
  fs::path write_case(const nlohmann::json& parts) const {
    const fs::path path = folder_->path() / "a.glisson";
    fs::create_directories(path);
    write_json(path / "case.json", {{"format", "glisson-case"}, {"version", 1}, {"parts", parts}});
    return path;
  }
  static nlohmann::json video(const std::string& left) {
    return {
        {"video", {{"left", left}, {"right", ""}, {"revision", 1}, {"made_from", nlohmann::json::object()}}}};
  }

  std::unique_ptr<TemporaryFolder> folder_;
};

namespace {

CaseState state_with_model() {
  auto built = std::make_shared<model::BuiltModel>();
  built->model.mesh.vertices.resize(4, 3);
  built->model.mesh.vertices << 0, 0, 0, 0.1, 0, 0, 0, 0.1, 0, 0, 0, 0.1;
  built->model.mesh.tetrahedra.resize(1, 4);
  built->model.mesh.tetrahedra << 0, 1, 2, 3;
  built->model.mesh.labels = {1};
  built->model.surfaces = {{2, "portal_vein", test::box({0.02, 0.02, 0.02})}};
  CaseState state;
  state[part::model] = built;
  state.stamp(part::model).revision = 1;
  return state;
}

}  // namespace

void CaseReachTest::SurfacesOutsideAreNotRead_data() {
  QTest::addColumn<QString>("file");
  for (const char* file : {"../x.vtp", "model/../../x.vtp", "", "/etc/x.vtp"}) QTest::newRow(file) << file;
}
void CaseReachTest::SurfacesOutsideAreNotRead() {
  QFETCH(QString, file);
  const fs::path path = folder_->path() / "a.glisson";
  QVERIFY(save_case(path, state_with_model(), RunContext()));
  QVERIFY(open_case(path, RunContext())->has(part::model));
  write_triangle_mesh(folder_->path() / "x.vtp", test::box({0.02, 0.02, 0.02}), LengthUnit::millimetre);
  nlohmann::json document = read_json(path / "case.json");
  document["parts"]["model"]["surfaces"][0]["file"] = file.toStdString();
  write_json(path / "case.json", document);
  QCOMPARE(test::refused_field([&] { (void)open_case(path, RunContext()); }), std::string("surfaces"));
}

void CaseReachTest::LinksOutAreNotFollowed() {
  write_file_atomically(folder_->path() / "secret.json", R"({"liver": [[1, 2, 3]]})");
  const fs::path path = write_case({{"seeds", {{"revision", 1}, {"made_from", nlohmann::json::object()}}}});
  for (const fs::path& target : {folder_->path() / "secret.json", fs::path("../secret.json"),
                                 fs::path("seeds.json"), fs::path("nowhere")}) {
    fs::create_symlink(target, path / "seeds.json");
    const std::string told = test::complaint([&] { (void)open_case(path, RunContext()); });
    QVERIFY2(told.find("leads out of the case") != std::string::npos, told.c_str());
    fs::remove(path / "seeds.json");
  }
}

void CaseReachTest::LinksWithinAre() {
  const fs::path path = write_case({{"seeds", {{"revision", 1}, {"made_from", nlohmann::json::object()}}}});
  write_file_atomically(path / "clicked.json", R"({"liver": [[1, 2, 3]]})");
  fs::create_symlink("clicked.json", path / "seeds.json");
  QVERIFY(open_case(path, RunContext()).has_value());
  // Nor does it matter how the case itself is reached.
  fs::create_directory_symlink(path, folder_->path() / "link.glisson");
  QVERIFY(open_case(folder_->path() / "link.glisson", RunContext()).has_value());
}

void CaseReachTest::PipesAreNotWaitedFor() {
  const fs::path path = write_case({{"seeds", {{"revision", 1}, {"made_from", nlohmann::json::object()}}}});
  QCOMPARE(::mkfifo((path / "seeds.json").c_str(), 0600), 0);
  const std::string told = test::complaint([&] { (void)open_case(path, RunContext()); });
  QVERIFY2(told.find("neither a file nor a folder") != std::string::npos, told.c_str());
}

void CaseReachTest::NetworkSourcesAreNotOpened_data() {
  QTest::addColumn<QString>("left");
  for (const char* left :
       {"device:http://192.0.2.1/x", "device:rtsp://192.0.2.1/x", "igtl:127.0.0.1:18944/L,R",
        "http://192.0.2.1/x.mkv", "device:souphttpsrc location=http://192.0.2.1 ! fakesink",
        "device:/etc/passwd", "device:file:///etc/passwd", "source.json"})
    QTest::newRow(left) << left;
}
void CaseReachTest::NetworkSourcesAreNotOpened() {
  QFETCH(QString, left);
  const fs::path path = write_case(video(left.toStdString()));
  write_file_atomically(path / "source.json",
                        R"({"left": "device:http://192.0.2.1/x", "layout": "side_by_side"})");
  std::vector<std::string> lost;
  const auto state = open_case(path, RunContext(), &lost);
  QVERIFY(!state->has(part::video));
  QCOMPARE(lost.size(), std::size_t(1));
  QVERIFY2(lost[0].starts_with("case.video_lost") && lost[0].ends_with("Choose the source again."),
           lost[0].c_str());
  QVERIFY_THROWS_EXCEPTION(InputError, open_case(path, RunContext()));
}

void CaseReachTest::CamerasOfThisComputerAre() {
  for (const char* left : {"device:0", "device:/dev/video2", "film.mkv", "/films/film.mkv", "../film.mkv"})
    QVERIFY2(open_case(write_case(video(left)), RunContext())->has(part::video), left);
}

void CaseReachTest::SavingLeavesANetworkSourceOut() {
  CaseState state = state_with_model();
  state[part::video] = std::make_shared<const VideoSource>(VideoSource{"device:rtsp://192.0.2.1/x", {}});
  const fs::path path = folder_->path() / "a.glisson";
  QVERIFY(save_case(path, state, RunContext()));
  QVERIFY(!open_case(path, RunContext())->has(part::video));
}

void CaseReachTest::CirclesOfLinksAreToldAsSuch() {
  const fs::path loop = folder_->path() / "round";
  fs::create_symlink("round", loop);
  Script script{RunContext()};
  for (const Command& command :
       {Command(ImportSurfaces{loop, LengthUnit::millimetre, {}}), Command(ImportLabels{loop, {}}),
        Command(OpenCase{loop}), Command(ImportImage{loop})}) {
    const std::string told = test::complaint<Error>([&] { script.run(command); });
    QVERIFY2(told.find("leads back to itself") != std::string::npos,
             (std::string(command.code()) + ": " + told).c_str());
  }
}

QTEST_APPLESS_MAIN(CaseReachTest)
#include "case_reach_test.moc"
