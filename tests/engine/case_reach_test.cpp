// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <sys/stat.h>

#include <QTest>
#include <nlohmann/json.hpp>

#include "complaint.h"
#include "glisson/core/claim.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/json_file.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/import_labels.h"
#include "glisson/engine/commands/import_surfaces.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/set_video.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/named_video.h"
#include "glisson/engine/parts/video.h"
#include "glisson/engine/script.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/stereo/reach.h"
#include "shapes.h"
#include "state_folder.h"

using namespace glisson;
using namespace glisson::engine;
namespace fs = std::filesystem;

/// A case opens what lies in its own folder, and nothing else.
class CaseReachTest : public QObject {
  Q_OBJECT
 private slots:
  void init() {
    folder_ = std::make_unique<TemporaryFolder>();
    state_ = std::make_unique<test::StateFolder>();
  }
  void cleanup() {
    state_.reset();
    folder_.reset();
  }
  void SurfacesOutsideAreNotRead_data();
  void SurfacesOutsideAreNotRead();
  void LinksOutAreNotFollowed();
  void LinksWithinAre();
  void PipesAreNotWaitedFor();
  void TheListOfACaseIsItsOwn();
  void HolesAreNotSummed();
  void NetworkSourcesAreNotOpened_data();
  void NetworkSourcesAreNotOpened();
  void WhatNobodyHasChosenIsNamedOnly_data();
  void WhatNobodyHasChosenIsNamedOnly();
  void WhatAPersonHasEnteredIsOpened();
  void WhatLiesInTheCaseIsOpened();
  void ADescriptionOpensNothingThatNobodyHasChosen();
  void WhatIsNamedStaysNamedUntilAPersonChooses();
  void WhatWasMadeOfALeftOutVideoStandsAsItWas();
  void ACaseThatIsSavedKeepsItsVideo_data();
  void ACaseThatIsSavedKeepsItsVideo();
  void SavingLeavesANetworkSourceOut();
  void AVideoInTheCasesFolderMovesWithIt();
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

  /// Opened as a window does it. @return the sentence of the note that the video was left out; empty: none.
  std::string lost_by(const fs::path& path, CaseState& state) const {
    std::vector<std::string> lost;
    state = *open_case(path, RunContext(), &lost);
    return lost.size() == 1 && lost[0].starts_with("case.video_lost ") ? lost[0] : std::string();
  }
  bool opens(const fs::path& path) const {
    CaseState state;
    return lost_by(path, state).empty() && state.has(part::video) && !state.has(part::named_video);
  }
  bool only_names(const fs::path& path) const {
    CaseState state;
    return !lost_by(path, state).empty() && !state.has(part::video) && state.has(part::named_video);
  }

