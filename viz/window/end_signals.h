#pragma once
// SIGTERM, SIGINT and SIGHUP as a wish to leave, so that the state is kept.

#include <atomic>
#include <functional>
#include <thread>

namespace isect::viz {

/// Makes them wait for a thread of its own, for as long as it lives. Comes first: threads that are made later, by a
/// driver of OpenGL say, inherit that.
class EndSignals {
 public:
  explicit EndSignals(std::function<void()> wake);  ///< `wake` is called from that thread
  ~EndSignals();
  EndSignals(const EndSignals&) = delete;
  EndSignals& operator=(const EndSignals&) = delete;

  bool came() const { return came_; }

 private:
  std::atomic<bool> came_ = false, over_ = false;
  std::thread waiter_;
};

}  // namespace isect::viz
