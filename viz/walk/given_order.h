#pragma once
// What is said to an order that a reader gave as the answer to a question. app/book/answers.js reads and judges it by
// the same rules: tests/typed_answers.json holds both to them.

#include <string>
#include <vector>

#include "viz/lesson.h"

namespace isect::viz {

/// Returns what a tile is called: 'a' for 0.
inline char tile_letter(int tile) { return static_cast<char>('a' + tile); }
/// Returns the tiles in the order of their letters as typed: "cab", "c, a, b". Throws BadInput, which says what is
/// wrong: each of the tiles must be there once.
std::vector<int> order_from(const std::string& typed, int tiles);
/// Returns the letters of an order: "cab".
std::string letters_of(const std::vector<int>& order);
/// Whether some tiles may come in any order among themselves.
bool has_ties(const OrderAsked&);
/// Returns what a reader is told to do.
std::string how_to_order(const OrderAsked&);
/// Returns the first place, from 0, whose tile does not belong there; -1: the order is right.
int first_wrong(const OrderAsked&, const std::vector<int>& order);
/// Returns the mistake behind a wrong order or, where that is not known, the first tile that is out of place, and no
/// more; empty: it is right.
std::string reply_to(const OrderAsked&, const std::vector<int>& order);
/// Returns "*b*, *a*, *c*": the tiles in this order, as markup.
std::string tiles_in(const OrderAsked&, const std::vector<int>& order);
/// Returns "(c) far, then (a) left and (b) right in any order", as markup.
std::string right_order(const OrderAsked&);
/// Returns the choice that is this order, or any right one; -1: none is. The question asks for an order.
int choice_of_order(const Question&, const std::vector<int>& order);

}  // namespace isect::viz
