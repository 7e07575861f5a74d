#include "task_threads.h"

#include <gtest/gtest.h>

#include <atomic>
#include <condition_variable>
#include <future>
#include <mutex>

#include "gl_thread.h"

namespace telar::addon {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using std::chrono::steady_clock;

steady_clock::time_point in(milliseconds wait) { return steady_clock::now() + wait; }

/// Holds tasks back until it is opened.
class Barrier {
 public:
  void open() { promise_.set_value(); }
  void wait() const { future_.wait(); }

 private:
  std::promise<void> promise_;
  std::shared_future<void> future_ = promise_.get_future().share();
};

TEST(TaskThreads, RunsInOrderOfArrivalOnOneThread) {
  std::vector<int> order;
  TaskThreads threads(1, 100);
  for (int i = 0; i < 50; ++i) ASSERT_TRUE(threads.post([&order, i] { order.push_back(i); }));
  EXPECT_TRUE(threads.finish([&order] { order.push_back(50); }));
  EXPECT_FALSE(threads.finish([&order] { order.push_back(-1); }));
  EXPECT_TRUE(threads.join(in(seconds(10))));
  ASSERT_EQ(order.size(), 51u);
  EXPECT_TRUE(std::is_sorted(order.begin(), order.end()));
}

TEST(TaskThreads, RunsTwoAtOnce) {
  TaskThreads threads(2, 10);
  Barrier first, second;
  threads.post([&] { first.open(), second.wait(); });
  threads.post([&] { first.wait(), second.open(); });
  threads.finish();
  EXPECT_TRUE(threads.join(in(seconds(10))));
}

TEST(TaskThreads, BoundsItsQueueAndLetsSecondStagesPast) {
  std::vector<int> order;
  Barrier started, go;
  TaskThreads threads(1, 2);
  threads.post([&] { started.open(), go.wait(); });
  started.wait();
  EXPECT_TRUE(threads.post([&] { order.push_back(1); }));
  EXPECT_TRUE(threads.post([&] { order.push_back(2); }));
  EXPECT_FALSE(threads.post([&] { order.push_back(3); }));
  EXPECT_TRUE(threads.postFirst([&] { order.push_back(0); }));
  go.open();
  threads.finish();
  EXPECT_TRUE(threads.join(in(seconds(10))));
  EXPECT_EQ(order, (std::vector{0, 1, 2}));
}

TEST(TaskThreads, DropsWhatWaitsWhenAbandoned) {
  Barrier started, go;
  auto held = std::make_shared<int>(1);
  bool ran = false;
  TaskThreads threads(1, 10);
  threads.post([&] { started.open(), go.wait(); });
  started.wait();
  threads.post([&ran, held] { ran = true; });
  threads.abandon();
  EXPECT_EQ(held.use_count(), 1) << "a dropped task frees what it holds";
  EXPECT_FALSE(threads.post([] {}));
  EXPECT_FALSE(threads.postFirst([] {}));
  go.open();
  EXPECT_TRUE(threads.join(in(seconds(10))));
  EXPECT_FALSE(ran);
}

TEST(TaskThreads, LeavesALateThreadBehind) {
  auto go = std::make_shared<Barrier>();
  std::promise<void> exited;
  auto future = exited.get_future();
  {
    TaskThreads threads(1, 10, [&] { exited.set_value(); });
    threads.post([go] { go->wait(); });
    threads.finish();
    EXPECT_FALSE(threads.join(in(milliseconds(20))));
  }
  go->open();
  EXPECT_EQ(future.wait_for(seconds(10)), std::future_status::ready);
}

TEST(TaskThreads, SurvivesPostsFromManyThreads) {
  std::atomic<int> ran = 0, taken = 0;
  TaskThreads threads(3, 64);
  std::vector<std::thread> posters;
  for (int p = 0; p < 4; ++p) {
    posters.emplace_back([&] {
      for (int i = 0; i < 500; ++i) taken += threads.post([&] { ++ran; });
    });
  }
  for (std::thread& poster : posters) poster.join();
  threads.finish();
  EXPECT_TRUE(threads.join(in(seconds(30))));
  EXPECT_EQ(ran, taken);
}

TEST(TaskThreads, MayBeDestroyedByItsOwnTask) {
  std::promise<void> exited;
  auto future = exited.get_future();
  auto threads = std::make_shared<TaskThreads>(1, 10, [&] { exited.set_value(); });
  Barrier go;
  threads->post([threads, &go] { go.wait(); });
  threads.reset();
  go.open();
  EXPECT_EQ(future.wait_for(seconds(10)), std::future_status::ready);
}

/// Notes the thread that it was made and destroyed on.
class FakeRenderer : public Renderer {
 public:
  explicit FakeRenderer(std::thread::id* destroyed) : destroyed_(destroyed) {}
  ~FakeRenderer() override { *destroyed_ = std::this_thread::get_id(); }
  Frame draw(const std::shared_ptr<const Scene>&, const Shot&, std::span<const std::byte>, const CancelToken&,
             FrameInfo&, const Progress&) override {
    return {};
  }
  void release(const Scene&) override {}
  std::string describe() const override { return "{}"; }
  int liveObjects() const override { return 0; }

 private:
  std::thread::id* destroyed_;
};

TEST(GlThread, MakesUsesAndDestroysTheRendererOnOneThread) {
  std::thread::id made, used, destroyed, atExit;
  GlThread thread(10, [&] {
    atExit = std::this_thread::get_id();
    EXPECT_EQ(destroyed, atExit) << "the renderer is gone before the exit";
  });
  thread.post([&](std::unique_ptr<Renderer>& renderer) {
    made = std::this_thread::get_id();
    renderer = std::make_unique<FakeRenderer>(&destroyed);
  });
  thread.post([&](std::unique_ptr<Renderer>& renderer) {
    EXPECT_TRUE(renderer);
    used = std::this_thread::get_id();
  });
  thread.finish();
  EXPECT_TRUE(thread.join(in(seconds(10))));
  EXPECT_NE(made, std::this_thread::get_id());
  EXPECT_EQ(made, used);
  EXPECT_EQ(made, destroyed);
  EXPECT_EQ(made, atExit);
}

}  // namespace
}  // namespace telar::addon
