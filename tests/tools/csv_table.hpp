#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include <nacre/result.hpp>

namespace nacre::test {

/// A CSV file with a header line, all cells as text.
struct CsvTable {
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;

    /// Errors: no header, a row with more or fewer cells than the header.
    static Result<CsvTable> read(std::istream& stream);

    /// Index of a column; columns.size() where there is none.
    std::size_t find(const std::string& column) const;
};

/// The number that a whole cell spells, or an error that names row (from 1, the header not counted) and column.
Result<double> number(const CsvTable& table, std::size_t row, std::size_t column);

}  // namespace nacre::test
