#include "table_text.hpp"

#include <algorithm>
#include <cstdio>

namespace nacre::bench {

std::string fixed(double value, int digits)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    return text;
}

std::string shortly(double value)
{
    return fixed(value, value < 0.0995 ? 3 : value < 0.995 ? 2 : value < 9.95 ? 1 : 0);
}

std::string row(const std::vector<std::string>& cells)
{
    std::string text = "|";
    for (const std::string& cell : cells) text += ' ' + cell + " |";
    return text + '\n';
}

std::string header(const std::vector<std::string>& cells)
{
    std::string text = row(cells) + "| --- |";
    for (std::size_t i = 1; i < cells.size(); ++i) text += " ---: |";
    return text + '\n';
}

std::string csvLine(const std::vector<std::string>& cells)
{
    std::string text;
    for (const std::string& cell : cells) text += cell + ',';
    text.back() = '\n';
    return text;
}

std::string csvName(std::string text)
{
    for (char& character : text) character = character == ',' ? ';' : character;
    return text;
}

}  // namespace nacre::bench
