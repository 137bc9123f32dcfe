// Charts as pictures.

#include "bench/plots.h"
#include "viz/formats/files.h"
#include "viz/gl/offscreen.h"

namespace isect::bench {

std::string svg_of(const Plotted& plotted, viz::ThemeName theme) {
  return viz::svg(viz::chart_figure(plotted.chart, theme, plotted.width).drawing, {{"figure", plotted.name}},
                  {plotted.width});
}

std::string png_of(const Plotted& plotted, viz::ThemeName theme) {
  static viz::Offscreen offscreen;
  return viz::png(offscreen.render(viz::chart_figure(plotted.chart, theme, 4 * plotted.width).drawing),
                  {{"figure", plotted.name}});
}

}  // namespace isect::bench
