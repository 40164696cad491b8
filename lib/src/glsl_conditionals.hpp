#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace nacre {

/// Texts of GLSL, one after the other, as its preprocessor leaves them: the library's switches are resolved, so what is not for a variant is gone and what
/// is reads as if written for it alone. Only the library's own macros are touched: those of a number decide #if, #elif,
/// #ifdef and #ifndef, those of a word (nacre_Channels) are put in place. The library's files need no more than integers,
/// comparisons, && || ! and parentheses. A text that is left with comments alone is left out.
std::string withoutConditionals(const std::vector<std::string_view>& texts);

}  // namespace nacre
