#include "viz/snapshot/baseline_picture.h"

#include <charconv>

#include "viz/formats/colour_table.h"

namespace isect::viz {
namespace {

constexpr int least_slack = 10;

}  // namespace

std::string baseline_png(const Picture& picture, Metadata metadata) {
  int slack = least_slack;
  Picture kept = with_fewer_colours(picture, slack);
  while (!own_colours(kept)) kept = with_fewer_colours(picture, ++slack);
  metadata["slack"] = std::to_string(slack);
  return png(kept, metadata);
}

BaselinePicture read_baseline_png(const std::string& bytes) {
  BaselinePicture kept = {read_png(bytes)};
  if (own_colours(kept.picture)) kept.slack = least_slack;
  const Metadata metadata = png_metadata(bytes);
  if (const auto found = metadata.find("slack"); found != metadata.end())
    std::from_chars(found->second.data(), found->second.data() + found->second.size(), kept.slack);
  return kept;
}

}  // namespace isect::viz
