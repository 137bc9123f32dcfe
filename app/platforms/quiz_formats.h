#pragma once
// The formats in which questions go to learning platforms: one table. To add one, write one row.

#include <string>
#include <vector>

#include "app/platforms/quiz_item.h"

namespace isect::program::platforms {

/// The questions of one file.
struct QuizSheet {
  std::string title;            ///< plain text
  std::string name;             ///< of their folder, below that of all files: "ray-sphere/two-roots"
  std::vector<QuizItem> items;  ///< at least one
};

struct QuizFormat {
  std::string name;  ///< as --format takes it
  std::string file;  ///< of the folder's questions; its ending is the one that platforms expect
  std::string mark;  ///< how the files that isect wrote begin or, of packages, end
  bool packed;       ///< a package
  /// Writes a file with its mark; same input, same bytes.
  std::string (*write)(const QuizSheet&, const std::string& mark);
};

const std::vector<QuizFormat>& quiz_formats();

/// The formats that are asked for.
struct AskedFormats {
  bool paper = false;  ///< the pages to print, too
  bool pdf = false;    ///< and those as a PDF
  std::vector<const QuizFormat*> platforms = {};
};
/// Returns the formats of "paper,pdf,moodle", each once, in this order. Throws viz::BadInput.
AskedFormats asked_formats(const std::string& words);

/// Return the files of each format. In them, every question has its picture, alt text, right answer and replies, and
/// the same id each time.
/// Moodle XML: choices and lines are multichoice, numbers numerical, orders shortanswer.
std::string moodle(const QuizSheet&, const std::string& mark);
/// GIFT as Moodle reads it: the same types of question. Pictures stand in the text, as data: addresses.
std::string gift(const QuizSheet&, const std::string& mark);
/// A package of QTI 2.1: an item for each question, and a test with all of them.
std::string qti(const QuizSheet&, const std::string& mark);
/// An H5P.QuestionSet of H5P.MultiChoice: numbers and orders become choices. Without the libraries themselves.
std::string h5p(const QuizSheet&, const std::string& mark);

}  // namespace isect::program::platforms
