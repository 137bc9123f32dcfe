#include "app/platforms/zip.h"

#include <fmt/format.h>
#include <zip.h>

#include <memory>

#include "viz/formats/files.h"

namespace isect::program::platforms {

namespace {

/// 1980-01-01 as an archive tells it: the years since 1980, the month and the day, in 7, 4 and 5 bits. The time is 0.
constexpr zip_uint16_t first_day = 0 << 9 | 1 << 5 | 1;

[[noreturn]] void not_made(const char* why) { throw viz::FileError(fmt::format("cannot make a zip archive: {}", why)); }

}  // namespace

std::string zip_archive(const std::vector<ZipEntry>& entries, const std::string& comment) {
  zip_error_t error;
  zip_error_init(&error);
  const std::unique_ptr<zip_source_t, void (*)(zip_source_t*)> made(zip_source_buffer_create(nullptr, 0, 0, &error),
                                                                    zip_source_free);
  if (!made) not_made(zip_error_strerror(&error));
  std::unique_ptr<zip_t, void (*)(zip_t*)> archive(zip_open_from_source(made.get(), ZIP_CREATE | ZIP_TRUNCATE, &error),
                                                   zip_discard);
  if (!archive) not_made(zip_error_strerror(&error));
  zip_source_keep(made.get());  // the archive frees it when it is closed, and then it is read

  for (const ZipEntry& entry : entries) {
    zip_source_t* const bytes = zip_source_buffer(archive.get(), entry.bytes.data(), entry.bytes.size(), 0);
    const zip_int64_t at = bytes ? zip_file_add(archive.get(), entry.name.c_str(), bytes, ZIP_FL_ENC_UTF_8) : -1;
    if (at < 0) {
      zip_source_free(bytes);
      not_made(zip_strerror(archive.get()));
    }
    if (zip_file_set_dostime(archive.get(), static_cast<zip_uint64_t>(at), 0, first_day, 0) < 0)
      not_made(zip_strerror(archive.get()));
  }
  if (zip_set_archive_comment(archive.get(), comment.c_str(), static_cast<zip_uint16_t>(comment.size())) < 0 ||
      zip_close(archive.get()) < 0)
    not_made(zip_strerror(archive.get()));
  static_cast<void>(archive.release());  // it is closed

  zip_stat_t size;
  if (zip_source_stat(made.get(), &size) < 0 || zip_source_open(made.get()) < 0)
    not_made(zip_error_strerror(zip_source_error(made.get())));
  std::string bytes(size.size, '\0');
  const zip_int64_t read = zip_source_read(made.get(), bytes.data(), bytes.size());
  zip_source_close(made.get());
  if (read != static_cast<zip_int64_t>(bytes.size())) not_made("it can't be read back");
  return bytes;
}

}  // namespace isect::program::platforms
