#pragma once
// What follows a lesson's own steps: its map of cases, then the card with what a reader takes along.

#include "viz/chart.h"
#include "viz/lesson.h"

namespace isect::viz {

/// The slug of the step that shows the card.
inline constexpr const char* closing_slug = "closing";
/// The slug of a step that tells the lesson's opening alone.
inline constexpr const char* opening_slug = "opening";

/// The last step that shows the scene itself: a map of cases and a closing card may follow it.
int outcome(const Walk&);

/// A step's caption without the lesson's opening, which the first step's begins with.
std::string own_caption(const Lesson&, const Step&);

/// The line of the walk's pseudocode that an erratum speaks of, as published or as corrected; -1 if there is none.
int line_of(const Erratum&, const Walk&);

/// What the card says of the lesson itself: a head and a text each.
std::vector<Card::Row> card_rows(const Closing&);
/// The same, and where its ideas occur again.
std::vector<Card::Row> card_rows(const Lesson&);
/// The head of that row.
inline constexpr const char* shared_head = "Same idea";
/// What others share with the lesson; none where it stands alone.
std::vector<SharedIdea> shared_ideas(const Lesson&);
/// The idea with a capital letter.
std::string heading(const SharedIdea&);
/// A lesson's title up to its colon, markup: for lists of several.
std::string short_title(const Lesson&);
/// The step that shows the card of a lesson that has one; what `before` has told stays.
Step closing_step(const Lesson&, const Step& before);

}  // namespace isect::viz
