// SPDX-License-Identifier: GPL-3.0-or-later
// What of a case is a patient's, beside which no other patient's image may stand.
#include "glisson/engine/patient_held.h"

#include <QTest>

#include "glisson/core/error.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/rig.h"

using namespace glisson;
using namespace glisson::engine;

class PatientHeldTest : public QObject {
  Q_OBJECT
 private slots:
  void TheLaparoscopeIsNoPatients() {
    CaseState state;
    state[part::rig] = std::make_shared<const StereoRig>();
    QVERIFY(!holds_patient(state));
    require_no_patient(state, "a.glisson");
  }
  void AnyStageOfAPatientIs() {
    CaseState image, labels, model, cloud;
    image[part::image] = std::make_shared<const Image>();
    labels[part::labels] = std::make_shared<const LabelMap>();
    model[part::model] = std::make_shared<const model::BuiltModel>();
    cloud[part::cloud] = std::make_shared<const LabelledCloud>();
    for (const CaseState& state : {image, labels, model, cloud}) {
      QVERIFY(holds_patient(state));
      QVERIFY_THROWS_EXCEPTION(InputError, require_no_patient(state, "a.glisson"));
    }
  }
};

QTEST_APPLESS_MAIN(PatientHeldTest)
#include "patient_held_test.moc"
