# What pictures are made of, for the native build and for the one in web/.

# Lessons, scenes, composition: what needs no machine of its own.
set(viz_sources
  alt_text.cpp asking.cpp branch.cpp case_key.cpp case_map.cpp case_names.cpp camera.cpp camera_rig.cpp chart.cpp
  chart_bars.cpp chart_card.cpp chart_cases.cpp chart_data.cpp chart_maps.cpp chart_markers.cpp chart_mirrored.cpp
  chart_parts.cpp chart_plot.cpp closing.cpp compose.cpp compose/balls.cpp compose/canvas.cpp compose/floor.cpp
  compose/lines.cpp compose/raster.cpp compose/regions.cpp compose/solids.cpp containers.cpp deferred_chart.cpp
  drawing.cpp facet_layers.cpp figure.cpp font/table.cpp framing.cpp geometry.cpp grid.cpp halos.cpp hatch.cpp
  labels.cpp lesson.cpp lights.cpp map_beside.cpp marks.cpp motion.cpp moving.cpp names.cpp objects.cpp page_svg.cpp
  paper.cpp parting.cpp pick.cpp place.cpp player.cpp player_camera.cpp player_pair.cpp rich_text.cpp snap.cpp
  snapshot.cpp snapshot/look.cpp snapshot/look_words.cpp snapshot/said.cpp snapshot/said_words.cpp solids.cpp
  svg_path.cpp t_axis.cpp tex.cpp theme.cpp visibility.cpp wrap.cpp)
# Files, fonts and formats: cairo, Pango, libpng.
set(viz_file_sources
  cairo_drawing.cpp colour_table.cpp compare.cpp crop.cpp files.cpp font/file.cpp font/subset.cpp formats.cpp gif.cpp
  metadata_text.cpp mp4.cpp pdf.cpp png.cpp png_metadata.cpp resources.cpp strip.cpp svg.cpp svg_metadata.cpp text.cpp
  tikz.cpp typeset.cpp)
