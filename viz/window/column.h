#pragma once
// The lesson panel's column of text, and what it contains besides the step's own words.

#include "viz/window/window_session.h"

namespace isect::viz {

/// Texts and buttons set below each other.
struct Column {
  Ui& ui;
  float x, y, width;
  double size = body_size, pitch = 23;  ///< of its words
  bool draws = true;                    ///< off: it only finds how far down its contents reach
  static constexpr float button_height = 34;

  void paragraph(const std::string& markup, const Colour& colour, bool bold = false) {
    paragraph(markup, colour, size, pitch, bold);
  }
  void paragraph(const std::string& markup, const Colour& colour, double px, double line_pitch, bool bold = false) {
    if (markup.empty()) return;
    const Paragraph p{
        .markup = markup, .width = width, .size = px, .line_pitch = line_pitch, .bold = bold, .colour = colour};
    y += (draws ? rich(ui, p, {x, y}) : ui.texts.size_of(p)).y;
  }
  /// Draws a button as wide as its words, in a row that begins at `from`, or in a row below; moves `from` behind it.
  bool button(const std::string& name, const std::string& words, float& from);
};

/// Draws the question before the next step, or the result of the one before this step. `fresh`: it was not there in the
/// last frame. (question.cpp)
void question(Column&, Player&, AnswerField&, bool fresh);
/// Draws them for a hall: of an answered question only the right answer and the one that was given; and the answer of
/// one that was passed over. A column that draws nothing takes no question that asks for more than a choice.
/// (question.cpp)
void question_in_lecture(Column&, Player&, AnswerField&);
/// Draws the field for what is asked for besides a choice, the tiles of an order, and a button that shows the choices
/// instead. (answer_field.cpp)
void answer_field(Column&, Player&, AnswerField&);
/// Draws the tiles of an order, in rows; each is taken, or put back, at a press. What the field holds is the order.
/// (answer_tiles.cpp)
void order_tiles(Column&, const OrderAsked&, AnswerField&);
/// Draws the pseudocode in rows to point at. Returns the line that was pressed; -1: none. (answer_tiles.cpp)
int lines_to_point_at(Column&, const Walk&);
/// Draws, where the current line errs as published, what it should be and a button to see it fail. (practice.cpp)
/// `before`: gets the player as it was, to come back.
void erratum(Column&, Player&, std::optional<Player>& before, Toast&);
/// Draws, while that failure is on show, a button that leads back to where the reader was. (fault.cpp)
void way_back(Column&, Player&, std::optional<Player>& before);
/// Draws, on the closing card, the button to the next lesson. (ending.cpp)
void next_lesson_button(Column&, Player&, Toast&);
/// Draws, on the closing card, what was skipped or answered wrong, to be answered again. (ending.cpp)
void missed(Column&, Player&, const Settings&);
/// Draws the closing card's references, folded away until they are asked for. (ending.cpp)
void reading(Column&, const Player&, bool& open);
/// Draws the closing card's exercises, each to be tried or looked up: then its solution is among those `shown`. One
/// that is `solved`, by its prompt, has a tick. (practice.cpp)
void exercises(Column&, Player&, std::set<const Exercise*>& shown, const std::set<std::string>& solved, Toast&);
/// Draws the lessons in which this one's ideas occur again, each to be opened. (practice.cpp)
void same_ideas(Column&, Player&, Toast&);
/// Draws, on the closing card of every fifth lesson, the review of these lessons. (review.cpp)
void review_offer(Column&, const Player&, Requests&);
/// Draws the playlist's note, if there is one. (hour_panels.cpp)
void hour_note(Column&, const std::string& note);
/// Draws the exercise that is being tried, and whether its setting has been found. (practice.cpp)
void exercise_on_hand(Column&, Player&);

}  // namespace isect::viz
