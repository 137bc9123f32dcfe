#pragma once
// The tasks of `isect grade`: what a program is asked, what it reads, what it answers, by which conventions.
//
// A task's cases are lists of numbers in the order of its fields. Most tasks are a kind of `isect query`: there a case
// in JSON is a line of a query, and the field's names are that kind's. To add a task: a row in tasks.cpp, its families
// in cases.h, and, if it is no kind of a query, its truth in truth.cpp.

#include <string>
#include <vector>

namespace isect::grade {

/// What a program answers for a case, on one line.
enum class Output {
  yes_no,    ///< 1 or 0
  first_t,   ///< a number, or "miss"
  span,      ///< two numbers, or "miss"
  location,  ///< "in", "on" or "out"
  corners,   ///< how many points, then their coordinates
  pairs,     ///< how many pairs, then each as two indices
  nearest    ///< an index and a number, or "miss"
};

/// One input. A list is preceded by how many rows it has.
struct Field {
  enum class Shape { number, vector, rows, list };
  std::string name;  ///< as in a query: "alo"; "a.c" is c within a
  Shape shape = Shape::number;
  int rows = 1, width = 1;  ///< numbers a row; a list's rows are counted in the case
  std::string what;         ///< what it is, with its unit
  std::string bounds = {};  ///< beyond those of every number; empty: none
};

struct Task {
  std::string id, title, question;
  std::string kind;  ///< of a query; empty: the task is no kind of a query
  std::string lesson;
  Output output;
  std::string answer;  ///< what the line of an answer says
  std::vector<Field> fields;
  std::vector<std::string> conventions;
  std::string note = {};  ///< what the lecture note's convention says instead; empty: the same
  double ulps = 0;        ///< how far a value may be off, in ulps of the true one, or of 1 if that is smaller
};

/// Returns all tasks, in the order of the course.
const std::vector<Task>& tasks();
/// Returns the task of this id. Throws viz::BadInput with the nearest name.
const Task& task_named(const std::string& id);
/// How many rows a list has at most.
inline constexpr int most_rows = 64;
/// The size that no number exceeds.
inline constexpr double largest = 1e300;

}  // namespace isect::grade
