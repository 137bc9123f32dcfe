#pragma once
// A lesson's page as a SCORM 1.2 package. What the page tells its platform, app/book/scorm.js says.

#include <string>

#include "app/platforms/zip.h"
#include "viz/lesson.h"

namespace isect::program::platforms {

/// Returns the package of a lesson's page: imsmanifest.xml with one object to launch, and the page. A newer package of
/// the same lesson has the same identifiers. The archive ends with the comment.
std::string scorm_package(const viz::Lesson&, const ZipEntry& page, const std::string& comment);

}  // namespace isect::program::platforms
