# Writes OUTPUT, a C++ file that defines nacre::glslFiles() from the files named in FILES, in that
# order. Run by cmake -P whenever a shader changes.
set(entries "")
foreach(file IN LISTS FILES)
    file(READ "${SHADER_DIR}/${file}" text)
    string(APPEND entries "        {\"${file}\", R\"glsl(${text})glsl\"},\n")
endforeach()
file(WRITE "${OUTPUT}" "// Made from shaders/ by lib/cmake/embed_shaders.cmake.
#include <nacre/glsl.hpp>

namespace nacre {

const std::vector<GlslFile>& glslFiles()
{
    static const std::vector<GlslFile> files{
${entries}    };
    return files;
}

}  // namespace nacre
")
