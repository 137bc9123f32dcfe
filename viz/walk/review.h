#pragma once
// Reviews: after every five lessons eight questions from all of them. What was answered wrong returns first.
// app/book/review.js draws the same for pages; tests/review_cases.json holds both to each other.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "viz/lesson.h"

namespace isect::viz {

/// How many lessons a review is about, and how many questions it asks.
inline constexpr int lessons_a_review = 5, questions_a_review = 8;

/// What a reader has done with a question so far.
struct AskedBefore {
  bool right = false;        ///< the last time
  int times = 0, wrong = 0;  ///< how often it was answered, and answered wrong
  int last = 0;              ///< the last answer's number among all answers, from 1; 0: it is not known
  bool operator==(const AskedBefore&) const = default;
};
/// What came of a review that was taken to its end.
struct ReviewResult {
  int right = 0, of = 0;
  bool operator==(const ReviewResult&) const = default;
};

/// A reader's answers.
struct AnswerRecord {
  int answers = 0;                                                         ///< all that were ever given
  std::map<std::string, std::map<std::string, AskedBefore>> lessons = {};  ///< by lesson, then by question
  std::map<int, ReviewResult> reviews = {};                                ///< the last of each, by its number
  bool operator==(const AnswerRecord&) const = default;

  void keep(const std::string& lesson, const std::string& question, bool right);
  /// Returns null if it was never answered.
  const AskedBefore* find(const std::string& lesson, const std::string& question) const;
};

/// Returns the record as JSON on one line.
std::string text_of(const AnswerRecord&);
/// Reads what text_of writes. Throws BadInput that names the field; nothing of a damaged record is guessed.
AnswerRecord answer_record_from(const std::string& text);

/// Returns the name of the question before a step: "half-b/roots". It is the same in every round of a loop.
std::string question_name(const Lesson&, const Parameters&, const Step&);

/// A question that a review may ask: the one before this step of this preset.
struct ReviewPrompt {
  std::string lesson, question;  ///< as in the record
  std::string preset = {};
  int step = 0;
  std::string asks = {};  ///< markup
};
/// Returns the questions of all presets of a lesson; those before the first step have no picture, and are left out.
std::vector<ReviewPrompt> prompts_of(const Lesson&);

/// Returns how many reviews a course has: the last may be about fewer lessons. A list that is shorter than five has
/// none; lessons made from scene files do not count.
int review_count(const std::vector<const Lesson*>&);
/// Returns the lessons of a review, whose number counts from 1.
std::vector<const Lesson*> lessons_of_review(const std::vector<const Lesson*>&, int number);
/// Returns the number of the review that follows this lesson; 0: none does.
int review_after(const std::vector<const Lesson*>&, const Lesson&);
/// Returns what a review draws from: all questions of its lessons, and those of earlier ones that were answered wrong.
std::vector<ReviewPrompt> prompts_of_review(const std::vector<const Lesson*>&, int number, const AnswerRecord&);

/// Draws questions, no two from the same step of a lesson, and returns their indices in the order of asking: those
/// answered wrong the last time, the most recent first; then those never answered; then the others, each time from a
/// lesson that has the fewest drawn so far, those answered longest ago first. What is left to chance follows `seed`.
std::vector<int> draw_review(const std::vector<ReviewPrompt>&, const AnswerRecord&, std::uint32_t seed,
                             int most = questions_a_review);
/// Returns a number that each letter of the text changes, the same on all machines and in pages.
std::uint32_t shuffled(const std::string& text);

}  // namespace isect::viz
