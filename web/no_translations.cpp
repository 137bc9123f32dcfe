// The pages of lessons are English alone: they leave out what isect says in other languages.

#include "viz/lang/catalogue.h"

namespace isect::viz {

const std::vector<PoText>& po_texts() {
  static const std::vector<PoText> none;
  return none;
}

}  // namespace isect::viz
