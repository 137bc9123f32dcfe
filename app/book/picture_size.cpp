#include "app/book/picture_size.h"

#include <fmt/format.h>

#include "viz/compose/t_axis.h"

namespace isect::program::book {

namespace {

constexpr double width = 264, height = 0.6 * width;
constexpr double shrinks_below = 330;

}  // namespace

viz::PaperSize picture_size(const viz::Scene& scene) {
  viz::PaperSize size;
  size.width = width;
  if (!scene.chart) size.height = height + (scene.axis ? viz::axis_height * size.text_size : 0);
  return size;
}

std::string attributes_of_picture(double wide) {
  return wide > shrinks_below ? fmt::format(" tabindex=\"0\" style=\"--least: {:.0f}px\"", wide) : std::string();
}

}  // namespace isect::program::book
