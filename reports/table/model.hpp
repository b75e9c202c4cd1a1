#pragma once
// A table as data: made once from the report, then written as text, Markdown or LaTeX. Strings are as the user wrote
// them; each writer escapes for itself.
#include <string>
#include <vector>

#include "reports/report.hpp"

namespace ordo::reports {

/// "-" where nothing stands. The mark says how a printed value compares with ours: '=' agrees, '!' differs, ' ' not
/// judged.
struct Cell {
    std::string text = "-";
    char mark = ' ';
};

struct Column {
    std::string head;
    bool marked = false;  ///< its cells carry marks
};

/// The columns of one series under its label.
struct Group {
    std::string label;
    std::vector<Column> columns;
};

/// One refined value, with the cells of all groups from left to right.
struct Row {
    std::string place;
    std::vector<Cell> cells;
};

/// One quantity along one abscissa.
struct Table {
    std::string title;
    std::string place_head;  ///< "cells" or "dt [s]"
    std::vector<Group> groups;
    std::vector<Row> rows;
    std::vector<std::string> notes;  ///< why runs stopped, then the fits
};

struct TableModel {
    std::string study;
    std::string about;
    std::vector<Table> tables;
    std::vector<std::string> verdicts;  ///< checks, then published tables
    std::string verdict;                ///< of the whole study
};

TableModel table_model(const Report& report);

/// The table in parts to stand below one another, each about `widest` characters wide at most but with one group at
/// least. The notes stay with the whole.
std::vector<Table> panels(const Table& table, std::size_t widest);

}  // namespace ordo::reports
