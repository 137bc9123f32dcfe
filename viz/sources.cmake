# What pictures are made of, for the native build and for the one in web/.

# Files, fonts and formats: what needs cairo, Pango or libpng.
set(viz_file_sources
  compose/crop.cpp compose/strip.cpp
  font/file.cpp font/subset.cpp
  formats/cairo_drawing.cpp formats/colour_table.cpp formats/compare.cpp formats/files.cpp formats/formats.cpp
  formats/gif.cpp formats/metadata_text.cpp formats/mp4.cpp formats/pdf.cpp formats/png.cpp formats/png_metadata.cpp
  formats/svg.cpp formats/svg_metadata.cpp formats/tikz.cpp formats/tikz_faces.cpp
  gl/resources.cpp
  snapshot/baseline_picture.cpp
  text/text.cpp text/typeset.cpp)
# Lessons, scenes, composition: what needs no machine of its own. That is all but the above, OpenGL and the window.
file(GLOB_RECURSE viz_sources CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_LIST_DIR} ${CMAKE_CURRENT_LIST_DIR}/*.cpp)
list(FILTER viz_sources EXCLUDE REGEX "^(gl|window)/")
list(REMOVE_ITEM viz_sources font/make_table.cpp ${viz_file_sources})