  std::unique_ptr<TemporaryFolder> folder_;
  std::unique_ptr<test::StateFolder> state_;  ///< nobody has entered anything yet
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

/// Which edition it is of is asked before anything else is looked at.
void CaseReachTest::TheListOfACaseIsItsOwn() {
  const fs::path path = write_case(nlohmann::json::object());
  const fs::path list = path / "case.json";
  const auto told = [&] {
    return test::complaint<Error>([&] { (void)Script(RunContext()).run(OpenCase{path}); });
  };
  fs::rename(list, folder_->path() / "elsewhere.json");
  fs::create_symlink("../elsewhere.json", list);
  QVERIFY2(told().find("leads out of the case") != std::string::npos, told().c_str());
  QCOMPARE(edition_on_disk(path), std::string());
  fs::remove(list);
  QCOMPARE(::mkfifo(list.c_str(), 0600), 0);
  {
    const Claim writer(::open(list.c_str(), O_RDWR | O_CLOEXEC));  // else it is at its end at once
    QVERIFY2(told().find("neither a file nor a folder") != std::string::npos, told().c_str());
  }
  fs::remove(list);
  write_file_atomically(list, "{}");
  fs::resize_file(list, 200'000'000);
  QVERIFY2(told().find("is larger than such a file can be") != std::string::npos, told().c_str());
}

/// A file of any size costs nobody a place on the disk; to read it to its end takes hours.
void CaseReachTest::HolesAreNotSummed() {
  const fs::path path = write_case(nlohmann::json::object());
  nlohmann::json document = read_json(path / "case.json");
  document["files"] = {{"model/mesh.vtu", "0123456789abcdef"}};
  write_json(path / "case.json", document);
  fs::create_directory(path / "model");
  write_file_atomically(path / "model" / "mesh.vtu", "x");
  std::error_code failure;
  fs::resize_file(path / "model" / "mesh.vtu", 6'000'000'000'000, failure);
  if (failure) QSKIP("no file of this size can be made here");
  std::vector<std::string> lost;
  QVERIFY(open_case(path, RunContext(), &lost).has_value());
  QCOMPARE(lost, (std::vector<std::string>{"case.changed_outside model/mesh.vtu"}));
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
  QVERIFY(!state->has(part::video) && !state->has(part::named_video));
  QCOMPARE(lost.size(), std::size_t(1));
  QVERIFY2(lost[0].starts_with("case.video_lost") && lost[0].ends_with("Choose the source again."),
           lost[0].c_str());
  QVERIFY_THROWS_EXCEPTION(InputError, open_case(path, RunContext()));
}

void CaseReachTest::WhatNobodyHasChosenIsNamedOnly_data() {
  QTest::addColumn<QString>("left");
  for (const char* left : {"device:0", "device:/dev/video2", "/dev/video2", "/films/film.mkv", "../film.mkv",
                           "../*.mkv", "gone.mkv", "link.mkv", "pairs", "pairs/*.png", "pipe.mkv"})
    QTest::newRow(left) << left;
}
void CaseReachTest::WhatNobodyHasChosenIsNamedOnly() {
  QFETCH(QString, left);
  const fs::path path = write_case(video(left.toStdString()));
  write_file_atomically(folder_->path() / "film.mkv", std::string("x"));
  fs::create_symlink("../film.mkv", path / "link.mkv");
  fs::create_directory(path / "pairs");
  fs::create_symlink(folder_->path() / "film.mkv", path / "pairs" / "left_1.png");
  QCOMPARE(::mkfifo((path / "pipe.mkv").c_str(), 0600), 0);
  CaseState state;
  const std::string note = lost_by(path, state);
  QVERIFY2(note.find("names pictures that nobody here has chosen (") != std::string::npos &&
               note.ends_with("Open them yourself if you trust the case."),
           note.c_str());
  QVERIFY(!state.has(part::video) && state.has(part::named_video));
  const std::string named = state[part::named_video]->left.string();
  QVERIFY2(named.ends_with(left.toStdString().substr(left.startsWith("..") ? 2 : 0)) &&
               note.find(named) != std::string::npos,
           named.c_str());
  QVERIFY_THROWS_EXCEPTION(InputError, open_case(path, RunContext()));
}

void CaseReachTest::WhatAPersonHasEnteredIsOpened() {
  for (const char* left : {"device:0", "/films/film.mkv", "../film.mkv", "gone.mkv"}) {
    const fs::path path = write_case(video(left));
    QVERIFY2(only_names(path), left);
    const bool is_path = !std::string(left).starts_with("device:");
    stereo::remember_sources({is_path ? (path / left).string() : left});
    QVERIFY2(opens(path), left);
  }
  // Both views must have been.
  nlohmann::json two = video("device:0");
  two["video"]["right"] = "device:1";
  QVERIFY(only_names(write_case(two)));
  stereo::remember_sources({"device:1"});
  QVERIFY(opens(write_case(two)));
}

void CaseReachTest::WhatLiesInTheCaseIsOpened() {
  const fs::path path = folder_->path() / "a.glisson";
  fs::create_directories(path / "pairs");
  write_file_atomically(path / "film.mkv", std::string("x"));
  write_file_atomically(path / "pairs" / "left_1.png", std::string("x"));
  fs::create_symlink("film.mkv", path / "link.mkv");
  for (const std::string& left : {std::string("film.mkv"), std::string("link.mkv"), std::string("pairs"),
                                  std::string("pairs/left_*.png"), (path / "film.mkv").string()})
    QVERIFY2(opens(write_case(video(left))), left.c_str());
  // What is below a folder whose name only begins like the case's is not.
  fs::create_directory(folder_->path() / "a.glisson-2");
  write_file_atomically(folder_->path() / "a.glisson-2" / "film.mkv", std::string("x"));
  QVERIFY(only_names(write_case(video("../a.glisson-2/film.mkv"))));
}

void CaseReachTest::ADescriptionOpensNothingThatNobodyHasChosen() {
  const fs::path path = write_case(video("source.json"));
  const auto describe = [&path](const fs::path& file, const std::string& left) {
    write_file_atomically(file, "{\"left\": \"" + left + "\"}");
    return path;
  };
  write_file_atomically(path / "film.mkv", std::string("x"));
  QVERIFY(opens(describe(path / "source.json", "film.mkv")));
  QVERIFY(only_names(describe(path / "source.json", "device:0")));
  CaseState state;
  const std::string note = lost_by(path, state);
  QVERIFY2(note.find("source.json, device:0)") != std::string::npos, note.c_str());
  QCOMPARE(named_sources(state).size(), std::size_t{2});
  QCOMPARE(named_sources(state)[1], std::string("device:0"));
  QVERIFY(only_names(describe(path / "source.json", "/films/film.mkv")));
  stereo::remember_sources({"/films/film.mkv"});
  QVERIFY(opens(path));
  // A person's own description opens what it named then, and nothing that it names since.
  const fs::path own = folder_->path() / "own.json";
  write_case(video("../own.json"));
  QVERIFY(only_names(describe(own, "/films/film.mkv")));
  (void)lost_by(path, state);
  QVERIFY2(named_sources(state).size() == 1, "what it holds is not read");
  stereo::remember_sources({own.string()});
  QVERIFY(opens(path));
  QVERIFY(only_names(describe(own, "/films/other.mkv")));
}

void CaseReachTest::WhatIsNamedStaysNamedUntilAPersonChooses() {
  const fs::path path = write_case(video("/films/film.mkv"));
  CaseState state;
  QVERIFY(!lost_by(path, state).empty());
  QCOMPARE(state.stamp(part::named_video).revision, std::uint64_t{1});
  QVERIFY(save_case(path, state, RunContext()));
  QVERIFY2(only_names(path), "saving is not choosing");
  stereo::remember_sources({"/films/film.mkv"});
  QVERIFY(lost_by(path, state).empty());
  QVERIFY(state.has(part::video) && !state.has(part::named_video));
  QCOMPARE(state.stamp(part::video).revision, std::uint64_t{1});
  QCOMPARE((*state[part::video]).left, fs::path("/films/film.mkv"));
  QVERIFY(SetVideo{}.traits().writes == (Parts{part::video, part::named_video}));
}

void CaseReachTest::WhatWasMadeOfALeftOutVideoStandsAsItWas() {
  CaseState made;
  made[part::video] = std::make_shared<const VideoSource>(VideoSource{"/films/film.mkv", {}});
  StereoInput pair;
  pair.frame.left = pair.frame.right = {
      4, 4, 3, std::make_shared<std::vector<std::uint8_t>>(std::size_t{48}, std::uint8_t{90})};
  made[part::frame] = std::make_shared<const StereoInput>(pair);
  made.stamp(part::video).revision = 5;
  const fs::path path = folder_->path() / "b.glisson";
  for (const bool is_current : {true, false}) {
    made.stamp(part::frame) = {6, {{part::video, is_current ? 5U : 4U}}};
    QVERIFY(save_case(path, made, RunContext()));
    const test::StateFolder elsewhere;  // another computer
    CaseState state;
    QVERIFY(!lost_by(path, state).empty());
    const StageState wanted = is_current ? StageState::current : StageState::stale;
    QCOMPARE(stage_state(state, part::frame), wanted);
    QVERIFY(save_case(path, state, RunContext()));
    QVERIFY(!lost_by(path, state).empty());
    QCOMPARE(stage_state(state, part::frame), wanted);
    state[part::video] = state[part::named_video];
    state.stamp(part::video).revision = 9;  // chosen now
    QCOMPARE(stage_state(state, part::frame), wanted);
  }
}

void CaseReachTest::ACaseThatIsSavedKeepsItsVideo_data() {
  QTest::addColumn<bool>("is_written");
  QTest::newRow("as ever") << true;
  QTest::newRow("where nothing can be remembered") << false;
}
void CaseReachTest::ACaseThatIsSavedKeepsItsVideo() {
  QFETCH(bool, is_written);
  if (!is_written) write_file_atomically(state_->path(), std::string("no folder"));
  const fs::path path = folder_->path() / "a.glisson", copy = folder_->path() / "elsewhere" / "b.glisson";
  fs::create_directories(path);
  fs::create_directory(copy.parent_path());
  write_file_atomically(path / "film.mkv", std::string("x"));
  for (const fs::path& left : {fs::path("device:0"), fs::path("/films/film.mkv"), path / "film.mkv"}) {
    CaseState state;
    state[part::video] = std::make_shared<const VideoSource>(VideoSource{left, {}});
    state.stamp(part::video).revision = 1;
    // It must not fail, and the work goes on with it; a copy for recovery lies elsewhere.
    QVERIFY(save_case(copy, state, RunContext()));
    QCOMPARE(opens(copy), is_written);
    QCOMPARE(only_names(copy), !is_written);
  }
}

void CaseReachTest::SavingLeavesANetworkSourceOut() {
  CaseState state = state_with_model();
  state[part::video] = std::make_shared<const VideoSource>(VideoSource{"device:rtsp://192.0.2.1/x", {}});
  const fs::path path = folder_->path() / "a.glisson";
  StereoInput pair;
  pair.frame.left = pair.frame.right = {
      4, 4, 3, std::make_shared<std::vector<std::uint8_t>>(std::size_t{48}, std::uint8_t{90})};
  state[part::frame] = std::make_shared<const StereoInput>(pair);
  state.stamp(part::video).revision = 15;
  // What was taken from it is not out of date by that, but where it was before.
  for (const bool is_current : {true, false}) {
    state.stamp(part::frame) = {16, {{part::video, is_current ? 15U : 14U}}};
    QVERIFY(save_case(path, state, RunContext()));
    const auto opened = open_case(path, RunContext());
    QVERIFY(!opened->has(part::video) && opened->has(part::frame));
    QCOMPARE(stage_state(*opened, part::frame), is_current ? StageState::current : StageState::stale);
  }
}

void CaseReachTest::AVideoInTheCasesFolderMovesWithIt() {
  const fs::path path = folder_->path() / "a.glisson", moved = folder_->path() / "b.glisson";
  for (const char* place : {"film.mkv", "films/film.mkv"}) {
    CaseState state = state_with_model();
    state[part::video] = std::make_shared<const VideoSource>(VideoSource{path / place, {}});
    QVERIFY(save_case(path, state, RunContext()));
    fs::rename(path, moved);
    CaseState opened;
    (void)lost_by(moved, opened);
    const auto& video = opened.has(part::video) ? opened[part::video] : opened[part::named_video];
    QVERIFY(video);
    QCOMPARE(video->left, moved / place);
    fs::remove_all(moved);
  }
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
