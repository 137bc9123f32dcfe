#pragma once
// SIGTERM, SIGINT and SIGHUP are taken as a request to close, so that the state is kept.

#include <atomic>
#include <functional>
#include <thread>

namespace isect::viz {

/// Lets a thread of its own wait for these signals during its lifetime. Create it first: threads that are made later,
/// by an OpenGL driver for instance, inherit the signal mask.
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
