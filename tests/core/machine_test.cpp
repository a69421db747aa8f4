// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/machine.h"

#include <QTest>

#include "glisson/core/files.h"

using namespace glisson;

class MachineTest : public QObject {
  Q_OBJECT
 private slots:
  void ThisMachineIsSeen();
  void WhatIsTooLittleIsNamed();
  void WhatIsNotKnownIsNotMissed();
};

void MachineTest::ThisMachineIsSeen() {
  const Machine machine = this_machine();
  QVERIFY(machine.cores >= 1);
  QVERIFY(machine.memory.value() > 1e8 && machine.space.value() >= 0.0);
  QCOMPARE(machine.work.string(), work_folder().string());
  try_locks();  // throws where there are none
}

void MachineTest::WhatIsTooLittleIsNamed() {
  const Machine enough{2, 7.5e9, "/tmp", 5e9}, less{1, 7.4e9, "/tmp", 4.9e9};
  QVERIFY(lacks_of(enough).empty());
  QCOMPARE(lacks_of(less),
           (std::vector<MachineLack>{MachineLack::cores, MachineLack::memory, MachineLack::space}));
}

void MachineTest::WhatIsNotKnownIsNotMissed() { QVERIFY(lacks_of({4, {}, "/tmp", {}}).empty()); }

QTEST_APPLESS_MAIN(MachineTest)
#include "machine_test.moc"
