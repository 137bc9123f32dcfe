#include "viz/walk/review.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace isect::viz {
namespace {

/// Returns the step of a question's name, without the method.
std::string step_of_question(const std::string& question) { return question.substr(question.rfind('/') + 1); }

/// Returns the lessons that are built in: scenes from files are opened beside them.
std::vector<const Lesson*> course_of(const std::vector<const Lesson*>& lessons) {
  std::vector<const Lesson*> course;
  for (const Lesson* lesson : lessons)
    if (lesson->made_from.empty()) course.push_back(lesson);
  return course;
}

bool wrong_last(const AnswerRecord& record, const ReviewPrompt& prompt) {
  const AskedBefore* before = record.find(prompt.lesson, prompt.question);
  return before && !before->right;
}

bool has_faults(const AnswerRecord& record, const Lesson& lesson) {
  const auto found = record.lessons.find(lesson.id);
  return found != record.lessons.end() &&
         std::ranges::any_of(found->second, [](const auto& asked) { return !asked.second.right; });
}

enum class Turn { wrong, never, right };

/// A question that may be drawn, and what decides when.
struct Drawable {
  const ReviewPrompt* prompt;
  std::string step;  ///< with its lesson: no two of one are drawn
  Turn turn;
  int last;
  std::uint32_t chance;
};

Drawable drawable(const ReviewPrompt& prompt, const AnswerRecord& record, std::uint32_t seed) {
  const AskedBefore* before = record.find(prompt.lesson, prompt.question);
  const std::string name = prompt.lesson + "/" + prompt.question + "/" + prompt.preset;
  return {&prompt, prompt.lesson + "/" + step_of_question(prompt.question),
          !before         ? Turn::never
          : before->right ? Turn::right
                          : Turn::wrong,
          before ? before->last : 0, shuffled(std::to_string(seed) + "/" + name)};
}

}  // namespace

void AnswerRecord::keep(const std::string& lesson, const std::string& question, bool right) {
  AskedBefore& asked = lessons[lesson][question];
  asked.right = right;
  ++asked.times;
  asked.wrong += !right;
  asked.last = ++answers;
}

const AskedBefore* AnswerRecord::find(const std::string& lesson, const std::string& question) const {
  const auto of_lesson = lessons.find(lesson);
  if (of_lesson == lessons.end()) return nullptr;
  const auto found = of_lesson->second.find(question);
  return found == of_lesson->second.end() ? nullptr : &found->second;
}

std::string question_name(const Lesson& lesson, const Parameters& parameters, const Step& step) {
  const auto method = parameters.find(lesson.group_by);
  std::string name =
      (method == parameters.end() ? std::string() : std::get<std::string>(method->second)) + "/" + step.slug;
  std::erase_if(name, [](char c) { return c >= '0' && c <= '9'; });  // the same question in every round of a loop
  return name;
}

std::vector<ReviewPrompt> prompts_of(const Lesson& lesson) {
  std::vector<ReviewPrompt> all;
  for (const Preset& preset : lesson.presets) {
    const Walk walk = lesson.walk(preset.parameters);
    std::set<std::string> seen;
    for (int i = 1; i < static_cast<int>(walk.steps.size()); ++i) {
      const Step& step = walk.steps[static_cast<std::size_t>(i)];
      if (!step.question) continue;
      const std::string name = question_name(lesson, preset.parameters, step);
      if (seen.insert(name).second) all.push_back({lesson.id, name, preset.id, i, step.question->prompt});
    }
  }
  return all;
}

int review_count(const std::vector<const Lesson*>& lessons) {
  const int all = static_cast<int>(course_of(lessons).size());
  return all < lessons_a_review ? 0 : (all + lessons_a_review - 1) / lessons_a_review;
}

std::vector<const Lesson*> lessons_of_review(const std::vector<const Lesson*>& lessons, int number) {
  const std::vector<const Lesson*> course = course_of(lessons);
  const auto begin = course.begin() + (number - 1) * lessons_a_review;
  return {begin, begin + std::min<std::ptrdiff_t>(lessons_a_review, course.end() - begin)};
}

int review_after(const std::vector<const Lesson*>& lessons, const Lesson& lesson) {
  for (int number = 1; number <= review_count(lessons); ++number)
    if (lessons_of_review(lessons, number).back() == &lesson) return number;
  return 0;
}

std::vector<ReviewPrompt> prompts_of_review(const std::vector<const Lesson*>& lessons, int number,
                                            const AnswerRecord& record) {
  std::vector<ReviewPrompt> all;
  for (int i = 1; i <= number; ++i)
    for (const Lesson* lesson : lessons_of_review(lessons, i)) {
      if (i < number && !has_faults(record, *lesson)) continue;
      for (const ReviewPrompt& prompt : prompts_of(*lesson))
        if (i == number || wrong_last(record, prompt)) all.push_back(prompt);
    }
  return all;
}

std::uint32_t shuffled(const std::string& text) {
  std::uint32_t h = 2166136261u;  // FNV-1a, then MurmurHash3's last steps
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 16777619u;
  h = (h ^ (h >> 16)) * 0x85ebca6bu;
  h = (h ^ (h >> 13)) * 0xc2b2ae35u;
  return h ^ (h >> 16);
}

std::vector<int> draw_review(const std::vector<ReviewPrompt>& prompts, const AnswerRecord& record, std::uint32_t seed,
                             int most) {
  std::vector<Drawable> all;
  for (const ReviewPrompt& prompt : prompts) all.push_back(drawable(prompt, record, seed));
  std::map<std::string, int> of_lesson;
  std::set<std::string> steps;
  const auto rank = [&](const Drawable& d) {
    const bool wrong = d.turn == Turn::wrong;
    return std::tuple(d.turn, wrong ? -d.last : of_lesson[d.prompt->lesson], wrong ? 0 : d.last, d.chance);
  };
  std::vector<int> drawn;
  while (static_cast<int>(drawn.size()) < most) {
    const Drawable* next = nullptr;
    for (const Drawable& d : all)
      if (!steps.contains(d.step) && (!next || rank(d) < rank(*next))) next = &d;
    if (!next) break;
    drawn.push_back(static_cast<int>(next->prompt - prompts.data()));
    steps.insert(next->step);
    ++of_lesson[next->prompt->lesson];
  }
  return drawn;
}

}  // namespace isect::viz
