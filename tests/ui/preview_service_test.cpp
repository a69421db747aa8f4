// SPDX-License-Identifier: GPL-3.0-or-later
// The service behind previews: the newest order wins, and what is cancelled is never handed over.
#include "glisson/ui/common/preview_service.h"

#include <QTest>
#include <atomic>
#include <semaphore>
#include <vector>

namespace glisson {

/// Orders that wait on the thread until they are let go.
class PreviewServiceTest : public QObject {
  Q_OBJECT
 public:
  PreviewServiceTest()
      : service_(
            this, [this](int order, const RunContext& context) { return compute(order, context); },
            [this](int order, const std::shared_ptr<const int>& result) {
              QCOMPARE(*result, 10 * order);
              accepted_.push_back(order);
            }) {}

 private slots:
  void init();
  void OrdersInBetweenAreDropped();
  void ANewOrderLetsTheOneAtWorkFinish();
  void AnOrderInsteadGivesUpTheOneAtWork();
  void WhatIsCancelledIsNotHandedOver();
  void WhatWasDoneBeforeTheCancelIsNotHandedOverEither();

 private:
  Cancellable<int> compute(int order, const RunContext& context) {
    begun_.release();
    go_.acquire();
    if (context.cancelled()) {
      ++cancelled_;
      return std::nullopt;
    }
    return 10 * order;
  }
  /// Lets one order go that has begun.
  void pass() {
    begun_.acquire();
    go_.release();
  }

  std::counting_semaphore<> begun_{0}, go_{0};
  std::atomic<int> cancelled_ = 0;
  std::vector<int> accepted_;
  ui::PreviewService<int, int> service_;
};

void PreviewServiceTest::init() {
  accepted_.clear();
  cancelled_ = 0;
}

void PreviewServiceTest::OrdersInBetweenAreDropped() {
  service_.give(1);
  begun_.acquire();
  for (const int order : {2, 3, 4}) service_.give(order);
  go_.release();
  pass();
  QTRY_COMPARE(accepted_, (std::vector<int>{1, 4}));
}

void PreviewServiceTest::ANewOrderLetsTheOneAtWorkFinish() {
  service_.give(1);
  begun_.acquire();
  service_.give(2);
  go_.release();
  QTRY_COMPARE(accepted_, std::vector<int>{1});
  pass();
  QTRY_COMPARE(accepted_, (std::vector<int>{1, 2}));
  QCOMPARE(cancelled_.load(), 0);
}

void PreviewServiceTest::AnOrderInsteadGivesUpTheOneAtWork() {
  service_.give(1);
  begun_.acquire();
  service_.give_instead(2);
  go_.release();
  pass();
  QTRY_COMPARE(accepted_, std::vector<int>{2});
  QCOMPARE(cancelled_.load(), 1);
}

void PreviewServiceTest::WhatIsCancelledIsNotHandedOver() {
  service_.give(1);
  begun_.acquire();
  service_.give(2);
  service_.cancel();
  go_.release();
  QTRY_COMPARE(cancelled_.load(), 1);
  service_.give(3);
  pass();
  QTRY_COMPARE(accepted_, std::vector<int>{3});
}

void PreviewServiceTest::WhatWasDoneBeforeTheCancelIsNotHandedOverEither() {
  service_.give(1);
  pass();
  service_.give(2);
  begun_.acquire();  // the first is done and waits for this thread
  service_.cancel();
  go_.release();
  service_.give(3);
  pass();
  QTRY_COMPARE(accepted_, std::vector<int>{3});
}

}  // namespace glisson

QTEST_GUILESS_MAIN(glisson::PreviewServiceTest)
#include "preview_service_test.moc"
