#pragma once
// Points, meshes and polygons from files of other programs. Coordinates are the doubles nearest to the numbers in a
// text; binary files have floats or doubles. What the readers don't understand they refuse with its place in the file;
// nothing is skipped silently.
//
// These are readers of our own: those packaged for Debian read floats (assimp, ADMesh), or doubles that are not the
// nearest, and take a word that is no number for 0 (tinyobjloader); none of them reports the line of all it leaves out.

#include <array>
#include <string>
#include <vector>

#include "viz/scene.h"

namespace isect::program::scene {

struct ShapeFile {
  std::vector<viz::Vec3> points;              ///< z = 0 in the plane
  std::vector<std::array<int, 3>> triangles;  ///< indices of points; larger faces are cut into them
  std::vector<int> only_face;                 ///< the corners of a mesh's face, if it has but one
  std::vector<int> rings;                     ///< for polygons: how many of the points each outline has, in order
  bool flat = false;                          ///< two coordinates a point
  std::string note;                           ///< what may be meant differently than it is read, as plain sentences
  std::string note_of_faces;                  ///< such a note on faces that are cut, if the triangles are used
};

/// The most points, and the most triangles, of a file.
constexpr std::size_t most_in_file = 1'000'000;

/// Returns the endings of names that can be read: ".csv, .obj, ...".
std::string readable_endings();

/// Reads a file by its name's ending: points from .csv, .tsv, .txt and .xyz; meshes from .obj, .stl, .ply and .off;
/// polygons from .geojson, .json and .wkt. Equal corners of an STL's facets are one point. Throws viz::FileError if it
/// can't be read, viz::BadInput with its name and line, face or byte, if it is broken.
ShapeFile read_shape_file(const std::string& path);
/// Reads the contents of such a file. Throws viz::BadInput.
ShapeFile read_shape(const std::string& bytes, const std::string& name);
/// Gives read_shape_file what it returns from now on for a name, in whatever folder: a page has no files to read.
void give_shape_file(const std::string& name, ShapeFile);

}  // namespace isect::program::scene
