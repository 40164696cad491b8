#include "glsl_conditionals.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>

namespace nacre {
namespace {

using Macros = std::map<std::string, std::string, std::less<>>;

bool isWordCharacter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\r')) text.remove_suffix(1);
    return text;
}

// The word at the front, which is taken off.
std::string_view takeWord(std::string_view& text)
{
    text = trimmed(text);
    std::size_t length = 0;
    while (length < text.size() && isWordCharacter(text[length])) ++length;
    const std::string_view word = text.substr(0, length);
    text = trimmed(text.substr(length));
    return word;
}

// Recursive descent over what #if may say; a name without a value is 0, as in C.
class Condition {
public:
    Condition(std::string_view text, const Macros& macros) : text_(text), macros_(macros) {}
    bool holds() { return either() != 0; }

private:
    bool take(std::string_view token)
    {
        text_ = trimmed(text_);
        if (text_.substr(0, token.size()) != token) return false;
        text_.remove_prefix(token.size());
        return true;
    }
    long either()
    {
        long value = both();
        while (take("||")) value = static_cast<long>((both() != 0) | (value != 0));
        return value;
    }
    long both()
    {
        long value = comparison();
        while (take("&&")) value = static_cast<long>((comparison() != 0) & (value != 0));
        return value;
    }
    long comparison()
    {
        const long left = primary();
        if (take("==")) return static_cast<long>(left == primary());
        if (take("!=")) return static_cast<long>(left != primary());
        if (take(">=")) return static_cast<long>(left >= primary());
        if (take("<=")) return static_cast<long>(left <= primary());
        if (take(">")) return static_cast<long>(left > primary());
        if (take("<")) return static_cast<long>(left < primary());
        return left;
    }
    long primary()
    {
        if (take("!")) return static_cast<long>(primary() == 0);
        if (take("(")) {
            const long value = either();
            take(")");
            return value;
        }
        return valueOf(takeWord(text_), 8);
    }
    // Macros may name each other; a chain of eight is more than there is.
    long valueOf(std::string_view word, int depth) const
    {
        const auto macro = macros_.find(word);
        if (macro != macros_.end() && depth > 0) return valueOf(macro->second, depth - 1);
        return std::strtol(std::string(word).c_str(), nullptr, 10);
    }

    std::string_view text_;
    const Macros& macros_;
};

// Words that stand for others, GLSL's types, are put in place; numbers keep their names.
std::string withWords(std::string_view line, const Macros& words)
{
    std::string result;
    for (std::size_t at = 0; at < line.size();) {
        std::size_t end = at;
        while (end < line.size() && isWordCharacter(line[end])) ++end;
        if (end == at) {
            result += line[at++];
            continue;
        }
        const auto word = words.find(line.substr(at, end - at));
        result += word == words.end() ? line.substr(at, end - at) : std::string_view(word->second);
        at = end;
    }
    return result;
}

// How often each of the library's macros is named.
std::map<std::string_view, int> countMacros(std::string_view text)
{
    std::map<std::string_view, int> count;
    for (std::size_t at = text.find("NACRE_"); at != std::string_view::npos; at = text.find("NACRE_", at)) {
        std::size_t end = at;
        while (end < text.size() && isWordCharacter(text[end])) ++end;
        ++count[text.substr(at, end - at)];
        at = end;
    }
    return count;
}

// Numbers that only conditions asked for are named once, where they are defined.
std::string withoutIdleMacros(std::string_view text)
{
    const auto count = countMacros(text);
    const auto isIdle = [&](std::string_view line) {
        if (line.substr(0, 14) != "#define NACRE_") return false;
        line.remove_prefix(8);
        const auto macro = count.find(takeWord(line));
        return macro != count.end() && macro->second == 1;
    };
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
        if (!isIdle(text.substr(0, end))) result += text.substr(0, end);
        text = text.substr(end);
    }
    return result;
}

struct Level {
    bool isActive, wasActive, parent;
};

// One text on its way through the conditionals.
class Resolver {
public:
    std::string resolve(std::string_view text)
    {
        result_.clear();
        hasCode_ = false;
        wasBlank_ = true;
        while (!text.empty()) {
            const std::size_t end = text.find('\n');
            line(text.substr(0, end));
            text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
        }
        return hasCode_ ? result_ : std::string();
    }

private:
    bool isActive() const { return levels_.empty() || levels_.back().isActive; }

    void line(std::string_view text)
    {
        std::string_view rest = trimmed(text);
        if (!rest.empty() && rest.front() == '#') {
            rest.remove_prefix(1);
            directive(takeWord(rest), rest, text);
        } else if (isActive()) {
            const bool isBlank = trimmed(text).empty();
            const std::size_t comment = std::min(text.find("//"), text.size());
            if (!(isBlank && wasBlank_)) result_ += withWords(text.substr(0, comment), words_) + std::string(text.substr(comment)) + '\n';
            wasBlank_ = isBlank;
            hasCode_ = hasCode_ || !trimmed(text.substr(0, comment)).empty();
        }
    }

    void open(bool holds) { levels_.push_back({isActive() && holds, holds, isActive()}); }

    void directive(std::string_view name, std::string_view rest, std::string_view text)
    {
        if (name == "if") open(Condition(rest, macros_).holds());
        else if (name == "ifdef") open(macros_.count(std::string(rest)) != 0);
        else if (name == "ifndef") open(macros_.count(std::string(rest)) == 0);
        else if (name == "elif") orElse(Condition(rest, macros_).holds());
        else if (name == "else") orElse(true);
        else if (name == "endif") levels_.pop_back();
        else if (isActive()) keep(name, rest, text);
    }

    void orElse(bool holds)
    {
        Level& level = levels_.back();
        level.isActive = level.parent && !level.wasActive && holds;
        level.wasActive = level.wasActive || holds;
    }

    // A guard's #define is done with; those of nacre_channels.glsl are put in place from here on.
    void keep(std::string_view name, std::string_view rest, std::string_view text)
    {
        if (name == "define") {
            const std::string_view macro = takeWord(rest);
            macros_[std::string(macro)] = std::string(rest);
            if (rest.empty()) return;  // a guard
            if (macro.substr(0, 14) == "nacre_Channels") {
                words_[std::string(macro)] = std::string(rest);
                return;
            }
        }
        result_ += std::string(text) + '\n';
        wasBlank_ = false;
        hasCode_ = true;
    }

    Macros macros_, words_;
    std::vector<Level> levels_;
    std::string result_;
    bool wasBlank_ = true, hasCode_ = false;
};

}  // namespace

std::string withoutConditionals(const std::vector<std::string_view>& texts)
{
    Resolver resolver;
    std::string resolved;
    for (std::string_view text : texts) resolved += resolver.resolve(text);
    for (std::size_t before = 0; before != resolved.size();) {
        before = resolved.size();
        resolved = withoutIdleMacros(resolved);
    }
    return resolved;
}

}  // namespace nacre
