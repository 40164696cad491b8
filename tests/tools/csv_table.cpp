#include "csv_table.hpp"

#include <csv.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <memory>

namespace nacre::test {
namespace {

struct Cells {
    std::vector<std::vector<std::string>> rows;
    std::vector<std::string> row;
};

void endCell(void* text, std::size_t length, void* cells)
{
    static_cast<Cells*>(cells)->row.emplace_back(static_cast<const char*>(text), length);
}

void endRow(int, void* cells)
{
    auto* all = static_cast<Cells*>(cells);
    all->rows.push_back(std::move(all->row));
    all->row.clear();
}

}  // namespace

Result<CsvTable> CsvTable::read(std::istream& stream)
{
    std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    if (text.rfind("\xEF\xBB\xBF", 0) == 0) text.erase(0, 3);  // the byte-order mark that spreadsheets write
    csv_parser parser{};
    if (csv_init(&parser, 0) != 0) return Error{"CSV: out of memory"};
    const std::unique_ptr<csv_parser, decltype(&csv_free)> owner(&parser, &csv_free);

    Cells cells;
    if (csv_parse(&parser, text.data(), text.size(), endCell, endRow, &cells) != text.size()) {
        return Error{std::string("CSV: ") + csv_strerror(csv_error(&parser))};
    }
    csv_fini(&parser, endCell, endRow, &cells);
    if (cells.rows.empty()) return Error{"CSV: expected a header line, got nothing"};

    CsvTable table;
    table.columns = std::move(cells.rows.front());
    cells.rows.erase(cells.rows.begin());
    table.rows = std::move(cells.rows);
    for (const std::string& column : table.columns) {
        if (std::count(table.columns.begin(), table.columns.end(), column) > 1) return Error{"CSV: expected a column " + column + " once"};
    }
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        if (table.rows[row].size() != table.columns.size()) {
            return Error{"CSV row " + std::to_string(row + 1) + ": expected " + std::to_string(table.columns.size()) +
                         " cells, got " + std::to_string(table.rows[row].size())};
        }
    }
    return table;
}

std::size_t CsvTable::find(const std::string& column) const
{
    return static_cast<std::size_t>(std::find(columns.begin(), columns.end(), column) - columns.begin());
}

Result<double> number(const CsvTable& table, std::size_t row, std::size_t column)
{
    const std::string& cell = table.rows[row][column];
    char* end = nullptr;
    const double value = std::strtod(cell.c_str(), &end);
    const bool isWhole = !cell.empty() && end == cell.c_str() + cell.size() && std::isspace(static_cast<unsigned char>(cell.front())) == 0;
    if (!isWhole) {
        return Error{"CSV row " + std::to_string(row + 1) + ", column " + table.columns[column] + ": expected a number, got '" + cell + "'"};
    }
    return value;
}

}  // namespace nacre::test
