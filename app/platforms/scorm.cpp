#include "app/platforms/scorm.h"

#include <fmt/format.h>

#include "app/platforms/quiz_item.h"
#include "viz/formats/svg_path.h"
#include "viz/player/reader_state.h"
#include "viz/text/rich_text.h"

namespace isect::program::platforms {

std::string scorm_package(const viz::Lesson& lesson, const ZipEntry& page, const std::string& comment) {
  const std::string manifest = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<manifest identifier=\"{0}\" version=\"{1}\" xmlns=\"http://www.imsproject.org/xsd/imscp_rootv1p1p2\" "
      "xmlns:adlcp=\"http://www.adlnet.org/xsd/adlcp_rootv1p2\">\n"
      "<metadata><schema>ADL SCORM</schema><schemaversion>1.2</schemaversion></metadata>\n"
      "<organizations default=\"{0}.course\">\n<organization identifier=\"{0}.course\">\n<title>{2}</title>\n"
      "<item identifier=\"{0}.lesson\" identifierref=\"{0}.page\" isvisible=\"true\"><title>{2}</title></item>\n"
      "</organization>\n</organizations>\n<resources>\n"
      "<resource identifier=\"{0}.page\" type=\"webcontent\" adlcp:scormtype=\"sco\" href=\"{3}\">"
      "<file href=\"{3}\"/></resource>\n</resources>\n</manifest>\n",
      identifier(lesson.id), viz::version(), viz::xml_escaped(viz::plain(lesson.title)), page.name);
  return zip_archive({{"imsmanifest.xml", manifest}, page}, comment);
}

}  // namespace isect::program::platforms
