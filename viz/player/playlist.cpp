#include "viz/player/playlist.h"

namespace isect::viz {

std::string steps_in_words(const Stop& stop) {
  if (stop.whole || stop.steps.empty()) return {};
  const int first = stop.steps.front() + 1, last = stop.steps.back() + 1;
  if (first == last) return "step " + std::to_string(first);
  if (last - first + 1 == static_cast<int>(stop.steps.size()))
    return "steps " + std::to_string(first) + "–" + std::to_string(last);
  std::string all;
  for (const int step : stop.steps) all += (all.empty() ? "steps " : ", ") + std::to_string(step + 1);
  return all;
}

}  // namespace isect::viz
