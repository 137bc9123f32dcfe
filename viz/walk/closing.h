#pragma once
// What follows a lesson's own steps: its map of cases, then the card with the lesson's summary.

#include <optional>
#include <string>
#include <vector>

#include "viz/chart/chart.h"
#include "viz/lang/message.h"
#include "viz/lesson.h"

namespace isect::viz {

/// The slug of the step that shows the card.
inline constexpr const char* closing_slug = "closing";
/// The slug of a step that tells the lesson's opening alone.
inline constexpr const char* opening_slug = "opening";

/// Returns the last step that shows the scene itself: a map of cases and a closing card may follow it.
int outcome(const Walk&);

/// Returns a step's caption without the lesson's opening, with which the caption of the first step begins.
std::string own_caption(const Lesson&, const Step&);

/// Returns the line of the pseudocode that an erratum is about, as published or as corrected; -1 if there is none.
int line_of(const Erratum&, const Walk&);

/// Returns what the card says of the lesson itself, as pairs of a head and a text.
std::vector<Card::Row> card_rows(const Closing&);
/// How many other lessons a card or a slide names for each idea that they share.
inline constexpr std::size_t named_on_card = 4;
/// Returns these rows, and one that says where the lesson's ideas occur again. At most `most_named` other lessons are
/// named for each idea: where there are more, one less, and how many are left out.
std::vector<Card::Row> card_rows(const Lesson&, std::size_t most_named = 1000);
/// The head of the row of ideas that occur again.
inline constexpr Message shared_head = message("Same idea");
/// Returns the ideas that other lessons share with this one; empty if it stands alone.
std::vector<SharedIdea> shared_ideas(const Lesson&);
/// Returns the idea with a capital letter.
std::string heading(const SharedIdea&);
/// Returns a lesson's title up to its colon, as markup: for lists of several lessons.
std::string short_title(const Lesson&);
/// Who judges a reader's own program, and the command that asks, line by line as it is typed.
struct Judge {
  std::string told;  ///< markup
  std::vector<std::string> command;
};
/// Returns the judge of a lesson that has a case for it.
std::optional<Judge> judge(const Lesson&);
/// Returns the step that shows the card of a lesson that has one; what `before` has told stays.
Step closing_step(const Lesson&, const Step& before);

}  // namespace isect::viz
