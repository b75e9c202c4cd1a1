#pragma once
// Output files that appear whole or not at all.
#include <string>

namespace ordo::reports {

/// Writes beside `path`, then renames. Throws EnvironmentError (disk full, folder gone); nothing half-written stays.
void write_whole(const std::string& path, const std::string& text);

/// Throws InputError when `path` cannot become a file; creates missing folders.
void check_writable(const std::string& path);

/// `name` as a relative path: characters other than letters, digits and . _ - / become '_', and no part begins with a
/// dot.
std::string safe_path(const std::string& name);

}  // namespace ordo::reports
