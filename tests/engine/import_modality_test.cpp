// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "glisson/core/files.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/read_image.h"
#include "glisson/engine/commands/set_modality.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/script.h"
#include "glisson/volume/io.h"

using namespace glisson;
using namespace glisson::engine;

class ImportModalityTest : public QObject {
  Q_OBJECT
 private slots:
  void WhatAFileDoesNotSayAPersonMay();
  void WhatWasReadIsNotReadAgain();
  void AnImageOfTheCaseIsToldLater();
};

void ImportModalityTest::WhatAFileDoesNotSayAPersonMay() {
  const TemporaryFolder folder;
  Image image;
  image.grid.size = {12, 12, 12};
  std::vector<std::int16_t> voxels(12 * 12 * 12);
  for (std::size_t i = 0; i < voxels.size(); ++i) voxels[i] = static_cast<std::int16_t>(i % 300);
  image.voxels = std::make_shared<const std::vector<std::int16_t>>(std::move(voxels));
  write_image(folder.path() / "a.mha", image);  // says nothing of modality
  const auto imported = [&](std::optional<Modality> modality) {
    Script script{RunContext()};
    script.run(ImportImage{folder.path() / "a.mha", {}, false, modality});
    return script.state()[part::image]->modality;
  };
  QCOMPARE(imported({}), Modality::other);
  QCOMPARE(imported(Modality::mr), Modality::mr);
  QCOMPARE(imported(Modality::ct), Modality::ct);
}

void ImportModalityTest::WhatWasReadIsNotReadAgain() {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "a.mha";
  Image image;
  image.grid.size = {12, 12, 12};
  image.voxels =
      std::make_shared<const std::vector<std::int16_t>>(std::vector<std::int16_t>(12 * 12 * 12, 70));
  write_image(path, image);
  Script script{RunContext()};
  const Outcome read = script.run(ReadImage{path}).value();
  QVERIFY(!script.state()[part::image]);  // nothing of the case has changed
  std::filesystem::remove(path);
  script.run(ImportImage{path, {}, true, Modality::mr, read.result.as<ReadImage::Result>()});
  QCOMPARE(*script.state()[part::image]->voxels, *image.voxels);
  QCOMPARE(script.state()[part::image]->modality, Modality::mr);
}

void ImportModalityTest::AnImageOfTheCaseIsToldLater() {
  const auto scan = std::make_shared<Scan>();
  scan->image.grid.size = {12, 12, 12};
  scan->image.voxels =
      std::make_shared<const std::vector<std::int16_t>>(std::vector<std::int16_t>(12 * 12 * 12, 70));
  scan->image.modality = Modality::other;
  Script script{RunContext()};
  script.run(ImportImage{"a.mha", {}, false, {}, scan});
  const auto as_read = script.state()[part::image];
  script.run(SetModality{Modality::other});
  QCOMPARE(script.state()[part::image], as_read);  // nothing follows from it anew
  script.run(SetModality{Modality::mr});
  QCOMPARE(script.state()[part::image]->modality, Modality::mr);
  QCOMPARE(script.state()[part::image]->voxels, scan->image.voxels);
  scan->source.series_uid = "1.2.3";
  script.run(ImportImage{"a", {}, false, {}, scan});
  script.run(SetModality{Modality::other});
  QVERIFY_THROWS_EXCEPTION(Error, script.run(SetModality{Modality::ct}));
}

QTEST_APPLESS_MAIN(ImportModalityTest)
#include "import_modality_test.moc"
