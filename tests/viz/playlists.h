#pragma once
// Playlists of the tests' own lessons.

#include <vector>

#include "viz/player/playlist.h"

namespace isect::viz::sample {

/// Returns a stop as a playlist's reader makes it; `steps` from 0, all if there are none.
inline Stop stop_at(const Lesson& lesson, const std::string& name, std::vector<int> steps = {}) {
  Stop stop;
  stop.lesson = &lesson, stop.name = name;
  stop.state.lesson = lesson.id, stop.state.preset = name;
  stop.state.parameters = viz::preset(lesson, name).parameters;
  const Walk walk = lesson.walk(*stop.state.parameters);
  stop.whole = steps.empty();
  for (int i = 0; stop.whole && i < static_cast<int>(walk.steps.size()); ++i) steps.push_back(i);
  stop.asks = steps.front() > 0 && walk.steps[static_cast<std::size_t>(steps.front())].question.has_value();
  stop.state.step = steps.front();
  stop.steps = std::move(steps);
  return stop;
}

/// Returns one that can't be opened.
inline Stop broken_stop() {
  Stop stop;
  stop.name = "gone.json";
  stop.fault = "stop 2, line 4: scene: gone.json: No such file or directory";
  return stop;
}

}  // namespace isect::viz::sample
