# What pictures are made of, for the native build and for the one in web/.

# Lessons, scenes, composition: what needs no machine of its own.
set(viz_sources
  camera.cpp deferred_chart.cpp drawing.cpp lesson.cpp solids.cpp theme.cpp
  chart/case_key.cpp chart/case_map.cpp chart/case_names.cpp chart/chart.cpp chart/chart_bars.cpp chart/chart_card.cpp
  chart/chart_cases.cpp chart/chart_data.cpp chart/chart_maps.cpp chart/chart_markers.cpp chart/chart_mirrored.cpp
  chart/chart_parts.cpp chart/chart_plot.cpp
  compose/balls.cpp compose/canvas.cpp compose/compose.cpp compose/containers.cpp compose/figure.cpp compose/floor.cpp
  compose/framing.cpp compose/halos.cpp compose/item_names.cpp compose/labels.cpp compose/lines.cpp compose/marks.cpp
  compose/paper.cpp compose/raster.cpp compose/regions.cpp compose/small_multiples.cpp compose/solids.cpp
  compose/t_axis.cpp compose/visibility.cpp
  font/table.cpp
  formats/facet_layers.cpp formats/hatch.cpp formats/page_svg.cpp formats/svg_path.cpp
  player/camera_rig.cpp player/dragging.cpp player/lights.cpp player/map_beside.cpp player/pick.cpp player/player.cpp
  player/player_camera.cpp player/player_pair.cpp player/reader_state.cpp player/snap.cpp player/transition.cpp
  snapshot/drawing_changes.cpp snapshot/drawing_summary.cpp snapshot/snapshot.cpp snapshot/step_changes.cpp
  snapshot/step_json.cpp
  text/names.cpp text/rich_text.cpp text/tex.cpp text/wrap.cpp
  walk/alt_text.cpp walk/branch.cpp walk/closing.cpp walk/question_scene.cpp walk/scene_in_words.cpp
  walk/walk_difference.cpp)
# Files, fonts and formats: cairo, Pango, libpng.
set(viz_file_sources
  compose/crop.cpp compose/strip.cpp
  font/file.cpp font/subset.cpp
  formats/cairo_drawing.cpp formats/colour_table.cpp formats/compare.cpp formats/files.cpp formats/formats.cpp
  formats/gif.cpp formats/metadata_text.cpp formats/mp4.cpp formats/pdf.cpp formats/png.cpp formats/png_metadata.cpp
  formats/svg.cpp formats/svg_metadata.cpp formats/tikz.cpp
  gl/resources.cpp
  text/text.cpp text/typeset.cpp)
