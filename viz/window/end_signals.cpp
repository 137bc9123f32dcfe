#include "viz/window/end_signals.h"

#include <csignal>
#include <utility>

namespace isect::viz {
namespace {

sigset_t end_signals() {
  sigset_t set;
  sigemptyset(&set);
  for (const int s : {SIGTERM, SIGINT, SIGHUP}) sigaddset(&set, s);
  return set;
}

}  // namespace

EndSignals::EndSignals(std::function<void()> wake) {
  const sigset_t set = end_signals();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  waiter_ = std::thread([this, set, wake = std::move(wake)] {
    int which = 0;
    while (!over_ && sigwait(&set, &which) == 0) {
      if (over_) return;
      came_ = true;
      wake();
    }
  });
}

EndSignals::~EndSignals() {
  over_ = true;
  pthread_kill(waiter_.native_handle(), SIGTERM);
  waiter_.join();
  const sigset_t set = end_signals();
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

}  // namespace isect::viz
