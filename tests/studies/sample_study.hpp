#pragma once
// A small, quick study that the tests of this room change one member at a time.
#include <string>

#include "studies/reader/json_input.hpp"
#include "studies/reader/study_reader.hpp"

namespace ordo::tests {

inline studies::Json sample_document() {
    return studies::Json::parse(R"json({
        "study": "sample", "about": "A quick bar.", "source": ["WobbesTielen2015"],
        "scene": { "name": "bar_vibration", "law": "E(F-1)" },
        "solvers": [ { "name": "mpm" } ],
        "sweep": { "cells": [4, 8, 16], "ppc": 2, "dt": 0.01, "path": "space" },
        "measure": { "at": 0.2, "fields": ["displacement"], "norms": ["rms"] },
        "expect": [ { "order": 2, "within": 0.1, "source": "mpm, without crossing" } ]
    })json");
}

inline studies::Study study_of(const studies::Json& document) {
    return studies::study_from_text(document.dump(), "sample.json", "");
}

/// The sample with the member at `pointer` replaced by the JSON in `value`.
inline studies::Json with(const std::string& pointer, const std::string& value) {
    auto document = sample_document();
    document[studies::Json::json_pointer(pointer)] = studies::Json::parse(value);
    return document;
}

}  // namespace ordo::tests
