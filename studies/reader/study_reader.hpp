#pragma once
// From a study file to a Study. Strict: what is not understood is refused, with the nearest valid choice.
#include <string>
#include <vector>

#include "studies/engine/study.hpp"

namespace ordo::studies {

/// One `--set path=value`: path as in "sweep.dt" or "scene.E", value as JSON, a bare word, or a list "4,8,16".
struct Setting {
    std::string path;
    std::string value;
};

/// The setting of "path=value". Throws InputError where there is no '='.
Setting setting_from(const std::string& text);

/// The value of a setting: a number, true, false, a word, or a list of them separated by commas.
Value value_from(const std::string& text);

/// The study in that file, with the settings put in before it is read. Published tables are read from the file's folder
/// and become part of `document`. Throws InputError: what, where, which rule, the nearest valid choice.
Study read_study(const std::string& path, const std::vector<Setting>& settings = {});

/// The study in that text; `where` opens each message, `folder` is where published tables are looked for.
Study study_from_text(const std::string& text, const std::string& where, const std::string& folder);

}  // namespace ordo::studies
